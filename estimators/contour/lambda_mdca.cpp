#include "estimators/contour/circular_arc.hpp"
#include "estimators/contour/contour_estimator.hpp"
#include "estimators/contour/eccentricity.hpp"

namespace gridstep {

namespace {

/// Mean curvature of the maximal digital circular arcs that contain the linel,
///   kappa(i) = sum lambda(e_k) kappa_k / sum lambda(e_k),  e_k = (i + 1/2 - first_k) / size_k.
///   Units  1/length, positive where the set is convex. At linel centres.
///   Bound  O(h^1/3) for convex shapes of positive curvature [Schindele, Massopust, Forster, Multigrid convergence
///          for the MDCA curvature estimator, arXiv 1510.00678].
///   Cost   that of maximal_arcs(), and the total size of the arcs.
/// [Roussillon & Lachaud, IWCIA 2011]
void curvature(const DigitalContour& contour, GridStep h, std::vector<std::vector<double>>& columns) {
  std::vector<double> weights(columns[0].size());
  for (const CircularArc& arc : maximal_arcs(contour))
    for (std::ptrdiff_t j = 0; j < arc.size; ++j) {
      const auto i = std::size_t((arc.begin + j) % contour.size());
      const double weight = eccentricity_weight((double(j) + 0.5) / double(arc.size));
      weights[i] += weight;
      columns[0][i] += weight * arc.curvature / h.value;
    }
  for (std::size_t i = 0; i < weights.size(); ++i) columns[0][i] /= weights[i];
}

}  // namespace

EstimatorEntry describe_lambda_mdca() {
  return contour_estimator("lambda-mdca", "curvature: weighted mean of all maximal digital circular arcs",
                           {{"kappa", std::nullopt}}, ValuePosition::surfel_centre, curvature);
}

}  // namespace gridstep
