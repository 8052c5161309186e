#include <cmath>
#include <numbers>

#include "estimators/contour/contour_estimator.hpp"
#include "estimators/contour/eccentricity.hpp"
#include "estimators/contour/tangential_cover.hpp"

namespace gridstep {

namespace {

/// Angle from the x or y axis, positive or negative, that starts the quadrant of (b, a), in [0, pi/2).
double angle_in_quadrant(const DigitalLine& line) {
  const double b = double(std::abs(line.b)), a = double(std::abs(line.a));
  return (line.b > 0) == (line.a > 0) ? std::atan2(a, b) : std::atan2(b, a);
}

/// Tangent: the mean angle of the maximal segments that contain the linel,
///   theta = sum lambda(e_k) theta_k / sum lambda(e_k),  e_k = (i + 1/2 - first_k) / (last_k - first_k),
/// lambda being eccentricity_weight(). Smooth along the contour where mst jumps.
///   Units  a unit vector, walking with the set on the left. At linel centres.
///   Bound  of the mean error, O(h^1/3) for convex shapes with C^3 boundary; of the sup error none is proven.
///   Cost   O(total length of the maximal segments), 3 to 4 times the linels of smooth shapes.
/// [Lachaud, Vialard & de Vieilleville, IVC 2007]
void tangent(const DigitalContour& contour, GridStep, std::vector<std::vector<double>>& columns) {
  const TangentialCover cover(contour);
  const std::vector<CyclicRange> segments = cover.segments_of_linels();
  std::vector<double> angles;
  angles.reserve(std::size_t(cover.size()));
  for (std::ptrdiff_t k = 0; k < cover.size(); ++k) angles.push_back(angle_in_quadrant(cover[k].line));

  for (std::ptrdiff_t i = 0; i < contour.size(); ++i) {
    const LatticePoint<2> step = contour.step(i);
    double weights = 0, sum = 0;
    const auto [begin, end] = segments[std::size_t(i)];
    for (std::ptrdiff_t k = begin; k < end; ++k) {
      const MaximalSegment segment = cover[k];
      const double weight =
          eccentricity_weight((double(i - segment.first) + 0.5) / double(segment.last - segment.first));
      // A segment's linels have the two directions of its quadrant. Angles from the step need no unwrapping.
      const bool step_starts_quadrant = step[0] * segment.line.a - step[1] * segment.line.b > 0;
      const double angle = angles[std::size_t(k < 0 ? k + cover.size() : k)];
      weights += weight;
      sum += weight * (step_starts_quadrant ? angle : angle - std::numbers::pi / 2);
    }
    const double c = std::cos(sum / weights), s = std::sin(sum / weights);
    columns[0][std::size_t(i)] = step[0] * c - step[1] * s;
    columns[1][std::size_t(i)] = step[1] * c + step[0] * s;
  }
}

}  // namespace

EstimatorEntry describe_lambda_mst() {
  return contour_estimator("lambda-mst", "tangent: weighted mean of all maximal digital straight segments",
                           {{"tangent_x", std::nullopt}, {"tangent_y", std::nullopt}},
                           ValuePosition::surfel_centre, tangent);
}

}  // namespace gridstep
