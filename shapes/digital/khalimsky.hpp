#pragma once

#include <vector>

#include "shapes/base/contracts.hpp"
#include "shapes/base/lattice.hpp"

namespace gridstep {

/// A cell of Z^d in Khalimsky coordinates: in each direction odd = open, even = closed. The spel of the
/// digital point z has coordinates 2z+1, the pointel at its lower corner 2z.
template <int d>
struct Cell {
  LatticePoint<d> coordinates;

  bool open(int axis) const { return (coordinates[axis] & 1) != 0; }
  int dimension() const {
    int open_directions = 0;
    for (int k = 0; k < d; ++k) open_directions += open(k);
    return open_directions;
  }
  friend bool operator==(const Cell& a, const Cell& b) { return a.coordinates == b.coordinates; }
};

/// A cell with an orientation, +1 or -1.
template <int d>
struct SignedCell {
  Cell<d> cell;
  int sign = +1;

  SignedCell opposite() const { return {cell, -sign}; }
  friend bool operator==(const SignedCell& a, const SignedCell& b) {
    return a.cell == b.cell && a.sign == b.sign;
  }
};

template <int d>
Cell<d> spel(const LatticePoint<d>& z) {
  return {2 * z.array() + 1};
}

template <int d>
Cell<d> pointel(const LatticePoint<d>& z) {
  return {2 * z};
}

/// The digital point of a spel, or the lowest digital point whose spel has the cell in its closure or
/// interior.
template <int d>
LatticePoint<d> digital_point(const Cell<d>& cell) {
  LatticePoint<d> z;
  for (int k = 0; k < d; ++k) z[k] = cell.coordinates[k] >> 1;  // floor, also for negative coordinates
  return z;
}

/// The centre of a cell, h (coordinates - 1) / 2: the spel of z is centred at h z.
template <int d>
RealPoint<d> centre(const Cell<d>& cell, double h) {
  return h * ((cell.coordinates.template cast<double>().array() - 1) / 2).matrix();
}

/// The neighbour of the same dimension, one cell up (direction +1) or down (-1) along an axis.
template <int d>
Cell<d> adjacent(Cell<d> cell, int axis, int direction) {
  cell.coordinates[axis] += 2 * direction;
  return cell;
}

/// The incident cell one step along an axis: a face where the cell is open there, a coface where it is
/// closed.
template <int d>
Cell<d> incident(Cell<d> cell, int axis, int direction) {
  cell.coordinates[axis] += direction;
  return cell;
}

namespace detail {

template <int d>
std::vector<Cell<d>> incident_cells(const Cell<d>& cell, bool along_open) {
  std::vector<Cell<d>> cells;
  for (int axis = 0; axis < d; ++axis)
    if (cell.open(axis) == along_open)
      for (const int direction : {-1, +1}) cells.push_back(incident(cell, axis, direction));
  return cells;
}

template <int d>
std::vector<Cell<d>> closure_cells(const Cell<d>& cell, bool along_open) {
  std::vector<Cell<d>> cells{cell};
  for (int axis = 0; axis < d; ++axis) {
    if (cell.open(axis) != along_open) continue;
    for (std::size_t i = 0, n = cells.size(); i < n; ++i)
      for (const int direction : {-1, +1}) cells.push_back(incident(cells[i], axis, direction));
  }
  cells.erase(cells.begin());
  return cells;
}

}  // namespace detail

/// The faces of one dimension less: two for each open direction, axis by axis, lower first.
template <int d>
std::vector<Cell<d>> direct_faces(const Cell<d>& cell) {
  return detail::incident_cells(cell, true);
}

/// The cofaces of one dimension more: two for each closed direction, axis by axis, lower first.
template <int d>
std::vector<Cell<d>> direct_cofaces(const Cell<d>& cell) {
  return detail::incident_cells(cell, false);
}

/// All cells of smaller dimension in the closure of the cell: 3^dimension - 1 of them.
template <int d>
std::vector<Cell<d>> faces(const Cell<d>& cell) {
  return detail::closure_cells(cell, true);
}

/// All cells of larger dimension that have the cell in their closure: 3^(d - dimension) - 1 of them.
template <int d>
std::vector<Cell<d>> cofaces(const Cell<d>& cell) {
  return detail::closure_cells(cell, false);
}

/// The incident cell with the sign that makes the boundary of a boundary vanish:
/// sign * direction * (-1)^(open directions before `axis`).
template <int d>
SignedCell<d> signed_incident(const SignedCell<d>& s, int axis, int direction) {
  int sign = s.sign * direction;
  for (int k = 0; k < axis; ++k)
    if (s.cell.open(k)) sign = -sign;
  return {incident(s.cell, axis, direction), sign};
}

/// The boundary of a signed cell: its direct faces with their incidence signs.
template <int d>
std::vector<SignedCell<d>> boundary(const SignedCell<d>& s) {
  std::vector<SignedCell<d>> cells;
  for (int axis = 0; axis < d; ++axis)
    if (s.cell.open(axis))
      for (const int direction : {-1, +1}) cells.push_back(signed_incident(s, axis, direction));
  return cells;
}

/// Digital points are r-adjacent when they differ by at most 1 in each direction and in at most d - r
/// directions: in 3D r = 2, 1, 0 is 6-, 18-, 26-adjacency, that of spels sharing an r-cell or more.
template <int d>
bool adjacent_spels(const LatticePoint<d>& a, const LatticePoint<d>& b, int r) {
  const LatticePoint<d> difference = (a - b).cwiseAbs();
  return difference.maxCoeff() == 1 && difference.sum() <= d - r;
}

/// A surfel: the (d-1)-cell between an inner spel and the outer spel inner + sign e_axis.
template <int d>
struct Surfel {
  LatticePoint<d> inner;
  std::int8_t axis;
  std::int8_t sign;

  LatticePoint<d> outer() const {
    LatticePoint<d> z;
    // Not z[axis] += sign, which would send the point through memory.
    for (int k = 0; k < d; ++k) z[k] = inner[k] + (k == axis ? sign : 0);
    return z;
  }
  /// Khalimsky coordinates: even along `axis` only.
  Cell<d> cell() const { return incident(spel<d>(inner), axis, sign); }
  /// As a face of its inner spel: the sum over a set's spels of their boundaries is the set's boundary.
  SignedCell<d> signed_cell() const { return signed_incident<d>({spel<d>(inner), +1}, axis, sign); }
  /// The outward trivial normal.
  RealPoint<d> normal() const {
    RealPoint<d> n = RealPoint<d>::Zero();
    n[axis] = sign;
    return n;
  }
  friend bool operator==(const Surfel& a, const Surfel& b) {
    return a.inner == b.inner && a.axis == b.axis && a.sign == b.sign;
  }
};

/// Half-way between the inner and the outer digital point, in the unit of the shape.
template <int d>
RealPoint<d> centre(const Surfel<d>& surfel, double h) {
  return centre(surfel.cell(), h);
}

}  // namespace gridstep
