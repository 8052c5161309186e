#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "experiments/core/slope.hpp"

namespace gridstep {

/// Columns of a terminal that UTF-8 text takes, at one a code point: enough for the symbols used here (κ, ±,
/// √).
std::size_t display_width(std::string_view text);

/// The longest beginning of the text, in whole code points, that is no wider than `width`.
std::string_view cut_to_width(std::string_view text, std::size_t width);

/// Four significant digits, trailing zeros included: 0.01230, 12.35, 1.235e-05.
std::string format_error(double error);

/// Three decimals: 0.333.
std::string format_slope(double slope);

/// "[0.310, 0.352]", or "-" where there is none.
std::string format_interval(const Interval& interval);

/// 45.2 ms, 3.21 s, 4 min 05 s, 2 h 03 min.
std::string format_seconds(double seconds);

}  // namespace gridstep
