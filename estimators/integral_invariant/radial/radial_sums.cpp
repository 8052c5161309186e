#include "estimators/integral_invariant/radial/radial_sums.hpp"

#include "estimators/integral_invariant/distinct_points.hpp"
#include "estimators/integral_invariant/indicator.hpp"

namespace gridstep {

namespace {

/// What convolve() adds up: the offsets of a group of equal weights, and all groups with each of their weights.
template <int d>
struct RadialMoments {
  MomentSums<d, std::int64_t> group, edge, tensor;
  std::int64_t trace = 0;

  void add(std::int64_t value, const LatticePoint<d>& p) { group.add(value, p); }
  void merge(const RadialMoments& other, const RadialTriple& weight) {
    trace += weight.trace * other.group.n;
    edge.merge(other.group, weight.edge);
    tensor.merge(other.group, weight.tensor);
  }
  void move(const LatticePoint<d>& step) {
    edge.move(step);
    tensor.move(step);
  }
  /// From offsets p of the lower spel to x = 2 p - e, e the unit vector along the surfel's axis.
  RadialSum around_surfel(int axis) const {
    RadialSum sum{trace, edge.n, {}, {}};
    if constexpr (d == 3) {
      for (int i = 0, pair = 0; i < 3; ++i) {
        sum.edge_first[std::size_t(i)] = 2 * edge.first[std::size_t(i)] - (i == axis) * edge.n;
        for (int j = i; j < 3; ++j, ++pair)
          sum.tensor_second[std::size_t(pair)] =
              4 * tensor.second[std::size_t(pair)] - 2 * (j == axis) * tensor.first[std::size_t(i)] -
              2 * (i == axis) * tensor.first[std::size_t(j)] + (i == axis && j == axis) * tensor.n;
      }
    }
    return sum;
  }
};

template <int d>
Kernel<d, RadialTriple> weighted(const RadialWeights& weights, const Kernel<d, std::int64_t>& ball,
                                 int axis) {
  std::vector<std::pair<LatticePoint<d>, RadialTriple>> entries;
  entries.reserve(ball.size());
  for (const LatticePoint<d>& p : ball.offsets) {
    std::int64_t squared = 0;
    for (int k = 0; k < d; ++k) {
      const std::int64_t x = 2 * std::int64_t{p[k]} - (k == axis);
      squared += x * x;
    }
    entries.emplace_back(p, weights(squared));
  }
  return group_by_weight<d, RadialTriple>(std::move(entries));
}

/// Over the whole ball.
template <int d>
RadialSum sum_over(const Kernel<d, RadialTriple>& kernel, int axis) {
  RadialMoments<d> total;
  for (const auto& group : kernel.groups) {
    RadialMoments<d> sum;
    for (std::size_t i = group.begin; i != group.end; ++i) sum.add(1, kernel.offsets[i]);
    total.merge(sum, group.weight);
  }
  return total.around_surfel(axis);
}

}  // namespace

template <int d>
void RadialSums<d>::init(GridStep h, EuclideanLength R) {
  const DigitalLength radius = to_digital(R, h);
  balls_.clear();
  work_ = {};
  for (int axis = 0; axis < d; ++axis) {
    const Kernel<d, std::int64_t> points = ball_kernel<d>(radius, axis);  // refuses a bad radius first
    if (axis == 0) weights_.emplace(kernels_, radius);
    work_.kernel_size = std::int64_t(points.size());
    Kernel<d, RadialTriple> kernel = weighted<d>(*weights_, points, axis);
    Ball ball{sum_over<d>(kernel, axis), {}, {}};
    if (evaluation_ != Evaluation::bricks)
      ball.kernel = std::move(kernel);
    else if (d == 2)
      ball.rows.emplace(*weights_, radius, axis);
    balls_.push_back(std::move(ball));
  }
  if (d == 3 && evaluation_ == Evaluation::bricks) {
    if (tensor_)
      bricks_.template emplace<RadialBricks<WholeFlux>>(*weights_, radius);
    else
      bricks_.template emplace<RadialBricks<CurvatureFlux>>(*weights_, radius);
  }
}

template <int d>
std::vector<RadialSum> RadialSums<d>::sums_at(int axis, std::span<const LatticePoint<d>> points,
                                              EvaluationWork& work) {
  const Ball& ball = balls_[std::size_t(axis)];
  if constexpr (d == 2) {
    if (ball.rows) {
      if (!rows_) rows_.emplace(set_);
      return ball.rows->eval(*rows_, points, &work);
    }
  }
  std::vector<RadialSum> result;
  result.reserve(points.size());
  for (const auto& moments :
       convolve<RadialMoments<d>>(Indicator<d>(set_), ball.kernel, nullptr, points, &work))
    result.push_back(moments.around_surfel(axis));
  return result;
}

template <int d>
void RadialSums<d>::eval_along(int axis, std::span<const Surfel<d>> surfels, std::span<RadialSum> result,
                               EvaluationWork& work) {
  std::vector<LatticePoint<d>> spels;
  for (const Surfel<d>& surfel : surfels)
    if (surfel.axis == axis) spels.push_back(lower_spel(surfel));
  const DistinctPoints<d> distinct(std::move(spels));
  const std::vector<RadialSum> sums = sums_at(axis, distinct.points, work);
  for (std::size_t i = 0; i < surfels.size(); ++i)
    if (surfels[i].axis == axis) result[i] = sums[distinct.position(lower_spel(surfels[i]))];
}

template <int d>
std::vector<RadialSum> RadialSums<d>::eval(std::span<const Surfel<d>> surfels) {
  expects(!balls_.empty(), "init() before eval()");
  EvaluationWork work;
  std::vector<RadialSum> result;
  const auto by_bricks = [&](const auto& bricks) {
    if constexpr (d == 3 && !std::is_same_v<decltype(bricks), const std::monostate&>)
      result = bricks.eval(set_, surfels, work);
  };
  std::visit(by_bricks, bricks_);
  if (bricks_.index() == 0) {
    result.resize(surfels.size());
    for (int axis = 0; axis < d; ++axis) eval_along(axis, surfels, result, work);
  }
  work_.evaluations = work.points;
  work_.cells_visited = work.cells_visited;
  work_.restarts = work.restarts;
  return result;
}

template class RadialSums<2>;
template class RadialSums<3>;

}  // namespace gridstep
