#include "shapes/analytic/polynomial_entry.hpp"

#include <fmt/format.h>

namespace gridstep {

std::unique_ptr<ImplicitShape<3>> enlarged_polynomial(const std::string& formula, double factor,
                                                      const RealPoint<3>& centre,
                                                      const LeftOut<3>& left_out) {
  std::string text;
  for (const char c : formula)
    text += 'x' <= c && c <= 'z' ? fmt::format("({}/{})", c, factor) : std::string(1, c);
  // Found before it is enlarged, so that the bounds of shapes alike are alike.
  const RealBox<3> box = bounds_of<3>(Formula(formula));
  return std::make_unique<ImplicitShape<3>>(
      centre, Formula(text), RealBox<3>(factor * box.min(), factor * box.max()), false, left_out);
}

}  // namespace gridstep
