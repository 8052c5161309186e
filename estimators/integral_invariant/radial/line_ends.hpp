#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "shapes/digital/digital_set.hpp"

namespace gridstep {

/// Where a line enters a set, or leaves it.
struct End {
  std::int32_t place;  ///< of the first point after
  std::int32_t line;   ///< coordinate of the line: y of a line along x, z of one along y
};

/// Ends of lines, line by line.
class Ends {
 public:
  /// So many more may be read behind those of any line.
  static constexpr std::size_t kAhead = 16;

  /// Empties it, for that many lines.
  void reset(std::size_t lines);
  void add(std::size_t line, const End& end) { unsorted_.push_back({std::uint32_t(line), end}); }
  /// To be called between the last add() and the first on().
  void sort();

  /// Those on the lines from `first` on, `last` excluded.
  std::span<const End> on(std::size_t first, std::size_t last) const {
    return {ends_.data() + begin_[first], ends_.data() + begin_[last]};
  }

 private:
  struct Unsorted {
    std::uint32_t line;  // its number
    End end;
  };
  std::vector<Unsorted> unsorted_;
  std::vector<std::uint32_t> begin_;  // of each line, and the end
  std::vector<End> ends_;
};

/// The part of a digital set in the bricks around a source brick, as the places where its lines along x, from low to high,
/// enter the set and leave it: its surfels orthogonal to x. Lines that are in the set from the beginning enter it nowhere;
/// the face where they begin is a set of the plane, whose lines along y enter and leave it in turn.
class LineEnds {
 public:
  /// The window has `most` bricks on each side of the source brick. A place is a point relative to the source brick's
  /// origin, times strides; on the face, y + face_stride z.
  LineEnds(int most, const std::array<std::int32_t, 3>& strides, std::int32_t face_stride)
      : most_(most), strides_(strides), face_stride_(face_stride) {}

  /// Cost: the bricks of the window, and the surfels in it. Leaves out brick rows further than `reach` points from all
  /// of the source brick.
  void build(const DigitalSet<3>& set, const LatticePoint<3>& source, int reach);

  /// Lines along y or z, those of the window, and the first one.
  int lines() const { return 8 * (2 * most_ + 1); }
  int first() const { return -8 * most_; }

  Ends enters,
      leaves;                     ///< by line (y, z), number (y - first) + lines (z - first)
  Ends face_enters, face_leaves;  ///< by line z, number z - first

 private:
  void add_row(const DigitalSet<3>& set, const LatticePoint<3>& source, int y, int z);

  int most_;
  std::array<std::int32_t, 3> strides_;
  std::int32_t face_stride_;
  std::vector<std::uint8_t> face_;  // by line (y, z)
};

}  // namespace gridstep
