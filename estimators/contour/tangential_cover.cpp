#include "estimators/contour/tangential_cover.hpp"

namespace gridstep {

namespace {

bool is_closed(const DigitalContour& contour) {
  if (contour.size() < 4) return false;
  LatticePoint<2> previous = contour.step(-1);
  for (std::ptrdiff_t i = 0; i < contour.size(); ++i) {
    const LatticePoint<2> step = contour.step(i);
    if (step.cwiseAbs().sum() != 1 || step == -previous) return false;
    previous = step;
  }
  return true;
}

std::ptrdiff_t floor_half(std::ptrdiff_t x) {
  return x >> 1;
}

}  // namespace

TangentialCover::TangentialCover(const DigitalContour& contour) : linels_(contour.size()) {
  expects(is_closed(contour), "a closed contour of unit steps, none of them back");
  StraightSegment segment(contour[0]);
  std::ptrdiff_t first = 0, last = 0;
  while (segment.add(SegmentEnd::front, contour[last + 1])) ++last;
  while (segment.add(SegmentEnd::back, contour[first - 1])) --first;

  // What cannot be extended in front is maximal where one pointel more at the back could not be, either.
  while (first < linels_) {
    if (first >= 0) segments_.push_back({first, last, segment.line()});
    do {
      segment.remove(SegmentEnd::back);
      ++first;
    } while (!segment.add(SegmentEnd::front, contour[last + 1]));
    do ++last;
    while (segment.add(SegmentEnd::front, contour[last + 1]));
  }
}

MaximalSegment TangentialCover::operator[](std::ptrdiff_t k) const {
  std::ptrdiff_t round = 0;
  if (k < 0 || k >= size()) round = k / size() - (k % size() < 0);
  MaximalSegment segment = segments_[std::size_t(k - round * size())];
  segment.first += round * linels_;
  segment.last += round * linels_;
  return segment;
}

CyclicRange TangentialCover::most_centred_for(std::ptrdiff_t k) const {
  // Of two consecutive segments the earlier one is for linels i with last - 1 - i >= i - (next first).
  const MaximalSegment segment = (*this)[k];
  return {floor_half((*this)[k - 1].last + segment.first - 1) + 1,
          floor_half(segment.last + (*this)[k + 1].first - 1) + 1};
}

std::vector<CyclicRange> TangentialCover::segments_of_linels() const {
  std::vector<CyclicRange> ranges(std::size_t(linels_), CyclicRange{});
  std::ptrdiff_t begin = -size(), end = -size();
  for (std::ptrdiff_t i = 0; i < linels_; ++i) {
    while ((*this)[end].first <= i) ++end;
    while ((*this)[begin].last <= i) ++begin;
    ranges[std::size_t(i)] = {begin, end};
  }
  return ranges;
}

}  // namespace gridstep
