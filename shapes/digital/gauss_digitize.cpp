#include "shapes/digital/gauss_digitize.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "shapes/base/parallel.hpp"
#include "shapes/digital/brick_levels.hpp"

namespace gridstep {

namespace {

/// Which points of a brick are inside, and which are not decided.
template <int d>
struct Decided {
  Brick<d> inside, open;
};

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

/// What a bound says of the points of a block within a brick: open are those where |Q| may be within the bound's error and
/// the rounding here.
template <int d>
Decided<d> decide(const LatticeBox<d>& block, const QuadraticBound<d>& bound, double h) {
  const LatticePoint<d> corner = Brick<d>::origin(Brick<d>::of(block.lo));
  const RealPoint<d> first = h * corner.template cast<double>();
  RealPoint<d> size;  // in steps
  for (int k = 0; k < d; ++k) size[k] = Brick<d>::extent(k) - 1;
  const RealPoint<d> step = h * bound.gradient(first), last = first + h * size;
  const RealMatrix<d> bend = h * (h * bound.bend);  // h * h may be too small for a double
  const double at_first = bound(first),
               margin = bound.error + bound.rounding(greatest_coordinate<d>({first, last}));
  const double greatest =
      std::abs(at_first) + step.cwiseAbs().dot(size) + size.dot(bend.cwiseAbs() * size) + margin;
  Decided<d> result;
  result.open = bits_of(block);
  const double unit = 1 / greatest;
  if (!std::isnormal(greatest) || !std::isnormal(unit)) return result;

  BrickLevels<d> levels;
  levels.constant = float(at_first * unit);
  for (std::size_t j = 0, pair = 0; j < d; ++j) {
    levels.linear[j] = float(step[Eigen::Index(j)] * unit);
    for (std::size_t k = j; k < d; ++k)
      levels.square[pair++] = float((j == k ? 1 : 2) * bend(Eigen::Index(j), Eigen::Index(k)) * unit);
  }
  const ComparedLevels<d> compared = compare(levels, float(margin * unit) + BrickLevels<d>::kRounding);
  for (std::size_t w = 0; w < 8; ++w) {
    result.inside.words[w] = compared.below.words[w] & result.open.words[w];
    result.open.words[w] &= ~compared.below.words[w] & ~compared.above.words[w];
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

/// Bounds on the way to the pages that are cut, or one such page, with its own count of work.
template <int d>
class Digitizer {
 public:
  Digitizer(const Region<d>& region, GridStep h) : region_(region), h_(h.value) {}

  using Bounds = std::array<QuadraticBound<d>, Region<d>::kMostBoxes>;

  /// At most kMostBoxes at once.
  Bounds bound_each(std::span<const LatticeBox<d>> blocks) {
    std::array<RealBox<d>, Region<d>::kMostBoxes> boxes;
    for (std::size_t i = 0; i < blocks.size(); ++i) boxes[i] = real(blocks[i]);
    Bounds bounds;
    region_.bound_each({boxes.data(), blocks.size()}, {bounds.data(), blocks.size()});
    work.boxes += std::int64_t(blocks.size());
    return bounds;
  }
  QuadraticBound<d> bound(const LatticeBox<d>& points) {
    ++work.boxes;
    return region_.bound(real(points));
  }
  Side side(const LatticeBox<d>& points, const QuadraticBound<d>& bound) const {
    return bound.side(real(points));
  }

  /// To be called once.
  void digitize(const LatticePoint<d>& page, Page<d>& result) {
    result.states.assign(DigitalSet<d>::kBricksInPage, DigitalSet<d>::kEmpty);
    result.bricks.clear();
    const Cube whole{page * DigitalSet<d>::kPageSide, DigitalSet<d>::kPageSide};
    split_bricks(whole, bound(whole.points()), result);
    sample(result.bricks);
    keep_cut_bricks(result);
    result.work = work;
  }

  DigitizationWork work;

 private:
  static constexpr int kParts = 1 << d;
  static constexpr double kSharp = 0.1;  // cells
  /// Points, in a brick that is not cut up: of the shapes in 2D a point costs more, and of their bricks less is crossed.
  static constexpr int kMostOpen = d == 2 ? 40 : 120;
  /// Points that Region::inside() takes at once.
  static constexpr std::size_t kBatch = 64;

  /// A cube of bricks, the side a power of two.
  struct Cube {
    LatticePoint<d> first;
    int side_length;

    LatticeBox<d> points() const {
      const LatticePoint<d> behind = first.array() + side_length;
      return {Brick<d>::origin(first), Brick<d>::origin(behind).array() - 1};
    }
    Cube part(int number) const {
      // Written as a whole: what is written by its coordinates and then read as a whole stalls the processor.
      static const auto kCorners = [] {
        std::array<LatticePoint<d>, kParts> corners;
        for (int i = 0; i < kParts; ++i)
          for (int k = 0; k < d; ++k) corners[std::size_t(i)][k] = (i >> k) & 1;
        return corners;
      }();
      return {first + side_length / 2 * kCorners[std::size_t(number)], side_length / 2};
    }
  };

  /// Splits a cube that the boundary may cross until its parts are decided or single bricks.
  /// @param bound that of the cube, or of a larger one where it is sharp
  void split_bricks(const Cube& cube, const QuadraticBound<d>& bound, Page<d>& page) {
    const LatticeBox<d> points = cube.points();
    if (cube.side_length == 1) {
      const Decided<d> decided = decide_brick(points, bound);
      state_of(cube.first, page) = std::int32_t(page.bricks.size());
      page.bricks.push_back(decided.inside);
      for_each_bit(decided.open, [&](int bit) {
        open_points_[open_] = h_ * (points.lo + Brick<d>::offset(bit)).template cast<double>();
        open_bits_[open_] = {page.bricks.size() - 1, bit};
        if (++open_ == kBatch) sample(page.bricks);
      });
      return;
    }
    // The bound of the whole decides most parts that the boundary does not cross, and serves others where it is sharp.
    const RealPoint<d> offset = h_ / 4 * points.extent().template cast<double>();
    const BoundOfParts<d> of_parts(bound, real(points).center(), offset, offset.array() - h_ / 2);
    const auto is_vague = [&](int number) {
      return of_parts.side(number) == Side::crossing && !sharp(bound.error, of_parts.slope(number));
    };
    std::array<LatticeBox<d>, kParts> vague;
    std::size_t size = 0;
    for (int number = 0; number < kParts; ++number)
      if (is_vague(number)) vague[size++] = cube.part(number).points();
    if (size == 0) {
      split_parts(cube, of_parts, page, [&](int) -> const QuadraticBound<d>& { return bound; });
      return;
    }
    const Bounds own = bound_each({vague.data(), size});
    std::size_t next = 0;
    split_parts(cube, of_parts, page, [&](int number) -> const QuadraticBound<d>& {
      return is_vague(number) ? own[next++] : bound;
    });
  }

  /// @param bound_of what to go on with, asked for one crossed part after the other
  template <class BoundOf>
  void split_parts(const Cube& cube, const BoundOfParts<d>& of_parts, Page<d>& page, BoundOf bound_of) {
    for (int number = 0; number < kParts; ++number) {
      const Cube part = cube.part(number);
      if (!set_decided(part, of_parts.side(number), page)) split_bricks(part, bound_of(number), page);
    }
  }

  /// Sets the states of a cube unless it is crossed.
  bool set_decided(const Cube& cube, Side side, Page<d>& page) const {
    if (side == Side::inside)
      for_each_point(LatticeBox<d>{cube.first, cube.first.array() + (cube.side_length - 1)},
                     [&](const LatticePoint<d>& brick) { state_of(brick, page) = DigitalSet<d>::kFull; });
    return side != Side::crossing;
  }

  static std::int32_t& state_of(const LatticePoint<d>& brick, Page<d>& page) {
    return page.states[std::size_t(DigitalSet<d>::index_in_page(brick))];
  }

  /// Drops bricks that came out empty or full.
  static void keep_cut_bricks(Page<d>& page) {
    std::int32_t kept = 0;
    std::vector<std::int32_t> new_states;
    for (const Brick<d>& brick : page.bricks) {
      const bool empty = brick == Brick<d>{}, full = brick == Brick<d>::full();
      new_states.push_back(empty ? DigitalSet<d>::kEmpty : full ? DigitalSet<d>::kFull : kept);
      if (!empty && !full) page.bricks[std::size_t(kept++)] = brick;
    }
    page.bricks.resize(std::size_t(kept));
    for (std::int32_t& state : page.states)
      if (state >= 0) state = new_states[std::size_t(state)];
  }

  /// Whether an error leaves so few points open that a bound of a smaller box would cost more.
  bool sharp(double error, double slope) const { return error <= kSharp * h_ * slope; }

  RealBox<d> real(const LatticeBox<d>& points) const {
    return {h_ * points.lo.template cast<double>(), h_ * points.hi.template cast<double>()};
  }

  /// Decides the points of a brick, by eight bounds where one over the whole leaves too many open.
  Decided<d> decide_brick(const LatticeBox<d>& brick, const QuadraticBound<d>& bound) {
    Decided<d> result = decide(brick, bound, h_);
    if (result.open.count() <= kMostOpen ||
        sharp(bound.error, bound.gradient(real(brick).center()).template lpNorm<Eigen::Infinity>()))
      return result;
    std::array<LatticeBox<d>, 8> blocks;
    for (int number = 0; number < 8; ++number) blocks[std::size_t(number)] = eighth(brick, number);
    const Bounds own = bound_each(blocks);
    result = {};
    for (std::size_t number = 0; number < 8; ++number) {
      const Decided<d> of_block = decide(blocks[number], own[number], h_);
      for (std::size_t i = 0; i < 8; ++i) {
        result.inside.words[i] |= of_block.inside.words[i];
        result.open.words[i] |= of_block.open.words[i];
      }
    }
    return result;
  }

  /// A block of 8 x 8 or 4 x 4 x 4 points.
  static LatticeBox<d> eighth(const LatticeBox<d>& brick, int number) {
    const int side_length = d == 2 ? 8 : 4;
    LatticeBox<d> result = brick;
    for (int k = 0; k < d; ++k) {
      const int along = d == 2 ? (k == 0 ? number : 0) : (number >> k) & 1;
      result.lo[k] += along * side_length;
      result.hi[k] = result.lo[k] + side_length - 1;
    }
    return result;
  }

  /// Computes the membership of the points left open.
  void sample(std::vector<Brick<d>>& bricks) {
    const std::uint64_t inside = region_.inside({open_points_.data(), open_});
    for (std::size_t i = 0; i < open_; ++i) {
      const auto [brick, bit] = open_bits_[i];
      bricks[brick].words[std::size_t(bit) >> 6] |= ((inside >> i) & 1) << (bit & 63);
    }
    work.points += std::int64_t(open_);
    open_ = 0;
  }

  struct OpenBit {
    std::size_t brick;  // of the page
    int bit;
  };

  const Region<d>& region_;
  double h_;
  // Points that wait for sample().
  std::size_t open_ = 0;
  std::array<RealPoint<d>, kBatch> open_points_;
  std::array<OpenBit, kBatch> open_bits_;
};

/// The last page of the lower half of pages lo to hi: the last one of a book where there are several books, since full
/// ones need not be stored.
template <int d>
int last_before_middle(int lo, int hi) {
  const int middle = lo + (hi - lo) / 2, last = middle | (DigitalSet<d>::kPageSide - 1);
  if (last < hi) return last;
  return last - DigitalSet<d>::kPageSide >= lo ? last - DigitalSet<d>::kPageSide : middle;
}

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
    set.fill_pages(pages);
    return;
  }
  int axis;
  if (pages.extent().maxCoeff(&axis) == 1) {
    cut.push_back(pages.lo);
    return;
  }
  LatticeBox<d> lower = pages, upper = pages;
  lower.hi[axis] = last_before_middle<d>(pages.lo[axis], pages.hi[axis]);
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
      if (!uniform)
        set.set_page(cut[begin + i], states, bricks);
      else if (states[0] == DigitalSet<d>::kFull)
        set.fill_pages({cut[begin + i], cut[begin + i]});
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
