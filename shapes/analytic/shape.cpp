#include "shapes/analytic/shape.hpp"

#include <fmt/format.h>

#include <cmath>

namespace gridstep {

namespace {

constexpr double kResidualBound = 1e-12;

template <int d>
std::string text(const RealPoint<d>& p) {
  std::string result = fmt::format("({:.17g}", p[0]);
  for (int k = 1; k < d; ++k) result += fmt::format(", {:.17g}", p[k]);
  return result + ")";
}

}  // namespace

template <int d>
std::optional<BoundaryPoint<d>> Shape<d>::project(const RealPoint<d>& query, EuclideanLength within) const {
  std::optional<BoundaryPoint<d>> foot = local_project(query - centre_, within.value);
  if (!foot) return foot;
  foot->position += centre_;

  const auto fail = [&](const std::string& why) {
    throw UncertifiedProjection(fmt::format("closest boundary point of {}: {}", text<d>(query), why));
  };
  // Written so that a NaN fails every check.
  if (!(foot->residual <= kResidualBound)) fail(fmt::format("relative residual {:.3g}", foot->residual));
  if (!(foot->distance <= within.value * (1 + 1e-12)))
    fail(fmt::format("distance {:.17g} exceeds {:.17g}", foot->distance, within.value));
  const double signed_distance = (query - foot->position).dot(foot->normal);
  for (const double k : foot->curvature) {
    if (!std::isfinite(k)) fail("curvature is not finite");
    if (!(1 + signed_distance * k >= -1e-9)) fail("a critical point of the distance, but not a minimum");
  }
  return foot;
}

template <int d>
BoundaryPoint<d> Shape<d>::truth(const RealPoint<d>& query, EuclideanLength within) const {
  if (const auto foot = project(query, within)) return *foot;
  throw InputError("curvature is undefined at the boundary point closest to " + text<d>(query) +
                   ": a corner, an edge or a singular point");
}

template class Shape<2>;
template class Shape<3>;

}  // namespace gridstep
