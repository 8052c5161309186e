#include "shapes/digital/gauss_digitize.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "shapes/base/parallel.hpp"

namespace gridstep {

namespace {

/// Which points of a brick are inside, and which are not decided.
template <int d>
struct Decided {
  Brick<d> inside, open;
};

// Of GCC and Clang, on every processor: one operation on eight numbers. GCC 12 finds no such form by itself.
using EightShorts [[gnu::vector_size(16)]] = std::int16_t;

EightShorts eight_of(int number) {
  const auto n = std::int16_t(number);
  return EightShorts{n, n, n, n, n, n, n, n};
}

/// The bits of a block of points within one brick.
template <int d>
Brick<d> bits_of(const LatticeBox<d>& block) {
  const int corner = Brick<d>::bit(block.lo);
  const LatticePoint<d> extent = block.extent();
  std::uint64_t line = ~std::uint64_t{0} >> (64 - extent[0]), word = line;
  if constexpr (d == 3)
    for (int y = 1; y < extent[1]; ++y) word = word << 8 | line;
  Brick<d> bits;
  for (int w = 0; w < extent[d - 1]; ++w) bits.words[std::size_t((corner >> 6) + w)] = word << (corner & 63);
  return bits;
}

/// What a bound says of the points of a block within a brick: open are those where |L| may be within the bound's error and
/// the rounding here.
///
/// Compares in short integers, of which a vector has eight, one for each word: kGreatest units are more than |L| and the
/// error come to in the brick, so that what is cut off leaves hardly more points open.
template <int d>
Decided<d> decide(const LatticeBox<d>& block, const AffineBound<d>& bound, double h) {
  constexpr double kGreatest = 32000;
  constexpr int kCutOff = 3;  // units: less than one for each of the numbers that are added up
  static_assert(kGreatest + kCutOff + 1 <= std::numeric_limits<std::int16_t>::max());
  constexpr int kLines = d == 3 ? Brick<d>::extent(1) : 1;
  const LatticePoint<d> corner = Brick<d>::origin(Brick<d>::of(block.lo));
  const RealPoint<d> first = h * corner.template cast<double>(), step = h * bound.slope;
  RealPoint<d> last = first;
  for (int k = 0; k < d; ++k) last[k] += h * (Brick<d>::extent(k) - 1);
  const double margin = bound.error + bound.rounding(greatest_coordinate<d>({first, last}));
  const double at_first = bound.value + bound.slope.dot(first - bound.centre);
  double greatest = std::abs(at_first) + margin;
  for (int k = 0; k < d; ++k) greatest += (Brick<d>::extent(k) - 1) * std::abs(step[k]);
  const double units = kGreatest / greatest;  // in one
  Decided<d> result;
  result.open = bits_of(block);
  if (!std::isnormal(greatest) || !std::isnormal(units)) return result;

  const auto in_units = [units](double value) { return std::int16_t(value * units); };
  const std::int16_t within = std::int16_t(in_units(margin) + 1 + kCutOff);
  std::array<EightShorts, kLines> levels;  // of the words' points at x = 0
  for (int y = 0; y < kLines; ++y)
    for (int w = 0; w < 8; ++w)
      levels[std::size_t(y)][w] = std::int16_t(in_units(at_first + w * step[d - 1]) + in_units(y * step[1]));
  std::array<EightShorts, 4> inside{}, outside{};  // 16 bits of each word
  for (int x = 0; x < Brick<d>::extent(0); ++x) {
    const std::int16_t along = in_units(x * step[0]);
    const EightShorts low = eight_of(-within - along), high = eight_of(within - along);
    for (int y = 0; y < kLines; ++y) {
      const EightShorts bit = eight_of(1 << ((x + 8 * y) % 16));
      const auto part = std::size_t(x + 8 * y) / 16;
      inside[part] |= (levels[std::size_t(y)] < low) & bit;
      outside[part] |= (levels[std::size_t(y)] > high) & bit;
    }
  }
  for (std::size_t w = 0; w < 8; ++w) {
    std::uint64_t in = 0, out = 0;
    for (std::size_t part = 4; part-- > 0;) {
      in = in << 16 | std::uint16_t(inside[part][w]);
      out = out << 16 | std::uint16_t(outside[part][w]);
    }
    result.inside.words[w] = in & result.open.words[w];
    result.open.words[w] &= ~in & ~out;
  }
  return result;
}

/// What DigitalSet::set_page() takes.
template <int d>
struct Page {
  std::vector<std::int32_t> states;
  std::vector<Brick<d>> bricks;
  DigitizationWork work;
};

/// The part of the recursion that one thread does, with its own count of work.
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

