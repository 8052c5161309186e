#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "shapes/base/random.hpp"
#include "shapes/base/region.hpp"
#include "shapes/base/units.hpp"

namespace gridstep {

/// A rigid motion of a shape before it is digitized: x -> rotation x + h shift, the shift counted in cells.
template <int d>
struct Placement {
  RealPoint<d> shift = RealPoint<d>::Zero();
  Eigen::Matrix<double, d, d> rotation = Eigen::Matrix<double, d, d>::Identity();

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
Eigen::Matrix<double, d, d> random_rotation(RandomStream& random) {
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
  PlacedRegion(const Region<d>& region, Placement<d> placement, GridStep h)
      : region_(region), placement_(std::move(placement)), h_(h) {}

  RealBox<d> bounds() const override {
    const RealBox<d> box = region_.bounds();
    return image(box, [this](const RealPoint<d>& p) { return placement_.to_world(p, h_); });
  }
  /// The function is turned with the region, so that a rotation costs no tightness to first order.
  AffineBound<d> bound(const RealBox<d>& box) const override {
    AffineBound<d> bound =
        region_.bound(image(box, [this](const RealPoint<d>& p) { return placement_.to_shape(p, h_); }));
    bound.centre = placement_.to_world(bound.centre, h_);
    if (placement_.rotated()) bound.slope = placement_.direction_to_world(bound.slope);
    bound.error += bound.rounding(greatest_coordinate(box) + h_.value * placement_.shift.norm());
    return bound;
  }
  std::uint64_t inside(std::span<const RealPoint<d>> points) const override {
    std::array<RealPoint<d>, 64> moved;
    for (std::size_t i = 0; i < points.size(); ++i) moved[i] = placement_.to_shape(points[i], h_);
    return region_.inside({moved.data(), points.size()});
  }

 private:
  /// A box around the image of a box. A translation is monotone under rounding; a rotation is not, so its
  /// image is widened by far more than the rounding of one matrix product.
  template <class Motion>
  RealBox<d> image(const RealBox<d>& box, Motion motion) const {
    if (!placement_.rotated()) return {motion(box.min()), motion(box.max())};
    RealBox<d> result;
    double largest = 0;
    for (int c = 0; c < (1 << d); ++c) {
      const RealPoint<d> corner = box.corner(typename RealBox<d>::CornerType(c));
      largest = std::max(largest, corner.template lpNorm<Eigen::Infinity>());
      result.extend(motion(corner));
    }
    const double slack = 1e-14 * (largest + h_.value * placement_.shift.norm());
    return {result.min().array() - slack, result.max().array() + slack};
  }

  const Region<d>& region_;
  Placement<d> placement_;
  GridStep h_;
};

}  // namespace gridstep
