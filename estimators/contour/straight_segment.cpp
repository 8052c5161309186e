#include "estimators/contour/straight_segment.hpp"

#include "shapes/base/contracts.hpp"

namespace gridstep {

namespace {

constexpr int kLeft = 0, kRight = 1;

int sign_of(std::int64_t x) {
  return (x > 0) - (x < 0);
}

}  // namespace

void StraightSegment::set_direction(const LatticePoint<2>& v) {
  line_.a = v[1];
  line_.b = v[0];
  line_.mu = line_.remainder(leaning_[kLeft][0]);
}

bool StraightSegment::add(SegmentEnd end, const LatticePoint<2>& p) {
  const int e = int(end), far = 1 - e;
  const LatticePoint<2> step = end == SegmentEnd::front ? p - tips_[e] : tips_[e] - p;
  if (tips_[0] == tips_[1]) {
    tips_[e] = leaning_[kLeft][e] = leaning_[kRight][e] = p;
    set_direction(step);
    return true;
  }
  // Steps are of two kinds at most, which are not opposite.
  if (line_.b * step[0] < 0 || line_.a * step[1] < 0) return false;

  const std::int64_t above = line_.remainder(p) - line_.mu, omega = line_.thickness();
  if (above < -1 || above > omega) return false;
  if (0 <= above && above < omega) {
    if (above == 0) leaning_[kLeft][e] = p;
    if (above == omega - 1) leaning_[kRight][e] = p;
  } else {
    // The line turns about the farthest leaning point of p's side, and keeps one of the other side.
    const int side = above < 0 ? kLeft : kRight, other = 1 - side;
    leaning_[side][e] = p;
    leaning_[other][far] = leaning_[other][e];
    set_direction(leaning_[side][1] - leaning_[side][0]);
  }
  tips_[e] = p;
  return true;
}

/// Of the two unit steps inward from an end, one leads to a point of the line.
LatticePoint<2> StraightSegment::neighbour_inside(SegmentEnd end) const {
  const LatticePoint<2>& tip = tips_[int(end)];
  const int inward = end == SegmentEnd::back ? 1 : -1;
  const LatticePoint<2> horizontal(tip[0] + inward * sign_of(line_.b), tip[1]);
  if (line_.b != 0 && line_.contains(horizontal)) return horizontal;
  return {tip[0], tip[1] + inward * sign_of(line_.a)};
}

/// The line without the tip at `end`, where that tip had turned it: there the tip and the last leaning point
/// of its side are one period apart, with the only leaning point q of the other side between them. Across the
/// line, q* = q -+ (a/|a|, -b/|b|) has remainder mu - 1 (or mu + thickness), so that q* cuts the period into
/// two vectors of determinant 1, the parents of (b, a) in the Stern-Brocot tree. The line that the tip turned
/// had the one at the tip.
void StraightSegment::fall_back(int side, int end) {
  const int far = 1 - end, other = 1 - side;
  const int inward = end == int(SegmentEnd::back) ? 1 : -1;
  const LatticePoint<2> tip = tips_[end], q = leaning_[other][end];
  LatticePoint<2> across(-sign_of(line_.a), sign_of(line_.b));
  if (side == kRight) across = -across;
  const LatticePoint<2> v = inward * (q + across - tip);

  const std::int64_t period = distance(LatticePoint<2>::Zero(), v);
  const int before = int((line_.thickness() - 1) / period);
  const int after = int(distance(q, tips_[far]) / period);
  leaning_[side][end] = leaning_[side][far] - inward * before * v;
  leaning_[other][far] = q + inward * after * v;
  set_direction(v);
}

void StraightSegment::remove(SegmentEnd end) {
  expects(tips_[0] != tips_[1], "a segment of two pointels or more, to remove one");
  const int e = int(end);
  const LatticePoint<2> tip = tips_[e], next = neighbour_inside(end);
  if (next == tips_[1 - e]) {
    *this = StraightSegment(next);
    return;
  }
  const int inward = end == SegmentEnd::back ? 1 : -1;
  const bool leans[2] = {leaning_[kLeft][e] == tip, leaning_[kRight][e] == tip};
  for (const int side : {kLeft, kRight}) {
    if (!leans[side]) continue;
    if (leaning_[1 - side][0] == leaning_[1 - side][1])
      fall_back(side, e);
    else
      leaning_[side][e] += inward * LatticePoint<2>(int(line_.b), int(line_.a));
  }
  tips_[e] = next;
}

}  // namespace gridstep
