#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shapes/digital/digital_set.hpp"

namespace gridstep {

/// Places on lines, line by line.
class Ends {
 public:
  /// Empties it, for that many lines.
  void reset(std::size_t lines);
  void add(std::size_t line, std::int32_t place) { unsorted_.push_back({std::uint32_t(line), place}); }
  /// To be called between the last add() and the first on().
  void sort();

  /// Those on the lines from `first` on, `last` excluded.
  std::span<const std::int32_t> on(std::size_t first, std::size_t last) const {
    return {places_.data() + begin_[first], places_.data() + begin_[last]};
  }

 private:
  struct End {
    std::uint32_t line;
    std::int32_t place;
  };
  std::vector<End> unsorted_;
  std::vector<std::uint32_t> begin_;  // of each line, and the end
  std::vector<std::int32_t> places_;
};

/// The part of a digital set in the bricks around a source brick, as the places where its lines along x, from low to high,
/// enter the set and leave it: its surfels orthogonal to x. Lines that are in the set from the beginning enter it nowhere;
/// the face where they begin is a set of the plane, whose lines along y enter and leave it in turn.
class LineEnds {
 public:
  /// The window has `most` bricks on each side of the source brick. A place is a point (x, y, z) relative to the source
  /// brick's origin, as x + stride (y + stride_z z); on the face, (y, z) as y + stride z.
  LineEnds(int most, std::int32_t stride, std::int32_t stride_z)
      : most_(most), stride_(stride), stride_z_(stride_z) {}

  /// Cost: the bricks of the window, and the surfels in it. Leaves out brick rows further than `reach` points from all
  /// of the source brick.
  void build(const DigitalSet<3>& set, const LatticePoint<3>& source, int reach);

  /// Lines along y or z, those of the window, and the first one.
  int lines() const { return 8 * (2 * most_ + 1); }
  int first() const { return -8 * most_; }

  Ends enters,
      leaves;  ///< by line (y, z), number (y - first) + lines (z - first); a place is the first point after
  Ends face_enters, face_leaves;  ///< by line z, number z - first

 private:
  void add_row(const DigitalSet<3>& set, const LatticePoint<3>& source, int y, int z);

  int most_;
  std::int32_t stride_, stride_z_;
  std::vector<std::uint8_t> face_;  // by line (y, z)
};

}  // namespace gridstep
