#include "estimators/integral_invariant/radial/radial_bricks.hpp"

#include <fmt/format.h>

#include "estimators/integral_invariant/radial/line_sums.hpp"
#include "shapes/base/parallel.hpp"

namespace gridstep {

namespace {

/// Sums over full bricks, for every place of the spel in its own brick.
class FullBricks {
 public:
  explicit FullBricks(const WeightTables& tables) : most_(tables.most()), width_(2 * most_ + 1) {
    sums_.resize(std::size_t(512) * std::size_t(width_ * width_ * (width_ + 1)));
    constexpr int kTrace = 0, kEdge = 1, kTensor = 2;
    fill(tables, kTrace, [](RadialSum& s) -> std::int64_t& { return s.trace; }, {});
    fill(tables, kEdge, [](RadialSum& s) -> std::int64_t& { return s.edge; }, {});
    for (int i = 0, pair = 0; i < 3; ++i) {
      fill(tables, kEdge, [i](RadialSum& s) -> std::int64_t& { return s.edge_first[std::size_t(i)]; }, {i});
      for (int j = i; j < 3; ++j, ++pair)
        fill(tables, kTensor,
             [pair](RadialSum& s) -> std::int64_t& { return s.tensor_second[std::size_t(pair)]; }, {i, j});
    }
  }

  /// Adds the bricks (first..last, y, z) bricks away.
  void add(int bit, int first, int last, int y, int z, RadialSum& sum) const {
    const RadialSum* const row = &sums_[index(bit, y, z)];
    sum += row[last + 1 + most_];
    if (first > -most_) sum -= row[first + most_];  // else zero
  }

 private:
  /// Of the entry for no brick at all; the next one is for the lowest brick alone.
  std::size_t index(int bit, int y, int z) const {
    return ((std::size_t(bit) * std::size_t(width_) + std::size_t(z + most_)) * std::size_t(width_) +
            std::size_t(y + most_)) *
           std::size_t(width_ + 1);
  }

  /// One component of all sums: weight times the coordinates along the axes given.
  template <class Component>
  void fill(const WeightTables& tables, int kernel, Component component, std::initializer_list<int> axes) {
    // Sums over cubes of 8^3 points, by three passes of window sums; `low` is the first point's coordinate.
    const int low = -8 * most_ - 7, points = 2 * -low + 8, cubes = points - 7;
    std::vector<std::int64_t> sums(std::size_t(points) * std::size_t(points) * std::size_t(points));
    const int reach = tables.reach();
    for_each_point(
        LatticeBox<3>{LatticePoint<3>::Constant(-reach), LatticePoint<3>::Constant(reach)},
        [&](const LatticePoint<3>& p) {
          std::int64_t value = tables.begin(p)[kernel * tables.side()];
          for (const int axis : axes) value *= 2 * std::int64_t{p[axis]} - (axis == tables.half_axis());
          const LatticePoint<3> q = p.array() - low;
          sums[(std::size_t(q[2]) * std::size_t(points) + std::size_t(q[1])) * std::size_t(points) +
               std::size_t(q[0])] = value;
        });
    std::size_t stride = 1;
    for (int axis = 0; axis < 3; ++axis, stride *= std::size_t(points))
      parallel_chunks(sums.size() / std::size_t(points), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t line = begin; line != end; ++line) {
          std::int64_t* const first = &sums[line / stride * stride * std::size_t(points) + line % stride];
          std::int64_t window = 0;
          for (std::size_t i = 0; i < 7; ++i) window += first[i * stride];
          for (std::size_t i = 0; i < std::size_t(cubes); ++i) {
            window += first[(i + 7) * stride];
            const std::int64_t lowest = first[i * stride];
            first[i * stride] = window;
            window -= lowest;
          }
        }
      });
    parallel_chunks(512, 16, [&](std::size_t begin, std::size_t end) {
      for (std::size_t bit = begin; bit != end; ++bit)
        for (int z = -most_; z <= most_; ++z)
          for (int y = -most_; y <= most_; ++y) {
            RadialSum* const row = &sums_[index(int(bit), y, z)];
            std::int64_t total = 0;
            for (int x = -most_; x <= most_ + 1; ++x) {
              component(row[x + most_]) = total;
              if (x > most_) break;
              const LatticePoint<3> q = tables.offset({x, y, z}, int(bit)).array() - low;
              total +=
                  sums[(std::size_t(q[2]) * std::size_t(points) + std::size_t(q[1])) * std::size_t(points) +
                       std::size_t(q[0])];
            }
          }
    });
  }

