#pragma once

#include <string>

#include "shapes/analytic/catalogue.hpp"
#include "shapes/analytic/implicit_shape.hpp"

namespace gridstep {

/// The catalogue line of a surface {formula <= 0} without parameters, its bounds found from the formula.
inline ShapeEntry polynomial_entry(const std::string& name, const std::string& formula,
                                   const std::string& remark = "") {
  return {name,
          formula + " <= 0" + remark,
          {},
          ShapeFactory<3>([formula](const ParameterValues&, const RealPoint<3>& centre) {
            Formula parsed(formula);
            const RealBox<3> box = bounds_of<3>(parsed);
            return std::make_unique<ImplicitShape<3>>(centre, std::move(parsed), box);
          })};
}

/// {formula <= 0}, enlarged by a factor. The formula has no letters but x, y, z.
std::unique_ptr<ImplicitShape<3>> enlarged_polynomial(const std::string& formula, double factor,
                                                      const RealPoint<3>& centre,
                                                      const LeftOut<3>& left_out = {});

}  // namespace gridstep
