#include "estimators/integral_invariant/surfel_sums.hpp"

#include "estimators/integral_invariant/distinct_points.hpp"
#include "estimators/integral_invariant/indicator.hpp"

namespace gridstep {

template <int d, class Sum>
void SurfelSums<d, Sum>::init(GridStep h, EuclideanLength R) {
  const DigitalLength radius = to_digital(R, h);
  kernels_.clear();
  balls_.clear();
  work_ = {};
  const bool on_surfels = options_.centre == KernelCentre::surfel;
  for (int axis = on_surfels ? 0 : -1; axis < (on_surfels ? d : 0); ++axis) {
    if (options_.evaluation == Evaluation::bricks) {
      balls_.emplace_back(radius, axis);
      work_.kernel_size = balls_.back().ball_size();
      continue;
    }
    Kernels kernels{ball_kernel<d>(radius, axis), {}};
    if (options_.evaluation == Evaluation::masks) {
      kernels.masks.emplace(kernels.kernel);
      for (const LatticePoint<d>& step : DisplacementMasks<d, std::int64_t>::steps())
        work_.mask_sizes.push_back(std::int64_t((*kernels.masks)[step].size()) / 2);
    }
    work_.kernel_size = std::int64_t(kernels.kernel.size());
    kernels_.push_back(std::move(kernels));
  }
}

template <int d, class Sum>
void SurfelSums<d, Sum>::add_work(const EvaluationWork& work) {
  work_.evaluations += work.points;
  work_.cells_visited += work.cells_visited;
  work_.restarts += work.restarts;
}

template <int d, class Sum>
std::vector<typename SurfelSums<d, Sum>::Pair> SurfelSums<d, Sum>::eval(std::span<const Surfel<d>> surfels) {
  expects(!kernels_.empty() || !balls_.empty(), "init() before eval()");
  work_.evaluations = work_.cells_visited = work_.restarts = 0;
  std::vector<Pair> result(surfels.size());
  if (balls_.empty()) {
    eval_kernels(surfels, result);
    return result;
  }
  constexpr std::size_t kBatch = (std::size_t{32} << 20) / sizeof(Pair);
  for (std::size_t begin = 0; begin < surfels.size(); begin += kBatch) {
    const std::size_t size = std::min(kBatch, surfels.size() - begin);
    eval_bricks(surfels.subspan(begin, size), std::span(result).subspan(begin, size));
  }
  return result;
}

template <int d, class Sum>
std::vector<Sum> SurfelSums<d, Sum>::convolve_at(const Kernels& kernels,
                                                 std::span<const LatticePoint<d>> points) {
  EvaluationWork work;
  auto sums = convolve<Sum>(Indicator<d>(set_), kernels.kernel, kernels.masks ? &*kernels.masks : nullptr,
                            points, &work);
  add_work(work);
  return sums;
}

template <int d, class Sum>
void SurfelSums<d, Sum>::eval_kernels(std::span<const Surfel<d>> surfels, std::span<Pair> result) {
  if (options_.centre == KernelCentre::spels) {
    std::vector<LatticePoint<d>> spels;
    spels.reserve(2 * surfels.size());
    for (const Surfel<d>& surfel : surfels) {
      spels.push_back(surfel.inner);
      spels.push_back(surfel.outer());
    }
    const DistinctPoints<d> distinct(std::move(spels));
    const std::vector<Sum> sums = convolve_at(kernels_.front(), distinct.points);
    for (std::size_t i = 0; i < surfels.size(); ++i)
      result[i] = {sums[distinct.position(surfels[i].inner)], sums[distinct.position(surfels[i].outer())]};
    return;
  }
  for (int axis = 0; axis < d; ++axis) {
    std::vector<LatticePoint<d>> spels;
    for (const Surfel<d>& surfel : surfels)
      if (surfel.axis == axis) spels.push_back(lower_spel(surfel));
    const DistinctPoints<d> distinct(std::move(spels));
    const std::vector<Sum> sums = convolve_at(kernels_[std::size_t(axis)], distinct.points);
    for (std::size_t i = 0; i < surfels.size(); ++i) {
      if (surfels[i].axis != axis) continue;
      const Sum& sum = sums[distinct.position(lower_spel(surfels[i]))];
      result[i] = {sum, sum};
    }
  }
}

template <int d, class Sum>
void SurfelSums<d, Sum>::eval_bricks(std::span<const Surfel<d>> surfels, std::span<Pair> result) {
  EvaluationWork work;
  typename bricks::SpelsByBrick<d>::Memo inner, outer;  // of the last surfel
  if (options_.centre == KernelCentre::spels) {
    bricks::SpelsByBrick<d> spels;
    for (const Surfel<d>& surfel : surfels) {
      spels.insert(surfel.inner, inner);
      spels.insert(surfel.outer(), outer);
    }
    spels.number();
    const std::vector<Sum> sums = balls_.front().eval(set_, spels, &work);
    for (std::size_t i = 0; i < surfels.size(); ++i)
      result[i] = {sums[spels.position(surfels[i].inner, inner)],
                   sums[spels.position(surfels[i].outer(), outer)]};
  } else {
    for (int axis = 0; axis < d; ++axis) {
      bricks::SpelsByBrick<d> spels;
      inner = {};
      for (const Surfel<d>& surfel : surfels)
        if (surfel.axis == axis) spels.insert(lower_spel(surfel), inner);
      spels.number();
      const std::vector<Sum> sums = balls_[std::size_t(axis)].eval(set_, spels, &work);
      for (std::size_t i = 0; i < surfels.size(); ++i) {
        if (surfels[i].axis != axis) continue;
        const Sum& sum = sums[spels.position(lower_spel(surfels[i]), inner)];
        result[i] = {sum, sum};
      }
    }
  }
  add_work(work);
}

template class SurfelSums<2, PlainSum<2, std::int64_t>>;
template class SurfelSums<3, PlainSum<3, std::int64_t>>;
template class SurfelSums<3, MomentSums<3, std::int64_t>>;

}  // namespace gridstep