  int most_, width_;
  std::vector<RadialSum> sums_;
};

/// What lies around a source brick.
struct Neighbours {
  struct Mixed {
    const std::uint64_t* words;
    LatticePoint<3> brick;
  };
  struct Run {
    int first, last, y, z;
  };
  std::vector<Mixed> mixed;
  std::vector<Run> runs;

  void list(const DigitalSet<3>& set, const LatticePoint<3>& source, int most) {
    mixed.clear();
    runs.clear();
    for (int z = -most; z <= most; ++z)
      for (int y = -most; y <= most; ++y) {
        bool in_run = false;
        for (int x = -most; x <= most; ++x) {
          const std::int32_t state = set.state(source + LatticePoint<3>(x, y, z));
          if (state == DigitalSet<3>::kFull) {
            if (!in_run) runs.push_back({x, x, y, z});
            runs.back().last = x;
          } else if (state >= 0) {
            mixed.push_back({set.brick_of(state).words.data(), {x, y, z}});
          }
          in_run = state == DigitalSet<3>::kFull;
        }
      }
  }
};

}  // namespace

struct RadialBricks::Tables {
  WeightTables weights;
  FullBricks full;

  Tables(const RadialWeights& radial, DigitalLength radius, int half_axis)
      : weights(radial, radius, half_axis), full(weights) {}
};

RadialBricks::RadialBricks(const RadialWeights& weights, DigitalLength radius, int half_axis) {
  if (radius.value > kGreatestRadius)
    throw InputError(
        fmt::format("kernel radius R/h = {:.6g}: the tables of radial kernels are made for {} cells at most",
                    radius.value, kGreatestRadius));
  tables_ = std::make_unique<Tables>(weights, radius, half_axis);
}
RadialBricks::RadialBricks(RadialBricks&&) noexcept = default;
RadialBricks::~RadialBricks() = default;

std::vector<RadialSum> RadialBricks::eval(const DigitalSet<3>& set, const bricks::SpelsByBrick<3>& spels,
                                          EvaluationWork* work) const {
  const auto& [weights, full] = *tables_;
  const AddBrick add = add_brick();
  std::vector<RadialSum> result(spels.size());
  struct Scratch {
    Neighbours neighbours;
    std::vector<int> bits;  // of the source brick's spels
    std::int64_t visited = 0;
  };
  PerWorker<Scratch> scratches;
  const auto& sources = spels.sources();
  constexpr std::size_t kGrain = 4;
  parallel_chunks(sources.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    auto& [neighbours, bits, visited] = scratches.local();
    for (std::size_t i = begin; i != end; ++i) {
      neighbours.list(set, sources[i].brick, weights.most());
      bits.clear();
      for_each_bit(sources[i].spels, [&](int bit) { bits.push_back(bit); });
      RadialSum* const sums = &result[sources[i].begin];
      // Brick by brick: to all spels it shows nearly the same weights, which stay in the cache.
      for (const Neighbours::Mixed& mixed : neighbours.mixed)
        for (std::size_t k = 0; k < bits.size(); ++k)
          if (const LatticePoint<3> offset = weights.offset(mixed.brick, bits[k]); weights.meets(offset)) {
            add(weights, offset, mixed.words, sums[k]);
            ++visited;
          }
      for (std::size_t k = 0; k < bits.size(); ++k)
        for (const Neighbours::Run& run : neighbours.runs)
          full.add(bits[k], run.first, run.last, run.y, run.z, sums[k]);
      visited += std::int64_t(neighbours.runs.size() * bits.size());
    }
  });
  if (work) {
    work->points += std::int64_t(spels.size());
    scratches.for_each([&](const Scratch& scratch) { work->cells_visited += scratch.visited; });
  }
  return result;
}

}  // namespace gridstep
