#include "shapes/digital/gauss_digitize.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <vector>

namespace gridstep {

namespace {

/// The part of the recursion that one thread does, with its own results.
template <int d>
class Digitizer {
 public:
  Digitizer(const Region<d>& region, GridStep h) : region_(region), h_(h.value) {}

  Side side(const LatticeBox<d>& points) {
    ++work.boxes;
    return region_.side({h_ * points.lo.template cast<double>(), h_ * points.hi.template cast<double>()});
  }

  /// Splits a cube of bricks, `side_length` a power of two, until its parts are decided or single bricks.
  template <class Emit>
  void split_bricks(const LatticePoint<d>& first, int side_length, Emit emit) {
    const LatticePoint<d> behind = first.array() + side_length;
    const Side where = side({Brick<d>::origin(first), Brick<d>::origin(behind).array() - 1});
    if (where == Side::outside) return;
    if (where == Side::inside) {
      for_each_point(LatticeBox<d>{first, behind.array() - 1},
                     [&](const LatticePoint<d>& b) { emit(b, Brick<d>::full()); });
      return;
    }
    if (side_length == 1) {
      emit(first, sample(first));
      return;
    }
    const int half = side_length / 2;
    for (int part = 0; part < (1 << d); ++part) {
      LatticePoint<d> corner = first;
      for (int k = 0; k < d; ++k) corner[k] += ((part >> k) & 1) * half;
      split_bricks(corner, half, emit);
    }
  }

  DigitizationWork work;

 private:
  Brick<d> sample(const LatticePoint<d>& b) {
    const LatticePoint<d> origin = Brick<d>::origin(b);
    Brick<d> bits;
    std::array<RealPoint<d>, 64> points;
    for (int word = 0; word < 8; ++word) {
      for (int i = 0; i < 64; ++i)
        points[i] = h_ * (origin + Brick<d>::offset(64 * word + i)).template cast<double>();
      bits.words[word] = region_.inside(points);
    }
    work.points += Brick<d>::kBits;
    return bits;
  }

  const Region<d>& region_;
  double h_;
};

/// Pages that may be cut, found by halving the box of all pages along its longest side.
template <int d>
void split_pages(Digitizer<d>& digitizer, const LatticeBox<d>& pages, DigitalSet<d>& set,
                 std::vector<LatticePoint<d>>& cut) {
  const LatticePoint<d> behind = pages.hi.array() + 1;
  const int side_length = DigitalSet<d>::kPageSide;
  const Side where = digitizer.side(
      {Brick<d>::origin(pages.lo * side_length), Brick<d>::origin(behind * side_length).array() - 1});
  if (where == Side::outside) return;
  if (where == Side::inside) {
    for_each_point(pages, [&](const LatticePoint<d>& page) { set.set_page(page, DigitalSet<d>::kFull); });
    return;
  }
  int axis;
  if (pages.extent().maxCoeff(&axis) == 1) {
    cut.push_back(pages.lo);
    return;
  }
  LatticeBox<d> lower = pages, upper = pages;
  lower.hi[axis] = pages.lo[axis] + (pages.hi[axis] - pages.lo[axis]) / 2;
  upper.lo[axis] = lower.hi[axis] + 1;
  split_pages(digitizer, lower, set, cut);
  split_pages(digitizer, upper, set, cut);
}

}  // namespace

template <int d>
LatticeBox<d> digital_bounds(const Region<d>& region, GridStep h) {
  expects(h.value > 0 && std::isfinite(h.value), "a finite grid step h > 0");
  const RealBox<d> box = region.bounds();
  LatticeBox<d> result;
  for (int k = 0; k < d; ++k) {
    const double lo = std::floor(box.min()[k] / h.value) - 1, hi = std::ceil(box.max()[k] / h.value) + 1;
    if (!(lo > -0x1p29 && hi < 0x1p29))
      throw InputError(fmt::format("h = {}: the shape spans more than 2^29 cells", h.value));
    result.lo[k] = int(lo);
    result.hi[k] = int(hi);
  }
  return result;
}

template <int d>
DigitalSet<d> gauss_digitize(const Region<d>& region, GridStep h, DigitizationWork* work) {
  DigitalSet<d> set(digital_bounds(region, h));
  Digitizer<d> coarse(region, h);
  std::vector<LatticePoint<d>> cut;
  split_pages(coarse, set.page_box(), set, cut);

  struct Page {
    std::vector<std::pair<LatticePoint<d>, Brick<d>>> bricks;
    DigitizationWork work;
  };
  // Batches bound the memory of results that wait for their turn to be stored in order.
  constexpr std::size_t kBatch = 1024;
  DigitizationWork total = coarse.work;
  for (std::size_t begin = 0; begin < cut.size(); begin += kBatch) {
    std::vector<Page> pages(std::min(kBatch, cut.size() - begin));
    tbb::parallel_for(std::size_t{0}, pages.size(), [&](std::size_t i) {
      Digitizer<d> digitizer(region, h);
      digitizer.split_bricks(cut[begin + i] * DigitalSet<d>::kPageSide, DigitalSet<d>::kPageSide,
                             [&](const LatticePoint<d>& b, const Brick<d>& bits) {
                               if (bits != Brick<d>{}) pages[i].bricks.emplace_back(b, bits);
                             });
      pages[i].work = digitizer.work;
    });
    for (const Page& page : pages) {
      for (const auto& [b, bits] : page.bricks) set.set_brick(b, bits);
      total.points += page.work.points;
      total.boxes += page.work.boxes;
    }
  }
  if (work) *work = total;
  return set;
}

template LatticeBox<2> digital_bounds(const Region<2>&, GridStep);
template LatticeBox<3> digital_bounds(const Region<3>&, GridStep);
template DigitalSet<2> gauss_digitize(const Region<2>&, GridStep, DigitizationWork*);
template DigitalSet<3> gauss_digitize(const Region<3>&, GridStep, DigitizationWork*);

}  // namespace gridstep
