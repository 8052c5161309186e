#include "estimators/contour/circular_arc.hpp"

#include <algorithm>
#include <cmath>

namespace gridstep {

LinelSides::LinelSides(const DigitalContour& contour) {
  const std::ptrdiff_t n = contour.size();
  inner.resize(std::size_t(2 * n));
  outer.resize(std::size_t(2 * n));
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    // Pointel p is the lower left corner of the digital point p; the four around it are p - {0, 1}^2.
    const LatticePoint<2> p = contour[i], s = contour.step(i);
    const LatticePoint<2> ahead_left = p + LatticePoint<2>((s[0] - s[1] - 1) / 2, (s[0] + s[1] - 1) / 2);
    const LatticePoint<2> ahead_right = ahead_left + LatticePoint<2>(s[1], -s[0]);
    inner[std::size_t(i)] = inner[std::size_t(i + n)] = ahead_left;
    outer[std::size_t(i)] = outer[std::size_t(i + n)] = ahead_right;
  }
}

bool ArcRecognition::Curve::separates(const LatticePoint<2>& point, Side side) const {
  const Wide x = Wide(point[0]) - pole[0], y = Wide(point[1]) - pole[1];
  const Wide f = pencil.A * (straight ? 1 : x * x + y * y) + pencil.B * x + pencil.C * y;
  return side == Side::inner ? f <= 0 : f >= 0;
}

void ArcRecognition::start(std::ptrdiff_t i) {
  first_ = i;
  size_ = 1;
  const LatticePoint<2>& origin = sides_.inner[std::size_t(i)];
  lines_.reset_lines(origin, PencilSeparation::Tangent::inner_on_left);
  lines_.add_inner(sides_.inner[std::size_t(i)]);
  lines_.add_outer(sides_.outer[std::size_t(i)]);
  curve_ = {true, origin, lines_.curve()};
}

bool ArcRecognition::extend() {
  const auto next = std::size_t(first_ + size_);
  const LatticePoint<2>&inner = sides_.inner[next], &outer = sides_.outer[next];
  const Curve before = curve_;
  const bool extended =
      curve_.straight ? extend_line(inner, outer)
                      : (curve_.separates(inner, Side::inner) || turn_to(inner, Side::inner, nullptr)) &&
                            (curve_.separates(outer, Side::outer) || turn_to(outer, Side::outer, &inner));
  if (!extended) {
    curve_ = before;
    return false;
  }
  ++size_;
  return true;
}

bool ArcRecognition::extend_line(const LatticePoint<2>& inner, const LatticePoint<2>& outer) {
  if (!lines_.add_outer(outer))
    return turn_to(outer, Side::outer, nullptr) &&
           (curve_.separates(inner, Side::inner) || turn_to(inner, Side::inner, &outer));
  if (!lines_.add_inner(inner)) return turn_to(inner, Side::inner, &outer);
  curve_.pencil = lines_.curve();
  return true;
}

bool ArcRecognition::turn_to(const LatticePoint<2>& z, Side side, const LatticePoint<2>* other) {
  circles_.reset_circles(z, side == Side::outer ? PencilSeparation::Tangent::outer_on_left
                                                : PencilSeparation::Tangent::inner_on_left);
  // Any order finds the same circle. After a few points from all over the arc the tangent has almost its final place.
  const auto add = [&](std::ptrdiff_t i) {
    return circles_.add_inner(sides_.inner[std::size_t(i)]) &&
           circles_.add_outer(sides_.outer[std::size_t(i)]);
  };
  constexpr std::ptrdiff_t kSamples = 64;
  constexpr std::ptrdiff_t kScatter = 39;  // prime to the number of samples, near its golden section
  if (size_ > kSamples)
    for (std::ptrdiff_t k = 0; k < kSamples; ++k)
      if (!add(first_ + k * kScatter % kSamples * size_ / kSamples)) return false;
  for (std::ptrdiff_t i = first_; i < first_ + size_; ++i)
    if (!add(i)) return false;
  if (other && !(side == Side::outer ? circles_.add_inner(*other) : circles_.add_outer(*other))) return false;
  curve_ = {false, z, circles_.curve()};
  return true;
}

// A curve that separates this arc's end and both new points can be reached from the arc's own curve through others that
// separate the arc's end. On the way, the last new point to change its side is on the curve, and the other one is not
// on the wrong side: so one of the circles through it will do as well.
std::ptrdiff_t ArcRecognition::first_of_next() {
  const std::ptrdiff_t next = first_ + size_;
  const LatticePoint<2>&inner = sides_.inner[std::size_t(next)], &outer = sides_.outer[std::size_t(next)];
  std::ptrdiff_t least = next;
  const auto read = [&](const LatticePoint<2>& pole) {
    circles_.reset_circles(pole, PencilSeparation::Tangent::inner_on_left);
    circles_.add_inner(inner);
    circles_.add_outer(outer);
    for (std::ptrdiff_t i = next - 1; i > first_; --i) {
      if (!circles_.add_inner(sides_.inner[std::size_t(i)]) ||
          !circles_.add_outer(sides_.outer[std::size_t(i)]))
        return;
      least = std::min(least, i);
    }
  };
  if (!curve_.separates(inner, Side::inner)) read(inner);
  if (!curve_.separates(outer, Side::outer)) read(outer);
  return least;
}

double ArcRecognition::curvature() const {
  if (curve_.straight) return 0;
  return 2 * double(curve_.pencil.A) / std::hypot(double(curve_.pencil.B), double(curve_.pencil.C));
}

std::ptrdiff_t canonical_start(const DigitalContour& contour) {
  const std::ptrdiff_t n = contour.size();
  const auto turn = [&](std::ptrdiff_t i) {
    const LatticePoint<2> a = contour.step(i), b = contour.step(i + 1);
    return a[0] * b[1] - a[1] * b[0];
  };
  // Two candidates i < j agree on k turns; where they differ next, the larger one and the k after it are out.
  std::ptrdiff_t i = 0, j = 1, k = 0;
  while (j < n && i < n && k < n) {
    const int difference = turn(i + k) - turn(j + k);
    if (difference == 0) {
      ++k;
      continue;
    }
    (difference > 0 ? i : j) += k + 1;
    if (i == j) ++j;
    k = 0;
  }
  return std::min(i, j);
}

std::vector<CircularArc> maximal_arcs(const DigitalContour& contour) {
  const LinelSides sides(contour);
  const std::ptrdiff_t n = contour.size();
  ArcRecognition arc(sides);
  const auto read = [&](std::ptrdiff_t first) {
    arc.start(first);
    while (arc.size() < n && arc.extend()) {
    }
  };
  read(0);
  if (arc.size() == n) {
    const std::ptrdiff_t start = canonical_start(contour);
    read(start);
    return {{start, n, arc.curvature()}};
  }
  // The arc that follows ends first among those that go beyond the last one: it holds the linel after that.
  std::vector<CircularArc> arcs;
  for (std::ptrdiff_t first = arc.first_of_next() % n; arcs.empty() || first != arcs.front().begin;
       first = arc.first_of_next() % n) {
    read(first);
    arcs.push_back({first, arc.size(), arc.curvature()});
  }
  std::rotate(arcs.begin(),
              std::min_element(arcs.begin(), arcs.end(),
                               [](const CircularArc& a, const CircularArc& b) { return a.begin < b.begin; }),
              arcs.end());
  return arcs;
}

}  // namespace gridstep
