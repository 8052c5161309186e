#include "estimators/integral_invariant/radial/radial_bricks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "estimators/integral_invariant/distinct_points.hpp"
#include "estimators/integral_invariant/radial/line_ends.hpp"
#include "shapes/base/parallel.hpp"

namespace gridstep {

namespace {

/// Surfels whose lower spel is in one brick.
struct Source {
  LatticePoint<3> brick;
  std::span<const std::size_t>
      surfels;  ///< their numbers, those orthogonal to one axis after those to another
};

class Sources {
 public:
  explicit Sources(std::span<const Surfel<3>> surfels) : order_(surfels.size()) {
    using Key = std::array<int, 4>;
    std::vector<Key> keys;
    keys.reserve(surfels.size());
    for (const Surfel<3>& surfel : surfels) {
      const LatticePoint<3> brick = Brick<3>::of(lower_spel(surfel));
      keys.push_back({brick[2], brick[1], brick[0], surfel.axis});
    }
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::sort(order_.begin(), order_.end(), [&](std::size_t i, std::size_t j) { return keys[i] < keys[j]; });
    const auto brick_of = [&](std::size_t place) {
      const Key& key = keys[order_[place]];
      return LatticePoint<3>(key[2], key[1], key[0]);
    };
    for (std::size_t begin = 0, end = 0; begin != order_.size(); begin = end) {
      const LatticePoint<3> brick = brick_of(begin);
      while (end != order_.size() && brick_of(end) == brick) ++end;
      sources_.push_back({brick, std::span(order_).subspan(begin, end - begin)});
    }
  }

  const std::vector<Source>& all() const { return sources_; }

 private:
  std::vector<std::size_t> order_;
  std::vector<Source> sources_;
};

/// Lines whose entries lie far from each other: those of the lines to come are asked for ahead.
template <int sign, class Slice, class Flux>
void add_lines(Slice& slice, const Flux* origin, std::span<const End> ends, std::int64_t base) {
  for (const End& end : ends) {
    __builtin_prefetch(origin + (&end + Ends::kAhead)->place);
    slice.template add<sign>(origin[end.place], 2 * std::int64_t{end.line} - base);
  }
}

/// The sum around the surfel orthogonal to the tables' axis above the spel at `p` of the source brick.
template <class Flux>
RadialSum sum_at(const FluxTables<Flux>& tables, const LineEnds& ends, const LatticePoint<3>& p,
                 std::int64_t& visited) {
  typename Flux::Sum sum;
  const auto& strides = tables.strides();
  const Flux* const origin = tables.line_ends() - (strides[0] * p[0] + strides[1] * p[1] + strides[2] * p[2]);
  const auto* const face = tables.face_ends() - (p[1] + p[2] * tables.face_stride());
  const std::int64_t base = 2 * std::int64_t{p[1]} + (tables.half_axis() == 1);
  const auto coordinate = [&](int k, int offset) {
    return 2 * std::int64_t{offset} - (k == tables.half_axis());
  };
  for (int z = -tables.reach(); z <= tables.reach(); ++z) {
    const auto& [low, high] = tables.lines(z);
    if (high < low) continue;
    const auto row = std::size_t(z + p[2] - ends.first());
    const std::size_t line = row * std::size_t(ends.lines()) + std::size_t(p[1] - ends.first());
    const auto first = line + std::size_t(low), last = line + std::size_t(high) + 1;
    typename Flux::Slice slice;
    const auto enters = ends.enters.on(first, last), leaves = ends.leaves.on(first, last);
    add_lines<1>(slice, origin, enters, base);
    add_lines<-1>(slice, origin, leaves, base);
    sum += slice.at(coordinate(2, z));
    const auto face_enters = ends.face_enters.on(row, row + 1),
               face_leaves = ends.face_leaves.on(row, row + 1);
    for (const End& end : face_enters) sum += face[end.place];
    for (const End& end : face_leaves) sum -= face[end.place];
    visited += std::int64_t(enters.size() + leaves.size() + face_enters.size() + face_leaves.size());
  }
  return RadialSum(sum);
}

DigitalLength checked(DigitalLength radius, double greatest) {
  if (radius.value > greatest)
    throw InputError(
        fmt::format("kernel radius R/h = {:.6g}: the tables of radial kernels are made for {} cells at most",
                    radius.value, greatest));
  return radius;
}

}  // namespace

template <class Flux>
RadialBricks<Flux>::RadialBricks(const RadialWeights& weights, DigitalLength radius)
    : tables_{FluxTables<Flux>(weights, checked(radius, kGreatestRadius), 0),
              FluxTables<Flux>(weights, radius, 1), FluxTables<Flux>(weights, radius, 2)} {}

template <class Flux>
std::vector<RadialSum> RadialBricks<Flux>::eval(const DigitalSet<3>& set, std::span<const Surfel<3>> surfels,
                                                EvaluationWork& work) const {
  struct Scratch {
    LineEnds ends;
    std::int64_t visited = 0;
  };
  const auto& shape = tables_.front();
  PerWorker<Scratch> scratches(Scratch{LineEnds(shape.most(), shape.strides(), shape.face_stride())});
  std::vector<RadialSum> result(surfels.size());
  const Sources sources(surfels);
  constexpr std::size_t kGrain = 4;
  parallel_chunks(sources.all().size(), kGrain, [&](std::size_t begin, std::size_t end) {
    Scratch& scratch = scratches.local();
    for (std::size_t i = begin; i != end; ++i) {
      const Source& source = sources.all()[i];
      scratch.ends.build(set, source.brick, shape.reach());
      for (const std::size_t number : source.surfels) {
        const Surfel<3>& surfel = surfels[number];
        const LatticePoint<3> p = lower_spel(surfel) - Brick<3>::origin(source.brick);
        result[number] = sum_at(tables_[std::size_t(surfel.axis)], scratch.ends, p, scratch.visited);
      }
    }
  });
  work.points += std::int64_t(surfels.size());
  scratches.for_each([&](const Scratch& scratch) { work.cells_visited += scratch.visited; });
  return result;
}

template class RadialBricks<CurvatureFlux>;
template class RadialBricks<WholeFlux>;

}  // namespace gridstep
