#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "shapes/base/contracts.hpp"
#include "shapes/base/region.hpp"
#include "shapes/base/units.hpp"

namespace gridstep {

/// A smooth point of the boundary of a shape, with the exact geometry there.
template <int d>
struct BoundaryPoint {
  RealPoint<d> position;
  RealPoint<d> normal;  ///< unit, outwards
  /// Principal curvatures in 1/length, descending, positive where the shape is convex: {kappa} in 2D, {k1,
  /// k2} in 3D.
  std::array<double, d - 1> curvature;
  /// Unit principal directions, in the order of `curvature`, signs arbitrary; in 2D the tangent, shape on its
  /// left.
  std::array<RealPoint<d>, d - 1> direction;
  double distance;  ///< from the query to `position`
  /// Largest of: distance of `position` to the boundary (to first order), and the tangential part of
  /// query - position; both relative to size(). At most 1e-12, or project() throws.
  double residual;
};

/// The analytic shape: the answer key of every experiment, never shown to an estimator.
///
/// A shape is a closed bounded region, here given around the origin and moved to `centre`. Derived classes
/// describe the centred shape in the local_* functions; all functions are const and thread-safe.
template <int d>
class Shape : public Region<d> {
 public:
  explicit Shape(const RealPoint<d>& centre) : centre_(centre) {}

  RealBox<d> bounds() const final {
    const RealBox<d> box = local_bounds();
    return {box.min() + centre_, box.max() + centre_};
  }
  void bound_each(std::span<const RealBox<d>> boxes, std::span<QuadraticBound<d>> bounds) const final {
    expects(boxes.size() <= Region<d>::kMostBoxes, "at most 8 boxes");
    std::array<RealBox<d>, Region<d>::kMostBoxes> local;
    for (std::size_t i = 0; i < boxes.size(); ++i)
      local[i] = {boxes[i].min() - centre_, boxes[i].max() - centre_};
    local_bound_each({local.data(), boxes.size()}, bounds);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      QuadraticBound<d>& bound = bounds[i];
      bound.centre += centre_;
      bound.error +=
          bound.rounding(greatest_coordinate(boxes[i]) + centre_.template lpNorm<Eigen::Infinity>());
    }
  }
  std::uint64_t inside(std::span<const RealPoint<d>> points) const final {
    expects(points.size() <= 64, "at most 64 points");
    std::array<RealPoint<d>, 64> local;
    for (std::size_t i = 0; i < points.size(); ++i) local[i] = points[i] - centre_;
    return local_inside({local.data(), points.size()});
  }

  /// The length to which residuals are relative: half the diagonal of the bounding box.
  double size() const { return local_bounds().diagonal().norm() / 2; }

  /// The boundary point closest to `query`, certified: on the boundary, query - position parallel to the
  /// normal, a local minimum of the distance (1 + s k_i > 0 at signed distance s, positive outside), at most
  /// `within` away.
  /// @return nothing where the closest point is singular (corner, edge, cusp): curvature is undefined there.
  /// @throws UncertifiedProjection where no such point is found or one of the checks fails.
  std::optional<BoundaryPoint<d>> project(const RealPoint<d>& query, EuclideanLength within) const;

  /// As project(), but a singular point is an error too.
  /// @throws InputError naming the shape and the point.
  BoundaryPoint<d> truth(const RealPoint<d>& query, EuclideanLength within) const;

 protected:
  virtual RealBox<d> local_bounds() const = 0;
  virtual QuadraticBound<d> local_bound(const RealBox<d>& box) const = 0;
  /// For shapes that find the bounds of several boxes faster than one by one.
  virtual void local_bound_each(std::span<const RealBox<d>> boxes,
                                std::span<QuadraticBound<d>> bounds) const {
    for (std::size_t i = 0; i < boxes.size(); ++i) bounds[i] = local_bound(boxes[i]);
  }
  virtual std::uint64_t local_inside(std::span<const RealPoint<d>> points) const = 0;
  /// `within` is where to search; project() checks the outcome, so an implementation need not.
  virtual std::optional<BoundaryPoint<d>> local_project(const RealPoint<d>& query, double within) const = 0;

 private:
  RealPoint<d> centre_;
};

/// The closest boundary point could not be found, or not be proved to be one.
class UncertifiedProjection : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

extern template class Shape<2>;
extern template class Shape<3>;

}  // namespace gridstep
