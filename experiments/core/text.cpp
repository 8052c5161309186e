#include "experiments/core/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace gridstep {

namespace {

bool starts_code_point(char byte) {
  return (static_cast<unsigned char>(byte) & 0xc0) != 0x80;
}

}  // namespace

std::size_t display_width(std::string_view text) {
  return std::size_t(std::count_if(text.begin(), text.end(), starts_code_point));
}

std::string_view cut_to_width(std::string_view text, std::size_t width) {
  std::size_t end = 0, taken = 0;
  for (; end < text.size(); ++end)
    if (starts_code_point(text[end]) && taken++ == width) break;
  return text.substr(0, end);
}

std::string format_error(double error) {
  // fmt's alternate form differs between versions.
  char digits[32];
  std::snprintf(digits, sizeof digits, "%#.4g", error);
  std::string text = digits;
  if (text.ends_with('.')) text.pop_back();
  return text;
}

std::string format_slope(double slope) {
  return fmt::format("{:.3f}", slope);
}

std::string format_interval(const Interval& interval) {
  if (!std::isfinite(interval.width())) return "-";
  return fmt::format("[{:.3f}, {:.3f}]", interval.lower, interval.upper);
}

std::string format_seconds(double seconds) {
  if (seconds < 0.9995) return fmt::format("{:.3g} ms", 1000 * seconds);
  if (seconds < 59.95) return fmt::format("{:.3g} s", seconds);
  const long long whole = std::llround(seconds);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

}  // namespace gridstep
