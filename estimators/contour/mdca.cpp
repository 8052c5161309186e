#include "estimators/contour/circular_arc.hpp"
#include "estimators/contour/contour_estimator.hpp"

namespace gridstep {

namespace {

/// Curvature of the circle of the most centred maximal digital circular arc: for the pointel at which linel i
/// starts the arc, of linels first to last, with the largest min(i - first, last + 1 - i); a tie is for the earlier
/// arc. Where the whole contour is one arc, its circle is taken everywhere.
///   Units     1/length, positive where the set is convex, 0 where a line separates.
///   Position  the starting pointel. The DGtal library, whose values these are, gives them to the linel.
///   Bound     O(h^1/3) in the sup norm under a hypothesis on the length of the arcs that is not proven.
///   Cost      that of maximal_arcs().
/// [Roussillon & Lachaud, IWCIA 2011]
void curvature(const DigitalContour& contour, GridStep h, std::vector<std::vector<double>>& columns) {
  const std::vector<CircularArc> arcs = maximal_arcs(contour);
  const std::ptrdiff_t n = contour.size();
  const auto m = std::ptrdiff_t(arcs.size());
  const auto begin_of = [&](std::ptrdiff_t k) { return arcs[std::size_t(k % m)].begin + (k >= m ? n : 0); };
  const auto last_of = [&](std::ptrdiff_t k) { return begin_of(k) + arcs[std::size_t(k % m)].size - 1; };
  if (m == 1) {
    columns[0].assign(std::size_t(n), arcs[0].curvature / h.value);
    return;
  }
  // Of two consecutive arcs the earlier one is for linels i with last + 1 - i >= i - (next first).
  std::ptrdiff_t i = (last_of(m - 1) + 1 + begin_of(m)) / 2 + 1 - n;
  for (std::ptrdiff_t k = 0; k < m; ++k)
    for (const std::ptrdiff_t end = (last_of(k) + 1 + begin_of(k + 1)) / 2 + 1; i < end; ++i)
      columns[0][std::size_t((i + n) % n)] = arcs[std::size_t(k)].curvature / h.value;
}

}  // namespace

EstimatorEntry describe_mdca() {
  return contour_estimator("mdca", "curvature of the most centred maximal digital circular arc",
                           {{"kappa", std::nullopt}}, ValuePosition::start_pointel, curvature);
}

}  // namespace gridstep
