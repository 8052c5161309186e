#include "estimators/integral_invariant/surfel_sums.hpp"

#include "estimators/integral_invariant/distinct_points.hpp"
#include "estimators/integral_invariant/indicator.hpp"
#include "shapes/base/parallel.hpp"

namespace gridstep {

namespace {

constexpr std::size_t kGrain = 256;

/// The spels that insert(i, spels, memos) puts into `spels`, for each i below `size`, numbered.
template <int d, class Insert>
bricks::SpelsByBrick<d> grouped(std::size_t size, Insert insert) {
  constexpr std::size_t kChunk = std::size_t{1} << 15;
  std::vector<bricks::SpelsByBrick<d>> parts(size / kChunk + 1);
  parallel_chunks(parts.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t part = begin; part != end; ++part) {
      std::array<typename bricks::SpelsByBrick<d>::Memo, 2> memos;  // of the last surfel
      for (std::size_t i = part * kChunk; i < std::min(size, (part + 1) * kChunk); ++i)
        insert(i, parts[part], memos);
    }
  });
  parts.front().merge(std::span(parts).subspan(1));
  parts.front().number();
  return std::move(parts.front());
}

}  // namespace

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
void SurfelSums<d, Sum>::eval(std::span<const Surfel<d>> surfels, const Use& use) {
  expects(!kernels_.empty() || !balls_.empty(), "init() before eval()");
  work_.evaluations = work_.cells_visited = work_.restarts = 0;
  if (balls_.empty()) {
    eval_kernels(surfels, use);
    return;
  }
  constexpr std::size_t kBatch = (std::size_t{16} << 20) / sizeof(Sum);
  for (std::size_t begin = 0; begin < surfels.size(); begin += kBatch)
    eval_bricks(surfels.subspan(begin, std::min(kBatch, surfels.size() - begin)), begin, use);
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
void SurfelSums<d, Sum>::eval_kernels(std::span<const Surfel<d>> surfels, const Use& use) {
  if (options_.centre == KernelCentre::spels) {
    std::vector<LatticePoint<d>> spels;
    spels.reserve(2 * surfels.size());
    for (const Surfel<d>& surfel : surfels) {
      spels.push_back(surfel.inner);
      spels.push_back(surfel.outer());
    }
    const DistinctPoints<d> distinct(std::move(spels));
    const std::vector<Sum> sums = convolve_at(kernels_.front(), distinct.points);
    parallel_chunks(surfels.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i != end; ++i)
        use(i, sums[distinct.position(surfels[i].inner)], sums[distinct.position(surfels[i].outer())]);
    });
    return;
  }
  for (int axis = 0; axis < d; ++axis) {
    std::vector<LatticePoint<d>> spels;
    for (const Surfel<d>& surfel : surfels)
      if (surfel.axis == axis) spels.push_back(lower_spel(surfel));
    const DistinctPoints<d> distinct(std::move(spels));
    const std::vector<Sum> sums = convolve_at(kernels_[std::size_t(axis)], distinct.points);
    parallel_chunks(surfels.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i != end; ++i) {
        if (surfels[i].axis != axis) continue;
        const Sum& sum = sums[distinct.position(lower_spel(surfels[i]))];
        use(i, sum, sum);
      }
    });
  }
}

template <int d, class Sum>
void SurfelSums<d, Sum>::eval_bricks(std::span<const Surfel<d>> surfels, std::size_t first, const Use& use) {
  using Spels = bricks::SpelsByBrick<d>;
  EvaluationWork work;
  if (options_.centre == KernelCentre::spels) {
    const Spels spels = grouped<d>(surfels.size(), [&](std::size_t i, Spels& part, auto& memos) {
      part.insert(surfels[i].inner, memos[0]);
      part.insert(surfels[i].outer(), memos[1]);
    });
    const auto sums = balls_.front().eval(set_, spels, &work);
    parallel_chunks(surfels.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      typename Spels::Memo inner, outer;
      for (std::size_t i = begin; i != end; ++i)
        use(first + i, sums[spels.position(surfels[i].inner, inner)],
            sums[spels.position(surfels[i].outer(), outer)]);
    });
  } else {
    for (int axis = 0; axis < d; ++axis) {
      const Spels spels = grouped<d>(surfels.size(), [&](std::size_t i, Spels& part, auto& memos) {
        if (surfels[i].axis == axis) part.insert(lower_spel(surfels[i]), memos[0]);
      });
      const auto sums = balls_[std::size_t(axis)].eval(set_, spels, &work);
      parallel_chunks(surfels.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        typename Spels::Memo memo;
        for (std::size_t i = begin; i != end; ++i) {
          if (surfels[i].axis != axis) continue;
          const Sum& sum = sums[spels.position(lower_spel(surfels[i]), memo)];
          use(first + i, sum, sum);
        }
      });
    }
  }
  add_work(work);
}

template class SurfelSums<2, PlainSum<2, std::int64_t>>;
template class SurfelSums<2, MomentSums<2, std::int64_t>>;
template class SurfelSums<3, PlainSum<3, std::int64_t>>;
template class SurfelSums<3, MomentSums<3, std::int64_t>>;

}  // namespace gridstep
