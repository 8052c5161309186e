#pragma once

#include <vector>

#include "estimators/contour/digital_contour.hpp"
#include "estimators/contour/pencil_separation.hpp"

namespace gridstep {

/// The two digital points of each linel of a closed contour, from twice around it: linel i + n is linel i.
struct LinelSides {
  std::vector<LatticePoint<2>> inner, outer;

  explicit LinelSides(const DigitalContour& contour);
  /// Number n of linels of the contour.
  std::ptrdiff_t contour_size() const { return std::ptrdiff_t(inner.size() / 2); }
};

/// On-line recognition of digital circular arcs. A run of linels is an arc where some circle, or some line, has
/// all inner points on one side or on it, and all outer points on the other side or on it; the set may be inside
/// the circle or outside. Both sides are closed.
///
/// The curve kept is a line while one separates, then the circle of the last point z that the curve before it did
/// not separate: of the circles through z that separate, the one that touches, on the way to z, an outer point,
/// then an inner one, then z = inner; or an inner point, an outer one, then z = outer. All predicates are exact.
///   Cost    O(1) for a linel that the curve at hand separates, else linear in practice in the size of the arc;
///           the curve changes a few times along an arc.
///   Source  T. Roussillon, J.-O. Lachaud, Accurate curvature estimation along digital contours with maximal
///           digital circular arcs, IWCIA 2011; T. Roussillon, L. Tougne, I. Sivignon, On three constrained
///           versions of the digital circular arc recognition problem, DGCI 2009.
class ArcRecognition {
 public:
  /// For arcs of this contour, which must outlive the object.
  explicit ArcRecognition(const LinelSides& sides) : sides_(sides) {}

  /// Begins an arc with linel i; every linel that is read is to be in 0 .. 2n-1.
  void start(std::ptrdiff_t i);
  /// Adds the next linel. If there is no such arc, false: the arc and its curve are as before, and extend() is
  /// not to be called until the next start().
  bool extend();

  std::ptrdiff_t size() const { return size_; }
  /// Of the curve kept, in units of 1/(grid step): positive where the set is convex, 0 for a line.
  double curvature() const;

  /// Where extend() has failed: the first linel of the longest arc that ends with the linel after this arc. It is
  /// after the first linel of this arc. Cost linear in the size of the arc, once or twice.
  std::ptrdiff_t first_of_next();

 private:
  enum class Side { inner, outer };
  struct Curve {
    bool straight = true;
    LatticePoint<2> pole;  ///< or any origin
    Pencil pencil;

    bool separates(const LatticePoint<2>& point, Side side) const;
  };

  bool extend_line(const LatticePoint<2>& inner, const LatticePoint<2>& outer);
  /// Sets the circle through z that separates the linels of the arc and one more point.
  bool turn_to(const LatticePoint<2>& z, Side side, const LatticePoint<2>* other);

  const LinelSides& sides_;
  std::ptrdiff_t first_ = 0, size_ = 0;
  PencilSeparation lines_, circles_;
  Curve curve_;
};

/// A maximal arc of a closed contour of n linels.
struct CircularArc {
  std::ptrdiff_t begin;  ///< its first linel, in 0 .. n-1
  std::ptrdiff_t size;   ///< number of linels, at most n
  double curvature;      ///< as ArcRecognition finds it forward from the first linel
};

/// All arcs of a closed contour that are extendable at neither end, in the order of their first linels, the
/// least first. Their last linels come in order too, and consecutive arcs share linels. Where the whole contour is
/// one arc, and only there, the result is a single arc of n linels; it begins at canonical_start().
///   Cost  A few times the sum of the sizes of the arcs.
std::vector<CircularArc> maximal_arcs(const DigitalContour& contour);

/// Where the word of the turns at pointels (left, straight on, right), read around from there, is least of all its
/// rotations: it moves with the contour where that is rotated by 90 degrees or read from another linel. Equal
/// rotations belong to a symmetry of the contour; the first is taken. Cost O(n).
std::ptrdiff_t canonical_start(const DigitalContour& contour);

}  // namespace gridstep
