#include "experiments/report/base64.hpp"

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

namespace gridstep {

std::string base64(std::span<const std::byte> bytes) {
  using boost::archive::iterators::base64_from_binary;
  using boost::archive::iterators::transform_width;
  using Digits = base64_from_binary<transform_width<const char*, 6, 8>>;
  // Boost reads on to a whole digit: the last bytes, short of three, come with zeros behind them.
  const std::size_t whole = bytes.size() / 3 * 3, left = bytes.size() - whole;
  const auto* data = reinterpret_cast<const char*>(bytes.data());
  std::string text(Digits(data), Digits(data + whole));
  if (left > 0) {
    char last[3] = {};
    for (std::size_t i = 0; i < left; ++i) last[i] = data[whole + i];
    std::string digits(Digits(last), Digits(last + 3));
    digits.replace(left + 1, 3 - left, 3 - left, '=');
    text += digits;
  }
  return text;
}

}  // namespace gridstep