  void digitize(const LatticePoint<d>& page, Page<d>& result) {
    result.states.assign(DigitalSet<d>::kBricksInPage, DigitalSet<d>::kEmpty);
    result.bricks.clear();
    split_bricks(page * DigitalSet<d>::kPageSide, DigitalSet<d>::kPageSide, AffineBound<d>{}, result);
    result.work = work;
  }

  DigitizationWork work;

 private:
  static constexpr double kSharp = 0.25;  // cells
  /// Points in a block that is not split further, and the part of a block that may stay open.
  static constexpr int kSmallest = d == 2 ? 16 : 64, kOpenShare = 8;

  /// Splits a cube of bricks, `side_length` a power of two, until its parts are decided or single bricks.
  /// @param of_whole the bound of a cube that this one is part of, or one that decides nothing
  void split_bricks(const LatticePoint<d>& first, int side_length, const AffineBound<d>& of_whole,
                    Page<d>& page) {
    constexpr std::int32_t kFull = DigitalSet<d>::kFull;
    const auto state_of = [&](const LatticePoint<d>& brick) -> std::int32_t& {
      return page.states[std::size_t(DigitalSet<d>::index_in_page(brick))];
    };
    const LatticePoint<d> behind = first.array() + side_length;
    const LatticeBox<d> points{Brick<d>::origin(first), Brick<d>::origin(behind).array() - 1};
    // The bound of the whole decides most parts that the boundary does not cross.
    Side where = side(points, of_whole);
    const bool is_enough = where != Side::crossing || sharp(of_whole);
    const AffineBound<d> own = is_enough ? of_whole : bound(points);
    if (!is_enough) where = side(points, own);
    if (where == Side::outside) return;
    if (where == Side::inside) {
      for_each_point(LatticeBox<d>{first, behind.array() - 1},
                     [&](const LatticePoint<d>& brick) { state_of(brick) = kFull; });
      return;
    }
    if (side_length == 1) {
      Decided<d> decided;
      refine(points, own, decided);
      sample(points.lo, decided);
      if (decided.inside == Brick<d>{}) return;
      std::int32_t& state = state_of(first);
      state = decided.inside == Brick<d>::full() ? kFull : std::int32_t(page.bricks.size());
      if (state != kFull) page.bricks.push_back(decided.inside);
      return;
    }
    const int half = side_length / 2;
    for (int part = 0; part < (1 << d); ++part) {
      LatticePoint<d> corner = first;
      for (int k = 0; k < d; ++k) corner[k] += ((part >> k) & 1) * half;
      split_bricks(corner, half, own, page);
    }
  }

  /// Whether a bound leaves so few points open that one for each part of its box would cost more.
  bool sharp(const AffineBound<d>& bound) const {
    return bound.error <= kSharp * h_ * bound.slope.template lpNorm<Eigen::Infinity>();
  }

  RealBox<d> real(const LatticeBox<d>& points) const {
    return {h_ * points.lo.template cast<double>(), h_ * points.hi.template cast<double>()};
  }

  /// Decides the points of a block, halving it where a bound over the whole leaves too many open.
  void refine(const LatticeBox<d>& block, const AffineBound<d>& bound, Decided<d>& result) {
    const Decided<d> decided = decide(block, bound, h_);
    int axis;
    const int longest = block.extent().maxCoeff(&axis), volume = block.extent().prod();
    if (volume > kSmallest && !sharp(bound) && decided.open.count() * kOpenShare > volume) {
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

  // Batches bound the memory of results that wait for their turn to be stored in order.
  constexpr std::size_t kBatch = 1024;
  DigitizationWork total = coarse.work;
  std::vector<Page<d>> pages(std::min(kBatch, cut.size()));
  for (std::size_t begin = 0; begin < cut.size(); begin += kBatch) {
    const std::size_t count = std::min(kBatch, cut.size() - begin);
    parallel_chunks(count, 1, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i != last; ++i) Digitizer<d>(region, h).digitize(cut[begin + i], pages[i]);
    });
    for (std::size_t i = 0; i < count; ++i) {
      const auto& [states, bricks, page_work] = pages[i];
      const bool uniform = std::equal(states.begin() + 1, states.end(), states.begin());
      if (uniform)
        set.set_page(cut[begin + i], states[0]);
      else
        set.set_page(cut[begin + i], states, bricks);
      total.points += page_work.points;
      total.boxes += page_work.boxes;
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
