#pragma once

#include <functional>
#include <span>
#include <vector>

#include "shapes/digital/digital_set.hpp"
#include "shapes/digital/khalimsky.hpp"

namespace gridstep {

/// All surfels between a point of the set and one outside it, over all components of the boundary. Found
/// brick by brick with shifts, no walk and no hash table: order of bricks, then axis, sign, and bit. Cost
/// O(h^-(d-1)). Runs on all threads of the current arena; the result does not depend on their number.
template <int d>
std::vector<Surfel<d>> boundary(const DigitalSet<d>& set);

/// The number of surfels of boundary(), without them.
template <int d>
std::size_t boundary_size(const DigitalSet<d>& set);

/// The surfels of boundary() in the same order, never all of them at once: visit() gets one chunk after the
/// other, of whole bricks with at most `most` surfels, or one brick that alone has more, up to 1536. Chunks are
/// not empty and valid during the call. Memory O(most).
template <int d>
void for_each_boundary_chunk(const DigitalSet<d>& set, std::size_t most,
                             const std::function<void(std::span<const Surfel<d>>)>& visit);

/// How the surface is followed where two inner spels, and two outer ones, touch only across a (d-2)-cell.
/// interior: the two inner spels are not connected there; exterior: they are.
enum class SurfelAdjacency { interior, exterior };

/// The surfel of the boundary of `set` that follows `surfel` across its (d-2)-face in direction `sign` along
/// `axis`, an axis other than the surfel's own.
template <int d>
Surfel<d> adjacent_surfel(const DigitalSet<d>& set, const Surfel<d>& surfel, int axis, int sign,
                          SurfelAdjacency adjacency);

/// The boundary sorted by connected components, larger ones first (then by first surfel).
template <int d>
struct DigitalSurface {
  std::vector<Surfel<d>> surfels;
  std::vector<std::size_t> component_begin;  ///< one more than there are components; ends with surfels.size()

  std::size_t components() const { return component_begin.size() - 1; }
};

/// Within a component, the surfels of 3D surfaces keep the order of boundary(). Contours (d = 2) are in the
/// order of a walk with the set on the left: each linel ends where the next begins, and the last ends where
/// the first begins.
template <int d>
DigitalSurface<d> connected_boundary(const DigitalSet<d>& set,
                                     SurfelAdjacency adjacency = SurfelAdjacency::interior);

}  // namespace gridstep
