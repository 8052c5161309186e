#pragma once

#include <algorithm>
#include <bit>
#include <numeric>

#include "shapes/base/parallel.hpp"

namespace gridstep {
namespace detail {

/// Offsets as distances in a dense window, where the coordinates are needed (moments) or not.
template <int d, class Weight>
struct LinearOffsets {
  const WeightedOffsets<d, Weight>* offsets;
  std::vector<std::int32_t> distance;
};

template <int d, class Weight>
LinearOffsets<d, Weight> linear_offsets(const WindowLayout<d>& layout,
                                        const WeightedOffsets<d, Weight>& offsets) {
  LinearOffsets<d, Weight> result{&offsets, {}};
  result.distance.reserve(offsets.size());
  for (const LatticePoint<d>& z : offsets.offsets)
    result.distance.push_back(std::int32_t(layout.distance(z)));
  return result;
}

template <int d, class Value, class Weight, class Accumulated>
void accumulate(PlainSum<d, Accumulated>& sum, const Value* at, const LinearOffsets<d, Weight>& linear) {
  for (const auto& group : linear.offsets->groups) {
    PlainSum<d, Accumulated> part;
    for (std::size_t i = group.begin; i < group.end; ++i) part.n += at[linear.distance[i]];
    sum.merge(part, Accumulated(group.weight));
  }
}

template <class Sum, int d, class Value, class Weight>
void accumulate(Sum& sum, const Value* at, const LinearOffsets<d, Weight>& linear) {
  for (const auto& group : linear.offsets->groups) {
    Sum part;
    for (std::size_t i = group.begin; i < group.end; ++i)
      if (const auto value = at[linear.distance[i]]) part.add(value, linear.offsets->offsets[i]);
    sum.merge(part, group.weight);
  }
}

/// The order in which `masks` visits the points of a block: each after its parent, 0-adjacent to it.
/// parent == itself: a restart. Steps along one axis are taken before diagonal ones, whose masks are larger,
/// and x last: its masks read one value from each row of the window, where the others find neighbours in
/// memory.
template <int d>
class AdjacencyWalk {
 public:
  struct Visit {
    std::uint32_t point, parent;
  };

  explicit AdjacencyWalk(int block_side) : side_(block_side + 2), number_(cells(), kNone) {}

  /// points: those of one block, of which `first` is the lowest corner.
  template <class Weight>
  const std::vector<Visit>& order(std::span<const LatticePoint<d>> points, const LatticePoint<d>& first) {
    const auto& steps = DisplacementMasks<d, Weight>::steps();
    for (std::uint32_t i = 0; i < points.size(); ++i) number_[cell(points[i] - first)] = i;
    visits_.clear();
    for (std::uint32_t start = 0; start < points.size(); ++start) {
      reach(points, first, {start, start}, steps);
      while (true) {
        auto queue = std::find_if(queues_.begin(), queues_.end(), [](const auto& q) { return !q.empty(); });
        if (queue == queues_.end()) break;
        const Visit next = queue->back();
        queue->pop_back();
        reach(points, first, next, steps);
      }
    }
    return visits_;
  }

 private:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  std::size_t cells() const { return d == 2 ? side_ * side_ : side_ * side_ * side_; }
  std::size_t cell(const LatticePoint<d>& z) const {
    std::size_t index = 0;
    for (int k = d - 1; k >= 0; --k) index = index * side_ + std::size_t(z[k] + 1);
    return index;
  }

  static std::size_t queue_of(const LatticePoint<d>& step) {
    const int axes = step.cwiseAbs().sum();
    if (axes > 1) return std::size_t(d - 2 + axes);
    int axis;
    step.cwiseAbs().maxCoeff(&axis);
    return std::size_t(d - 1 - axis);
  }

  template <class Steps>
  void reach(std::span<const LatticePoint<d>> points, const LatticePoint<d>& first, Visit visit,
             const Steps& steps) {
    std::uint32_t& own = number_[cell(points[visit.point] - first)];
    if (own == kNone) return;
    own = kNone;  // also leaves the table clean for the next block
    visits_.push_back(visit);
    for (const LatticePoint<d>& step : steps) {
      const std::uint32_t neighbour = number_[cell(points[visit.point] + step - first)];
      if (neighbour != kNone) queues_[queue_of(step)].push_back({neighbour, visit.point});
    }
  }

