#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "shapes/base/lattice.hpp"
#include "shapes/base/units.hpp"

namespace gridstep {

/// Offsets with weights, grouped by weight: sum of f over them = sum over groups of weight * (sum of f in the
/// group). The ball has one group of weight 1; the masks of the ball have two, +1 (gained) and -1 (lost).
template <int d, class Weight>
struct WeightedOffsets {
  struct Group {
    Weight weight;
    std::size_t begin, end;
  };
  std::vector<LatticePoint<d>> offsets;
  std::vector<Group> groups;  ///< ascending weights, none zero; offsets of a group in raster order

  std::size_t size() const { return offsets.size(); }
};

/// A kernel functor g sampled on the lattice around an evaluation point, which is the origin.
template <int d, class Weight>
using Kernel = WeightedOffsets<d, Weight>;

/// floor((2 R/h)^2): the integer that squared distances, in half cells, are compared with. A radius within
/// 1e-12 (relative) of one that a lattice point attains is taken to attain it, so that R/h = 0.3/0.1 is 3.
/// @throws InputError where R/h < 1, is not finite, or is above 10^9.
std::int64_t squared_diameter(DigitalLength radius);

/// The digital ball {z : |z - c| <= R/h}, closed, weight 1; c = 0, or the centre of a surfel orthogonal to
/// `half_axis`, half a cell up that axis. Distances are compared by squared_diameter().
/// @throws InputError where R/h < 1, is not finite, or the ball's box would hold more than 2^31 cells.
template <int d>
Kernel<d, std::int64_t> ball_kernel(DigitalLength radius, int half_axis = -1);

/// Any kernel functor: weight(z) at every z with |z| <= radius; zeros are left out.
template <int d, class WeightOf>
auto weighted_kernel(DigitalLength radius, WeightOf weight) -> Kernel<d, decltype(weight(LatticePoint<d>()))>;

/// Groups (offset, weight) pairs; the order of the input does not matter.
template <int d, class Weight>
WeightedOffsets<d, Weight> group_by_weight(std::vector<std::pair<LatticePoint<d>, Weight>> entries);

/// Displacement masks [Coeurjolly, Lachaud, Levallois, CVIU 2014, section 4]: for a step e between 0-adjacent
/// spels,
///   sum at s + e = sum at s + sum over the mask of delta * f(s + e + offset),
/// delta(p) = g(p) - g(p + e). For the ball these are the crescents gained and lost: O((R/h)^(d-1)) offsets.
template <int d, class Weight>
class DisplacementMasks {
 public:
  static constexpr int kCount = d == 2 ? 8 : 26;

  explicit DisplacementMasks(const Kernel<d, Weight>& kernel);

  /// The mask of a step; coordinates in -1..1, not all zero.
  const WeightedOffsets<d, Weight>& operator[](const LatticePoint<d>& step) const {
    return masks_[number(step)];
  }

  /// Number of a step among the 3^d, the null step included.
  static std::size_t number(const LatticePoint<d>& step) {
    std::size_t result = 0;
    for (int k = d - 1; k >= 0; --k) result = 3 * result + std::size_t(step[k] + 1);
    return result;
  }
  /// All steps between 0-adjacent spels: those along one axis first, since their masks are the smallest.
  static const std::array<LatticePoint<d>, kCount>& steps();

 private:
  std::array<WeightedOffsets<d, Weight>, kCount + 1> masks_;
};

}  // namespace gridstep

#include "estimators/integral_invariant/kernel.ipp"
