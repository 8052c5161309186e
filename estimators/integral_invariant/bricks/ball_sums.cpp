#include "estimators/integral_invariant/bricks/ball_sums.hpp"

#include "estimators/integral_invariant/bricks/full_row_sums.hpp"
#include "estimators/integral_invariant/bricks/targets.hpp"
#include "shapes/base/parallel.hpp"

namespace gridstep::bricks {

template <int d, class Sum>
struct BallSums<d, Sum>::Tables {
  BallRows<d> ball;
  FullRowSums<d, Modular<Sum>> full_rows;

  Tables(DigitalLength radius, int half_axis) : ball(radius, half_axis), full_rows(ball) {}
};

template <int d, class Sum>
BallSums<d, Sum>::BallSums(DigitalLength radius, int half_axis)
    : tables_(std::make_unique<Tables>(radius, half_axis)) {}
template <int d, class Sum>
BallSums<d, Sum>::BallSums(BallSums&&) noexcept = default;
template <int d, class Sum>
BallSums<d, Sum>& BallSums<d, Sum>::operator=(BallSums&&) noexcept = default;
template <int d, class Sum>
BallSums<d, Sum>::~BallSums() = default;

template <int d, class Sum>
std::int64_t BallSums<d, Sum>::ball_size() const {
  return tables_->ball.size();
}

template <int d, class Sum>
std::size_t BallSums<d, Sum>::memory() const {
  return tables_->ball.memory() + tables_->full_rows.memory();
}

template <int d, class Sum>
UninitializedVector<Sum> BallSums<d, Sum>::eval(const DigitalSet<d>& set, const SpelsByBrick<d>& spels,
                                                EvaluationWork* work) const {
  const auto& sources = spels.sources();
  UninitializedVector<Sum> result(spels.size());
  if (sources.empty()) return result;
  const auto& [ball, full_rows] = *tables_;

  LatticeBox<d> box{sources.front().brick, sources.front().brick};
  for (const auto& source : sources) box = {box.lo.cwiseMin(source.brick), box.hi.cwiseMax(source.brick)};
  for (int k = 0; k < d; ++k) {
    const int margin = (ball.radius() >> Brick<d>::kShift[std::size_t(k)]) + 2;
    box.lo[k] -= margin;
    box.hi[k] += margin;
  }
  const BrickRows<d, Modular<Sum>> rows(set, box);
  const auto cut_sums = target().template cut_sums<d, Modular<Sum>>();

  struct Scratch {
    SourceLists<d, Modular<Sum>> lists;
    std::vector<std::uint16_t> bits{};  // of the source brick's spels
    std::vector<Modular<Sum>> sums{};
    std::int64_t visited = 0;
  };
  PerWorker<Scratch> scratches({{ball, rows}});
  constexpr std::size_t kGrain = 16;
  parallel_chunks(sources.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    auto& [lists, bits, sums, visited] = scratches.local();
    for (std::size_t i = begin; i != end; ++i) {
      const auto& source = sources[i];
      lists.build(source.brick);
      bits.clear();
      for_each_bit(source.spels, [&](int bit) { bits.push_back(std::uint16_t(bit)); });
      sums.resize(bits.size());
      cut_sums(lists, ball, bits, sums.data());
      lists.inside.move(Brick<d>::origin(source.brick));
      const auto surplus = full_rows.surplus(lists);
      for (std::size_t k = 0; k < bits.size(); ++k) {
        Modular<Sum> sum = lists.inside;
        add(sum, sums[k]);
        subtract(sum, surplus.of(bits[k]));
        sum.move(Brick<d>::offset(bits[k]));
        add(sum, full_rows.sum(lists, bits[k]));
        result[source.begin + k] = to_signed(sum);
      }
      visited += std::int64_t(lists.size() * bits.size());
    }
  });
  if (work) {
    work->points += std::int64_t(spels.size());
    scratches.for_each([&](const Scratch& scratch) { work->cells_visited += scratch.visited; });
  }
  return result;
}

template class BallSums<2, PlainSum<2, std::int64_t>>;
template class BallSums<2, MomentSums<2, std::int64_t>>;
template class BallSums<3, PlainSum<3, std::int64_t>>;
template class BallSums<3, MomentSums<3, std::int64_t>>;

}  // namespace gridstep::bricks
