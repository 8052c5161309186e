#include "shapes/digital/gauss_digitize.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <vector>

namespace gridstep {

namespace {

/// Which points of a brick are inside, and which are not decided.
template <int d>
struct Decided {
  Brick<d> inside, open;
};

/// The lowest n bits, n <= 64.
std::uint64_t low_bits(int n) {
  return n == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << n) - 1;
}

/// How many of 0, .., n - 1 lie below t.
int count_below(double t, int n) {
  t = std::min(std::max(0.0, t), double(n));
  const int whole = int(t);
  return whole + (whole < t);
}

/// What a bound says of the points of a block within a brick. Along a row of x the affine function is
/// monotone, so that two divisions decide the row; points are only left open within the error, and far more
/// than the rounding here, of its zero.
template <int d>
void decide(const LatticeBox<d>& block, const AffineBound<d>& bound, double h, Decided<d>& decided) {
  const RealPoint<d> first = h * block.lo.template cast<double>(), step = h * bound.slope;
  const LatticePoint<d> extent = block.extent();
  double margin =
      bound.error + bound.rounding(greatest_coordinate<d>({first, h * block.hi.template cast<double>()}));
  const int n = extent[0];
  const bool falls = step[0] < 0;
  const double rise = std::abs(step[0]), per_rise = 1 / rise;
  const bool flat = !(rise * 1e9 > margin + 1e-290);
  if (flat) margin += rise * n;
  // Of the end of each row where the function is least.
  const double corner = bound.value + bound.slope.dot(first - bound.centre) + (falls ? step[0] * (n - 1) : 0);
  for_each_point<d>(
      {block.lo, (LatticePoint<d>() << block.lo[0], block.hi.template tail<d - 1>()).finished()},
      [&](const LatticePoint<d>& z) {
        double least = corner;
        for (int k = 1; k < d; ++k) least += step[k] * (z[k] - block.lo[k]);
        int inside, maybe;
        if (flat) {
          inside = least < -margin ? n : 0;
          maybe = least > margin ? 0 : n;
        } else {
          inside = count_below((-margin - least) * per_rise, n);
          maybe = count_below((margin - least) * per_rise, n);
        }
        std::uint64_t in = low_bits(inside), open = low_bits(maybe) & ~in;
        if (falls) {
          in = low_bits(n) & ~low_bits(n - inside);
          open = low_bits(n - inside) & ~low_bits(n - maybe);
        }
        const int bit = Brick<d>::bit(z);
        decided.inside.words[bit >> 6] |= in << (bit & 63);
        decided.open.words[bit >> 6] |= open << (bit & 63);
      });
}

/// The part of the recursion that one thread does, with its own results.
template <int d>
class Digitizer {
 public:
  Digitizer(const Region<d>& region, GridStep h) : region_(region), h_(h.value) {}

  AffineBound<d> bound(const LatticeBox<d>& points) {
    ++work.boxes;
    return region_.bound(real(points));
  }
  Side side(const LatticeBox<d>& points, const AffineBound<d>& bound) const {
    return bound.side(real(points));
  }

  /// Splits a cube of bricks, `side_length` a power of two, until its parts are decided or single bricks.
  /// @param known a bound that holds for the cube, and is as good as one of its own; or null
  template <class Emit>
  void split_bricks(const LatticePoint<d>& first, int side_length, const AffineBound<d>* known, Emit emit) {
    const LatticePoint<d> behind = first.array() + side_length;
    const LatticeBox<d> points{Brick<d>::origin(first), Brick<d>::origin(behind).array() - 1};
    const AffineBound<d> own = known ? *known : bound(points);
    const Side where = side(points, own);
    if (where == Side::outside) return;
    if (where == Side::inside) {
      for_each_point(LatticeBox<d>{first, behind.array() - 1},
                     [&](const LatticePoint<d>& b) { emit(b, Brick<d>::full()); });
      return;
    }
    if (side_length == 1) {
      Decided<d> decided;
      refine(points, own, decided);
      sample(points.lo, decided);
      emit(first, decided.inside);
      return;
    }
    const bool sharp = own.error <= kSharp * h_ * own.slope.template lpNorm<Eigen::Infinity>();
    const int half = side_length / 2;
    for (int part = 0; part < (1 << d); ++part) {
      LatticePoint<d> corner = first;
      for (int k = 0; k < d; ++k) corner[k] += ((part >> k) & 1) * half;
      split_bricks(corner, half, sharp ? &own : nullptr, emit);
    }
  }

  DigitizationWork work;

 private:
  static constexpr double kSharp = 0.25;
  static constexpr int kSmallest = d == 2 ? 16 : 64;
  static constexpr int kShare = d == 2 ? 8 : 8;

  RealBox<d> real(const LatticeBox<d>& points) const {
    return {h_ * points.lo.template cast<double>(), h_ * points.hi.template cast<double>()};
  }

  /// Decides the points of a block, halving it where a bound over the whole leaves too many open.
  void refine(const LatticeBox<d>& block, const AffineBound<d>& bound, Decided<d>& result) {
    Decided<d> decided;
    decide(block, bound, h_, decided);
    int axis;
    const int longest = block.extent().maxCoeff(&axis), volume = block.extent().prod();
    if (volume > kSmallest && decided.open.count() * kShare > volume) {
      LatticeBox<d> lower = block, upper = block;
      lower.hi[axis] = block.lo[axis] + longest / 2 - 1;
      upper.lo[axis] = lower.hi[axis] + 1;
      refine(lower, this->bound(lower), result);
      refine(upper, this->bound(upper), result);
      return;
    }
    for (std::size_t i = 0; i < 8; ++i) {
      result.inside.words[i] |= decided.inside.words[i];
      result.open.words[i] |= decided.open.words[i];
    }
  }

  /// Computes the membership of the points left open.
  void sample(const LatticePoint<d>& origin, Decided<d>& decided) {
    std::array<RealPoint<d>, 64> points;
    std::array<int, 64> bits;
    std::size_t count = 0;
    const auto flush = [&] {
      const std::uint64_t inside = region_.inside({points.data(), count});
      for (std::size_t i = 0; i < count; ++i)
        decided.inside.words[std::size_t(bits[i]) >> 6] |= ((inside >> i) & 1) << (bits[i] & 63);
      work.points += std::int64_t(count);
      count = 0;
    };
    for_each_bit(decided.open, [&](int bit) {
      points[count] = h_ * (origin + Brick<d>::offset(bit)).template cast<double>();
      bits[count++] = bit;
      if (count == 64) flush();
    });
    if (count > 0) flush();
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
  const LatticeBox<d> points{Brick<d>::origin(pages.lo * side_length),
                             Brick<d>::origin(behind * side_length).array() - 1};
  const Side where = digitizer.side(points, digitizer.bound(points));
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
      digitizer.split_bricks(cut[begin + i] * DigitalSet<d>::kPageSide, DigitalSet<d>::kPageSide, nullptr,
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