  std::size_t side_;
  std::vector<std::uint32_t> number_;                 // of the points of a block, with a margin of one cell
  std::array<std::vector<Visit>, 2 * d - 1> queues_;  // by preference
  std::vector<Visit> visits_;
};

}  // namespace detail

template <class Sum, int d, class ShapeFunctor, class Weight>
std::vector<Sum> convolve(const ShapeFunctor& f, const Kernel<d, Weight>& kernel,
                          const std::type_identity_t<DisplacementMasks<d, Weight>>* masks,
                          std::span<const std::type_identity_t<LatticePoint<d>>> points,
                          EvaluationWork* work) {
  using Value = typename ShapeFunctor::Value;
  int reach = 1;
  for (const LatticePoint<d>& z : kernel.offsets) reach = std::max(reach, z.cwiseAbs().maxCoeff());
  ++reach;  // a mask also reads the cells that the kernel leaves

  // A block as wide as the kernel's radius keeps the filling of windows below the reading of masks, and a
  // restart for each block below one in a hundred points. A power of two.
  const int block_shift = std::max(d == 2 ? 8 : 5, int(std::bit_width(unsigned(reach - 1))) - 1);
  const int block_side = 1 << block_shift;
  const WindowLayout<d> layout{LatticePoint<d>::Constant(block_side + 2 * reach)};
  if (layout.volume() >= 0x1p31)
    throw InputError("the kernel radius is too large: its window would hold more than 2^31 cells");
  const auto linear_kernel = detail::linear_offsets(layout, kernel);
  std::vector<detail::LinearOffsets<d, Weight>> linear_masks(masks ? DisplacementMasks<d, Weight>::kCount + 1
                                                                   : 0);
  if (masks)
    for (const LatticePoint<d>& step : DisplacementMasks<d, Weight>::steps())
      linear_masks[masks->number(step)] = detail::linear_offsets(layout, (*masks)[step]);

  // Points by block, in their given order within a block.
  struct Member {
    LatticePoint<d> block;
    std::uint32_t point;
  };
  std::vector<Member> order(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    order[i] = {points[i].unaryExpr([block_shift](int x) { return x >> block_shift; }), std::uint32_t(i)};
  std::stable_sort(order.begin(), order.end(),
                   [](const Member& a, const Member& b) { return raster_less<d>(a.block, b.block); });
  std::vector<std::size_t> block_begin;
  for (std::size_t i = 0; i < order.size(); ++i)
    if (i == 0 || order[i].block != order[i - 1].block) block_begin.push_back(i);
  block_begin.push_back(order.size());

  struct Scratch {
    std::vector<Value> window;
    std::vector<LatticePoint<d>> points;

    detail::AdjacencyWalk<d> walk;
    EvaluationWork work;
  };
  PerWorker<Scratch> scratches({{}, {}, detail::AdjacencyWalk<d>(block_side), {}});

  std::vector<Sum> result(points.size());
  const auto evaluate_block = [&](std::size_t b) {
    Scratch& scratch = scratches.local();
    scratch.window.resize(std::size_t(layout.volume()));
    const std::span members(order.data() + block_begin[b], block_begin[b + 1] - block_begin[b]);
    scratch.points.clear();
    for (const Member& member : members) scratch.points.push_back(points[member.point]);
    const LatticePoint<d> first = members.front().block * block_side;
    const LatticePoint<d> window_first = first.array() - reach;
    f.fill({window_first, window_first + layout.extent - LatticePoint<d>::Ones()}, scratch.window);
    const auto at = [&](const LatticePoint<d>& z) {
      return scratch.window.data() + layout.distance(z - window_first);
    };

    scratch.work.points += std::int64_t(members.size());
    if (!masks) {
      for (std::size_t i = 0; i < members.size(); ++i)
        detail::accumulate(result[members[i].point], at(scratch.points[i]), linear_kernel);
      scratch.work.cells_visited += std::int64_t(members.size() * kernel.size());
      return;
    }
    for (const auto& [point, parent] : scratch.walk.template order<Weight>(scratch.points, first)) {
      Sum& sum = result[members[point].point];
      if (point == parent) {
        detail::accumulate(sum, at(scratch.points[point]), linear_kernel);
        scratch.work.cells_visited += std::int64_t(kernel.size());
        ++scratch.work.restarts;
        continue;
      }
      const LatticePoint<d> step = scratch.points[point] - scratch.points[parent];
      const auto& mask = linear_masks[masks->number(step)];
      sum = result[members[parent].point];
      sum.move(step);
      detail::accumulate(sum, at(scratch.points[point]), mask);
      scratch.work.cells_visited += std::int64_t(mask.distance.size());
    }
  };
  parallel_chunks(block_begin.size() - 1, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b != end; ++b) evaluate_block(b);
  });
  if (work)
    scratches.for_each([&](const Scratch& scratch) {
      work->points += scratch.work.points;
      work->cells_visited += scratch.work.cells_visited;
      work->restarts += scratch.work.restarts;
    });
  return result;
}

}  // namespace gridstep
