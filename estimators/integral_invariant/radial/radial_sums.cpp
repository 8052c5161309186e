#include "estimators/integral_invariant/radial/radial_sums.hpp"

#include "estimators/integral_invariant/distinct_points.hpp"
#include "estimators/integral_invariant/indicator.hpp"

namespace gridstep {

namespace {

using Moments = MomentSums<3, std::int64_t>;

/// From offsets p of the lower spel to x = 2 p - e, e the unit vector along the surfel's axis.
void set_edge(RadialSum& sum, const Moments& moments, int axis) {
  sum.edge = moments.n;
  for (int i = 0; i < 3; ++i) sum.edge_first[std::size_t(i)] = 2 * moments.first[std::size_t(i)] - (i == axis) * moments.n;
}
void set_tensor(RadialSum& sum, const Moments& moments, int axis) {
  for (int i = 0, pair = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j, ++pair)
      sum.tensor_second[std::size_t(pair)] =
          4 * moments.second[std::size_t(pair)] - 2 * (j == axis) * moments.first[std::size_t(i)] -
          2 * (i == axis) * moments.first[std::size_t(j)] + (i == axis && j == axis) * moments.n;
}

template <int d>
Kernel<d, std::int64_t> weighted(const RadialWeight& weight, const Kernel<d, std::int64_t>& ball, int axis) {
  std::vector<std::pair<LatticePoint<d>, std::int64_t>> entries;
  entries.reserve(ball.size());
  for (const LatticePoint<d>& p : ball.offsets) {
    std::int64_t squared = 0;
    for (int k = 0; k < d; ++k) {
      const std::int64_t x = 2 * std::int64_t{p[k]} - (k == axis);
      squared += x * x;
    }
    entries.emplace_back(p, weight(squared));
  }
  return group_by_weight<d, std::int64_t>(std::move(entries));
}

/// Over the whole ball.
template <int d>
RadialSum sum_over(const RadialWeights& weights, const Kernel<d, std::int64_t>& ball, int axis) {
  RadialSum sum;
  for (const LatticePoint<d>& p : ball.offsets) {
    std::array<std::int64_t, d> x;
    std::int64_t squared = 0;
    for (int k = 0; k < d; ++k) {
      x[std::size_t(k)] = 2 * std::int64_t{p[k]} - (k == axis);
      squared += x[std::size_t(k)] * x[std::size_t(k)];
    }
    const std::int64_t edge = weights.edge(squared);
    sum.trace += weights.trace(squared);
    sum.edge += edge;
    if constexpr (d == 3) {
      const std::int64_t tensor = weights.tensor(squared);
      for (std::size_t i = 0, pair = 0; i < 3; ++i) {
        sum.edge_first[i] += edge * x[i];
        for (std::size_t j = i; j < 3; ++j) sum.tensor_second[pair++] += tensor * x[i] * x[j];
      }
    }
  }
  return sum;
}

}  // namespace

template <int d>
void RadialSums<d>::init(GridStep h, EuclideanLength R) {
  const DigitalLength radius = to_digital(R, h);
  balls_.clear();
  work_ = {};
  for (int axis = 0; axis < d; ++axis) {
    const Kernel<d, std::int64_t> kernel = ball_kernel<d>(radius, axis);  // refuses a bad radius first
    if (axis == 0)
      weights_.emplace(RadialWeights{{kernels_.trace, radius}, {kernels_.edge, radius}, {kernels_.tensor, radius}});
    Ball ball;
    ball.whole = sum_over<d>(*weights_, kernel, axis);
    if (evaluation_ == Evaluation::bricks) {
      ball.fast.emplace(*weights_, radius, axis);
    } else {
      const auto make = [&](const RadialWeight& weight) {
        Weighted result{weighted<d>(weight, kernel, axis), {}};
        if (evaluation_ == Evaluation::masks) result.masks.emplace(result.kernel);
        return result;
      };
      ball.trace = make(weights_->trace);
      ball.edge = make(weights_->edge);
      if (d == 3) ball.tensor = make(weights_->tensor);
    }
    work_.kernel_size = std::int64_t(kernel.size());
    balls_.push_back(std::move(ball));
  }
}

template <int d>
template <class Sum>
std::vector<Sum> RadialSums<d>::convolve_at(const Weighted& weighted, std::span<const LatticePoint<d>> points,
                                            EvaluationWork& work) {
  return convolve<Sum>(Indicator<d>(set_), weighted.kernel, weighted.masks ? &*weighted.masks : nullptr, points, &work);
}

template <int d>
std::vector<RadialSum> RadialSums<d>::sums_at(int axis, std::span<const LatticePoint<d>> points, EvaluationWork& work) {
  using Plain = PlainSum<d, std::int64_t>;
  const Ball& ball = balls_[std::size_t(axis)];
  std::vector<RadialSum> result(points.size());
  EvaluationWork others;
  const auto trace = convolve_at<Plain>(ball.trace, points, work);
  for (std::size_t i = 0; i < points.size(); ++i) result[i].trace = trace[i].n;
  if constexpr (d == 2) {
    const auto edge = convolve_at<Plain>(ball.edge, points, others);
    for (std::size_t i = 0; i < points.size(); ++i) result[i].edge = edge[i].n;
  } else {
    const auto edge = convolve_at<Moments>(ball.edge, points, others);
    for (std::size_t i = 0; i < points.size(); ++i) set_edge(result[i], edge[i], axis);
    const auto tensor = convolve_at<Moments>(ball.tensor, points, others);
    for (std::size_t i = 0; i < points.size(); ++i) set_tensor(result[i], tensor[i], axis);
  }
  work.cells_visited += others.cells_visited;
  work.restarts += others.restarts;
  return result;
}

template <int d>
void RadialSums<d>::eval_along(int axis, std::span<const Surfel<d>> surfels, std::span<RadialSum> result,
                               EvaluationWork& work) {
  const Ball& ball = balls_[std::size_t(axis)];
  if constexpr (d == 3) {
    if (ball.fast) {
      bricks::SpelsByBrick<3> spels;
      bricks::SpelsByBrick<3>::Memo memo;
      for (const Surfel<3>& surfel : surfels)
        if (surfel.axis == axis) spels.insert(lower_spel(surfel), memo);
      spels.number();
      const std::vector<RadialSum> sums = ball.fast->eval(set_, spels, &work);
      for (std::size_t i = 0; i < surfels.size(); ++i)
        if (surfels[i].axis == axis) result[i] = sums[spels.position(lower_spel(surfels[i]), memo)];
      return;
    }
  }
  std::vector<LatticePoint<d>> spels;
  for (const Surfel<d>& surfel : surfels)
    if (surfel.axis == axis) spels.push_back(lower_spel(surfel));
  const DistinctPoints<d> distinct(std::move(spels));
  std::vector<RadialSum> sums;
  if constexpr (d == 2) {
    if (ball.fast) {
      if (!rows_) rows_.emplace(set_);
      sums = ball.fast->eval(*rows_, distinct.points, &work);
    }
  }
  if (!ball.fast) sums = sums_at(axis, distinct.points, work);
  for (std::size_t i = 0; i < surfels.size(); ++i)
    if (surfels[i].axis == axis) result[i] = sums[distinct.position(lower_spel(surfels[i]))];
}

template <int d>
std::vector<RadialSum> RadialSums<d>::eval(std::span<const Surfel<d>> surfels) {
  expects(!balls_.empty(), "init() before eval()");
  EvaluationWork work;
  std::vector<RadialSum> result(surfels.size());
  for (int axis = 0; axis < d; ++axis) eval_along(axis, surfels, result, work);
  work_.evaluations = work.points;
  work_.cells_visited = work.cells_visited;
  work_.restarts = work.restarts;
  return result;
}

template class RadialSums<2>;
template class RadialSums<3>;

}  // namespace gridstep
