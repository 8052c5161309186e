#include "experiments/core/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/core/terminal.hpp"
#include "experiments/core/text.hpp"
#include "shapes/base/contracts.hpp"

namespace gridstep {

Progress::Progress(double total, std::FILE* stream)
    : stream_(stream), terminal_(can_redraw(stream)), total_(total), start_(Clock::now()), last_(start_) {
  expects(total > 0 && std::isfinite(total), "a positive, finite amount of work");
}

Progress::~Progress() {
  if (!terminal_ || drawn_width_ == 0) return;
  draw(std::chrono::duration<double>(Clock::now() - start_).count(), last_what_);
  std::fputc('\n', stream_);
  std::fflush(stream_);
}

void Progress::advance(double work, std::string_view what) {
  const std::lock_guard lock(mutex_);
  done_ = std::min(done_ + work, total_);
  last_what_ = what;
  const Clock::time_point now = Clock::now();
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const double since_last = std::chrono::duration<double>(now - last_).count();
  if (terminal_) {
    if (drawn_width_ > 0 && since_last < 0.1) return;
    draw(elapsed, what);
  } else {
    const double share = done_ / total_;
    // Shares are sums of rounded parts: ten tenths must give ten lines.
    if (share - last_share_ < 0.1 - 1e-9 && since_last < 10) return;
    fmt::print(stream_, "{}\n", status(elapsed, what, 0));
    std::fflush(stream_);
    last_share_ = share;
  }
  last_ = now;
}

std::string Progress::status(double elapsed, std::string_view what, std::size_t bar_width) const {
  const double share = done_ / total_;
  std::string text;
  if (bar_width > 0) {
    const std::size_t full = std::size_t(share * double(bar_width));
    text = fmt::format("[{:#>{}}{:.>{}}] ", "", full, "", bar_width - full);
  }
  text += fmt::format("{:3}% ", int(std::floor(100 * share + 1e-9)));
  text += format_seconds(elapsed);
  if (done_ > 0 && done_ < total_)
    text += ", " + format_seconds(elapsed * (total_ - done_) / done_) + " left";
  return fmt::format("{}: {}", text, what);
}

void Progress::draw(double elapsed, std::string_view what) {
  const std::size_t width = line_width(stream_).value_or(79);
  const std::string text = status(elapsed, what, width >= 60 ? 20 : 0);
  const std::string_view shown = cut_to_width(text, width);
  const std::size_t shown_width = display_width(shown);
  const std::size_t stale = std::min(drawn_width_, width) - std::min({drawn_width_, width, shown_width});
  fmt::print(stream_, "\r{}{:{}}", shown, "", stale);
  std::fflush(stream_);
  drawn_width_ = shown_width;
}

}  // namespace gridstep
