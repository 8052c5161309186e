#pragma once

#include <cstdint>
#include <span>

#include "shapes/analytic/formula.hpp"
#include "shapes/base/taylor_model.hpp"

namespace gridstep {

/// A formula at many places at once, by the widest vector instructions that the processor has: equal to what the
/// formula itself gives place by place.

/// Where the value is at most 0: bit i belongs to points[i].
/// @param points at most 64
template <int d>
std::uint64_t at_most_zero(const Formula& formula, std::span<const RealPoint<d>> points);

/// The models over some boxes: formula(TaylorModel<d>::variables(box)) of each.
/// @param models as many as there are boxes
template <int d>
void models_over(const Formula& formula, std::span<const RealBox<d>> boxes, std::span<TaylorModel<d>> models);

extern template std::uint64_t at_most_zero(const Formula&, std::span<const RealPoint<2>>);
extern template std::uint64_t at_most_zero(const Formula&, std::span<const RealPoint<3>>);
extern template void models_over(const Formula&, std::span<const RealBox<2>>, std::span<TaylorModel<2>>);
extern template void models_over(const Formula&, std::span<const RealBox<3>>, std::span<TaylorModel<3>>);

}  // namespace gridstep
