#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "shapes/base/units.hpp"
#include "shapes/digital/digital_set.hpp"
#include "shapes/digital/khalimsky.hpp"

namespace gridstep {

/// The digital surface near some surfels as a closed mesh: its faces are surfels, squares between pointels, and
/// each edge joins two of them, by interior adjacency. A vertex is a pointel with one closed ring of faces; where
/// two sheets of the surface touch at a pointel, there are two.
///
/// What an estimator needs around its surfels it finds here, in the digital set alone: so its values do not
/// depend on which surfels are evaluated together. Memory some 60 bytes a face, cost O(n log n), and a scan of the
/// whole boundary for those nearby.
class QuadSurface {
 public:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  /// All faces within `reach` of the surfels in each direction, and more: whole bricks.
  QuadSurface(const DigitalSet<3>& set, std::span<const Surfel<3>> surfels, DigitalLength reach);

  const std::vector<Surfel<3>>& faces() const { return faces_; }
  std::size_t vertex_count() const { return vertex_count_; }

  /// The number of a surfel among faces(). @throws ContractViolation where it is not among them.
  std::uint32_t number_of(const Surfel<3>& surfel) const;
  /// The face behind each edge; edge i leads from corner i, in the order of corners(), to the next. kNone where that
  /// face was not taken.
  const std::array<std::uint32_t, 4>& neighbours(std::uint32_t face) const { return neighbours_[face]; }
  /// The vertex at each corner: all of 0 to vertex_count() - 1 occur. Its ring is whole where no neighbour around it is
  /// kNone.
  const std::array<std::uint32_t, 4>& vertices(std::uint32_t face) const { return vertices_[face]; }
  /// The faces around the corner of a face, clockwise seen from outside, that face first.
  void ring(std::uint32_t face, int corner, std::vector<std::uint32_t>& result) const;

 private:
  std::uint32_t find(const Surfel<3>& surfel) const;

  std::vector<Surfel<3>> faces_;  // in the raster order of their cells
  std::vector<std::array<std::uint32_t, 4>> neighbours_, vertices_;
  std::size_t vertex_count_ = 0;
};

}  // namespace gridstep
