#pragma once

#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "estimators/integral_invariant/kernel.hpp"
#include "estimators/integral_invariant/sums.hpp"
#include "estimators/integral_invariant/window.hpp"

namespace gridstep {

/// What an evaluation did: deterministic, whatever the number of threads.
struct EvaluationWork {
  std::int64_t points = 0;         ///< evaluation points
  std::int64_t cells_visited = 0;  ///< values of f that were read through the kernel or a mask
  std::int64_t restarts = 0;       ///< whole-kernel evaluations by `masks`
};

/// The general integral invariant: at each point x of `points`, the Sum of f(x + p) g(p) over the kernel's
/// offsets p.
///
/// f is any shape functor that can fill a dense window: f.fill(box, values) writes f over the box in raster
/// order, as ShapeFunctor::Value (std::uint8_t for a digital set, a grey value, a real). g is the kernel's
/// weight. Sum is PlainSum or MomentSums over a type that holds the products (std::int64_t for integers), or a type of
/// the same form: add() takes the points of a group of equal weights, merge() the group with its weight.
///
/// Without masks, by the whole kernel at every point; with them, incrementally (see Evaluation). Points are
/// taken block by block; a block's window is filled once. Within a block, `masks` walks a spanning tree of
/// 0-adjacency from parent to child, along steps with few cells first: one restart for each connected piece
/// in a block. Runs on all threads of the current arena. out[i] belongs to points[i]; points need not be
/// sorted, but distinct.
template <class Sum, int d, class ShapeFunctor, class Weight>
std::vector<Sum> convolve(const ShapeFunctor& f, const Kernel<d, Weight>& kernel,
                          const std::type_identity_t<DisplacementMasks<d, Weight>>* masks,
                          std::span<const std::type_identity_t<LatticePoint<d>>> points,
                          EvaluationWork* work = nullptr);

}  // namespace gridstep

#include "estimators/integral_invariant/convolution.ipp"
