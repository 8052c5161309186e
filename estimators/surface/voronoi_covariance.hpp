#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "shapes/base/lattice.hpp"
#include "shapes/base/units.hpp"

namespace gridstep {

/// The covariance of the Voronoi cell of each site, cut off at the distance R [Mérigot, Ovsjanikov, Guibas, TVCG 2011;
/// on the lattice Cuel, Lachaud, Thibert, DGCI 2014]: in cells,
///   V(q) = Σ (p − q)(p − q)'  over the lattice points p whose nearest site is q, with |p − q| <= R.
/// A point with several nearest sites is shared evenly among them, so V commutes with the isometries of the lattice. It
/// does not depend on sites farther than 2R. Exact distances, block by block; cost of the points within R of the sites
/// times the lattice points at one distance, O(R). Runs on all threads of the current arena; the result does not depend
/// on their number.
/// @param sites distinct
/// @return V of each of them, in their order
std::vector<Eigen::Matrix3d> voronoi_covariances(std::span<const LatticePoint<3>> sites, DigitalLength R);

}  // namespace gridstep
