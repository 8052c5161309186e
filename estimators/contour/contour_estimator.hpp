#pragma once

#include <string>
#include <vector>

#include "estimators/catalogue.hpp"
#include "estimators/contour/digital_contour.hpp"

namespace gridstep {

/// Writes columns[q][i], quantity q at linel i or at its starting pointel, for a contour at grid step h. The
/// columns have the contour's size.
using ContourFunction = void (*)(const DigitalContour& contour, GridStep h,
                                 std::vector<std::vector<double>>& columns);

/// The entry of a 2D estimator that looks at each closed contour by itself, and takes no radius. Its eval()
/// takes whole contours and evaluates them in order; EstimatorWork::evaluations counts linels.
EstimatorEntry contour_estimator(std::string name, std::string summary, std::vector<Quantity> quantities,
                                 ValuePosition position, ContourFunction function);

}  // namespace gridstep
