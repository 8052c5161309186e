#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "estimators/catalogue.hpp"
#include "estimators/surface/ball_walk.hpp"
#include "estimators/surface/curvature_measures.hpp"
#include "shapes/base/parallel.hpp"

namespace gridstep {

/// Curvature from the measures of a corrected normal current in a ball around the centre of a surfel, divided by its
/// area there. The surface is the digital one; the corrected normals are those of `ii-covariance` with the radius R.
///   Balls  of radius h^(1/4) (R/3)^(3/4): with R = 3 h^(1/3) that is h^(1/2), what the authors take in the DGtal
///          library's comparison of integral invariants and corrected curvature measures; in cells it is
///          (R/h/3)^(3/4), whatever the unit. Only the part of the surface that is connected to the surfel in the ball
///          counts, cells that are partly in the ball count in part: see inclusion().
///   Units  1/length (gaussian: 1/length^2), positive where the set is convex; mean and gaussian are measures of
///          their own, not made of k1 and k2. The normal is the corrected one.
///   Bound  the measures converge with the normals [Lachaud, Romon, Thibert, DCG 68, 2022]; no rate is claimed here.
///   Cost   that of `ii-covariance`, and of (R/h)^(3/2) faces each.
/// @tparam Current made from the surface and the unit normals of its faces; in_ball(face, centre, radius) gives the
///         measures, in cells, of the part in a ball of the face and of its shares of edges and vertices
template <class Current>
class CorrectedCurrentEstimator final : public Estimator<3> {
 public:
  CorrectedCurrentEstimator(const DigitalSet<3>& set, const EstimatorOptions& options)
      : set_(set), normals_(find_estimator("ii-covariance").variant<3>().make(set, options)) {}

  void init(GridStep h, EuclideanLength R) override {
    normals_->init(h, R);
    h_ = h;
    ball_ = {std::pow(to_digital(R, h).value / 3, 0.75)};
  }

  Estimates eval(std::span<const Surfel<3>> surfels) override {
    // The farthest that counts is a face around a vertex of one that the ball reaches.
    const QuadSurface surface(set_, surfels, {ball_.value + 3});
    const Current current(surface, corrected_normals(surface));
    Estimates result =
        Estimates::zeros({kSurfaceQuantities.begin(), kSurfaceQuantities.end()}, surfels.size());
    PerWorker<BallWalk> walks{BallWalk(surface)};
    parallel_chunks(surfels.size(), 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i != end; ++i) {
        const std::uint32_t face = surface.number_of(surfels[i]);
        const LatticePoint<3> centre = surfels[i].cell().coordinates;
        const double radius = 2 * ball_.value;  // half cells
        CurvatureMeasures measures;
        walks.local()(face, radius,
                      [&](std::uint32_t other) { measures += current.in_ball(other, centre, radius); });
        auto [mean, gaussian, principal] = curvature_of(measures, current.normal(face));
        const double h = h_.value;
        principal.k1 /= h;
        principal.k2 /= h;
        result.set_row(i, surface_values(mean / h, gaussian / (h * h), principal));
      }
    });
    return result;
  }

  Estimates raw() const override { return {}; }
  /// That of the normals, also of the surface around the surfels.
  EstimatorWork work() const override { return normals_->work(); }

 private:
  std::vector<Eigen::Vector3d> corrected_normals(const QuadSurface& surface) {
    const Estimates estimates = normals_->eval(surface.faces());
    const auto &x = estimates["normal_x"], &y = estimates["normal_y"], &z = estimates["normal_z"];
    std::vector<Eigen::Vector3d> normals(x.size());
    for (std::size_t f = 0; f < normals.size(); ++f) normals[f] = {x[f], y[f], z[f]};
    return normals;
  }

  const DigitalSet<3>& set_;
  std::unique_ptr<Estimator<3>> normals_;
  GridStep h_{};
  DigitalLength ball_{};
};

template <class Current>
EstimatorEntry corrected_current_estimator(std::string name, std::string summary) {
  EstimatorEntry::Variant<3> variant;
  for (const std::string quantity : kSurfaceQuantities)
    variant.quantities.push_back({quantity, std::nullopt});
  variant.make = [](const DigitalSet<3>& set, const EstimatorOptions& options) {
    return std::make_unique<CorrectedCurrentEstimator<Current>>(set, options);
  };
  return {std::move(name), std::move(summary), std::nullopt, std::move(variant)};
}

}  // namespace gridstep
