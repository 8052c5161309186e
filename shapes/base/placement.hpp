#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "shapes/base/contracts.hpp"
#include "shapes/base/random.hpp"
#include "shapes/base/region.hpp"
#include "shapes/base/units.hpp"

namespace gridstep {

/// A rigid motion of a shape before it is digitized: x -> rotation x + h shift, the shift counted in cells.
template <int d>
struct Placement {
  RealPoint<d> shift = RealPoint<d>::Zero();
  RealMatrix<d> rotation = RealMatrix<d>::Identity();

  bool rotated() const { return !rotation.isIdentity(0.0); }

  RealPoint<d> to_shape(const RealPoint<d>& p, GridStep h) const {
    const RealPoint<d> q = p - h.value * shift;
    if (!rotated()) return q;
    return rotation.transpose() * q;
  }
  RealPoint<d> to_world(const RealPoint<d>& q, GridStep h) const {
    if (!rotated()) return q + h.value * shift;
    return rotation * q + h.value * shift;
  }
  RealPoint<d> direction_to_world(const RealPoint<d>& v) const { return rotation * v; }
};

/// Uniform in one cell, [-1/2, 1/2)^d: by periodicity of the grid every sub-grid position is equally likely.
template <int d>
RealPoint<d> random_shift(RandomStream& random) {
  RealPoint<d> shift;
  for (int k = 0; k < d; ++k) shift[k] = random.uniform() - 0.5;
  return shift;
}

/// Uniform over all rotations: a uniform angle in 2D, a uniform unit quaternion in 3D [Shoemake, Graphics
/// Gems III].
template <int d>
RealMatrix<d> random_rotation(RandomStream& random) {
  if constexpr (d == 2) {
    return Eigen::Rotation2Dd(2 * std::numbers::pi * random.uniform()).toRotationMatrix();
  } else {
    const double u = random.uniform();
    const double a = 2 * std::numbers::pi * random.uniform(), b = 2 * std::numbers::pi * random.uniform();
    return Eigen::Quaterniond(std::sqrt(u) * std::cos(b), std::sqrt(1 - u) * std::sin(a),
                              std::sqrt(1 - u) * std::cos(a), std::sqrt(u) * std::sin(b))
        .toRotationMatrix();
  }
}

/// A region under a placement; keeps a reference to the region.
template <int d>
class PlacedRegion final : public Region<d> {
 public:
  PlacedRegion(const Region<d>& region, const Placement<d>& placement, GridStep h)
      : region_(region),
        shift_(h.value * placement.shift),
        rotation_(placement.rotation),
        rotated_(placement.rotated()) {}

  RealBox<d> bounds() const override {
    const RealBox<d> box = region_.bounds();
    if (!rotated_) return {box.min() + shift_, box.max() + shift_};
    return turned(box, rotation_, RealPoint<d>::Zero(), shift_);
  }
  /// The functions are turned with the region, so that a rotation costs no tightness to second order.
  void bound_each(std::span<const RealBox<d>> boxes, std::span<QuadraticBound<d>> bounds) const override {
    expects(boxes.size() <= Region<d>::kMostBoxes, "at most 8 boxes");
    std::array<RealBox<d>, Region<d>::kMostBoxes> moved;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (rotated_)
        moved[i] = turned(boxes[i], rotation_.transpose(), shift_, RealPoint<d>::Zero());
      else
        moved[i] = {boxes[i].min() - shift_, boxes[i].max() - shift_};
    }
    region_.bound_each({moved.data(), boxes.size()}, bounds);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      QuadraticBound<d>& bound = bounds[i];
      if (rotated_) {
        bound.centre = rotation_ * bound.centre;
        bound.slope = rotation_ * bound.slope;
        bound.bend = rotation_ * bound.bend * rotation_.transpose();
      }
      bound.centre += shift_;
      bound.error += bound.rounding(greatest_coordinate(boxes[i]) + shift_.norm());
    }
  }
  /// At Placement::to_shape() of the points, bit for bit.
  std::uint64_t inside(std::span<const RealPoint<d>> points) const override {
    expects(points.size() <= 64, "at most 64 points");
    std::array<RealPoint<d>, 64> moved;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const RealPoint<d> q = points[i] - shift_;
      if (rotated_)
        moved[i] = rotation_.transpose() * q;
      else
        moved[i] = q;
    }
    return region_.inside({moved.data(), points.size()});
  }

 private:
  /// A box around the image of a box under x -> matrix (x - before) + after. A rotation is not monotone under
  /// rounding: the image is widened by far more than the rounding of a matrix product.
  static RealBox<d> turned(const RealBox<d>& box, const RealMatrix<d>& matrix, const RealPoint<d>& before,
                           const RealPoint<d>& after) {
    const RealPoint<d> image = matrix * (box.center() - before) + after;
    const double slack =
        1e-14 * (greatest_coordinate(box) + before.template lpNorm<1>() + after.template lpNorm<1>());
    const RealPoint<d> reach = (matrix.cwiseAbs() * (box.sizes() / 2)).array() + slack;
    return {image - reach, image + reach};
  }

  const Region<d>& region_;
  RealPoint<d> shift_;
  RealMatrix<d> rotation_;
  bool rotated_;
};

}  // namespace gridstep
