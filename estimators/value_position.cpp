#include "estimators/value_position.hpp"

#include "estimators/contour/digital_contour.hpp"

namespace gridstep {

template <int d>
std::vector<RealPoint<d>> value_points(ValuePosition position, std::span<const Surfel<d>> surfels,
                                       GridStep h) {
  expects(d == 2 || position == ValuePosition::surfel_centre, "a position that exists in 3D");
  std::vector<RealPoint<d>> points;
  points.reserve(surfels.size());
  for (const Surfel<d>& surfel : surfels) {
    if constexpr (d == 2)
      if (position == ValuePosition::start_pointel) {
        points.push_back(centre(pointel<2>(start_pointel(surfel)), h.value));
        continue;
      }
    points.push_back(centre(surfel, h.value));
  }
  return points;
}

template std::vector<RealPoint<2>> value_points(ValuePosition, std::span<const Surfel<2>>, GridStep);
template std::vector<RealPoint<3>> value_points(ValuePosition, std::span<const Surfel<3>>, GridStep);

}  // namespace gridstep
