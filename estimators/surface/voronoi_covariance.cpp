#include "estimators/surface/voronoi_covariance.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "estimators/integral_invariant/kernel.hpp"
#include "shapes/base/parallel.hpp"

namespace gridstep {

namespace {

constexpr int kBlockShift = 6;  // sites are evaluated by blocks of 64 points a side
constexpr std::int32_t kFar = 1 << 28;

LatticePoint<3> block_of(const LatticePoint<3>& z) {
  return {z[0] >> kBlockShift, z[1] >> kBlockShift, z[2] >> kBlockShift};
}

/// The lattice vectors of each squared length up to r2.
class Shells {
 public:
  explicit Shells(std::int64_t r2) : begin_(std::size_t(r2) + 2, 0) {
    const int r = int(std::sqrt(double(r2)));
    const LatticeBox<3> box{LatticePoint<3>::Constant(-r), LatticePoint<3>::Constant(r)};
    for_each_point(box, [&](const LatticePoint<3>& z) {
      if (z.squaredNorm() <= r2) ++begin_[std::size_t(z.squaredNorm()) + 1];
    });
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    vectors_.resize(begin_.back());
    std::vector<std::size_t> next(begin_);
    for_each_point(box, [&](const LatticePoint<3>& z) {
      if (z.squaredNorm() <= r2) vectors_[next[std::size_t(z.squaredNorm())]++] = z;
    });
  }
  std::span<const LatticePoint<3>> operator[](std::int32_t squared) const {
    const std::size_t begin = begin_[std::size_t(squared)];
    return std::span(vectors_).subspan(begin, begin_[std::size_t(squared) + 1] - begin);
  }

 private:
  std::vector<std::size_t> begin_;
  std::vector<LatticePoint<3>> vectors_;
};

/// A dense array over a box.
template <class T>
struct Grid {
  LatticeBox<3> box;
  std::vector<T> values;

  Grid(const LatticeBox<3>& over, T value) : box(over), values(std::size_t(over.volume()), value) {}
  std::size_t index(const LatticePoint<3>& z) const {
    const LatticePoint<3> extent = box.extent(), at = z - box.lo;
    return std::size_t(at[0]) +
           std::size_t(extent[0]) * (std::size_t(at[1]) + std::size_t(extent[1]) * std::size_t(at[2]));
  }
  T& operator[](const LatticePoint<3>& z) { return values[index(z)]; }
};

/// Replaces each value by the least of value + distance^2 over the points at most r away along an axis.
void nearest_along(Grid<std::int32_t>& squared, int axis, int r) {
  const LatticePoint<3> extent = squared.box.extent();
  const std::size_t step = axis == 0 ? 1 : std::size_t(extent[0]) * (axis == 1 ? 1 : std::size_t(extent[1]));
  // Lines along the axis go in groups that lie side by side in memory: `step` of them.
  const std::size_t n = std::size_t(extent[axis]), groups = squared.values.size() / (n * step);
  std::vector<std::int32_t> before(n * step);
  for (std::size_t group = 0; group < groups; ++group) {
    std::int32_t* const values = &squared.values[group * n * step];
    std::copy_n(values, n * step, before.begin());
    if (std::all_of(before.begin(), before.end(), [](std::int32_t value) { return value == kFar; })) continue;
    for (int d = -r; d <= r; ++d) {
      const std::ptrdiff_t shift = d * std::ptrdiff_t(step);
      const std::size_t begin = std::size_t(std::max<std::ptrdiff_t>(0, -shift)),
                        end = std::size_t(std::ptrdiff_t(n * step) - std::max<std::ptrdiff_t>(0, shift));
      for (std::size_t i = begin; i < end; ++i)
        values[i] = std::min(values[i], before[std::size_t(std::ptrdiff_t(i) + shift)] + d * d);
    }
  }
}

/// V of the sites in a box, from those near it: numbers into `sites`.
void evaluate_box(std::span<const LatticePoint<3>> sites, const LatticeBox<3>& own,
                  std::span<const std::uint32_t> near, std::int64_t r2, const Shells& shells,
                  std::vector<Eigen::Matrix3d>& result) {
  const int r = int(std::sqrt(double(r2)));
  const LatticeBox<3> points = own.dilated(r), around = own.dilated(2 * r);
  constexpr std::uint32_t kNoSite = ~std::uint32_t{0};
  Grid<std::uint32_t> site_at(around, kNoSite);
  Grid<std::int32_t> squared(around, kFar);
  for (const std::uint32_t i : near) {
    if (!around.contains(sites[i])) continue;
    site_at[sites[i]] = i;
    squared[sites[i]] = 0;
  }
  for (int axis = 0; axis < 3; ++axis) nearest_along(squared, axis, r);

  std::vector<std::uint32_t> nearest;
  for_each_point(points, [&](const LatticePoint<3>& p) {
    const std::int32_t distance = squared[p];
    if (distance == 0 || distance > r2) return;
    nearest.clear();
    for (const LatticePoint<3>& offset : shells[distance])
      if (const std::uint32_t i = site_at[p + offset]; i != kNoSite) nearest.push_back(i);
    for (const std::uint32_t i : nearest) {
      if (!own.contains(sites[i])) continue;
      const Eigen::Vector3d offset = (p - sites[i]).cast<double>();
      result[i] += offset * offset.transpose() / double(nearest.size());
    }
  });
}

}  // namespace

std::vector<Eigen::Matrix3d> voronoi_covariances(std::span<const LatticePoint<3>> sites, DigitalLength R) {
  const std::int64_t r2 = squared_diameter(R) / 4;
  std::vector<Eigen::Matrix3d> result(sites.size(), Eigen::Matrix3d::Zero());
  std::vector<LatticePoint<3>> blocks;
  for (const LatticePoint<3>& site : sites)
    if (blocks.empty() || blocks.back() != block_of(site)) blocks.push_back(block_of(site));
  std::sort(blocks.begin(), blocks.end(), raster_less<3>);
  blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
  std::vector<std::vector<std::uint32_t>> of_block(blocks.size());
  const auto number_of = [&](const LatticePoint<3>& block) {
    const auto found = std::lower_bound(blocks.begin(), blocks.end(), block, raster_less<3>);
    return found != blocks.end() && *found == block ? found - blocks.begin() : -1;
  };
  for (std::uint32_t i = 0; i < sites.size(); ++i)
    of_block[std::size_t(number_of(block_of(sites[i])))].push_back(i);

  const Shells shells(r2);
  const int blocks_away = int(std::ceil(2 * R.value / (1 << kBlockShift)));
  parallel_chunks(blocks.size(), 1, [&](std::size_t begin, std::size_t end) {
    std::vector<std::uint32_t> near;
    for (std::size_t b = begin; b != end; ++b) {
      near.clear();
      for_each_point(LatticeBox<3>{blocks[b], blocks[b]}.dilated(blocks_away),
                     [&](const LatticePoint<3>& other) {
                       if (const auto number = number_of(other); number >= 0)
                         near.insert(near.end(), of_block[std::size_t(number)].begin(),
                                     of_block[std::size_t(number)].end());
                     });
      LatticeBox<3> own{sites[of_block[b].front()], sites[of_block[b].front()]};
      for (const std::uint32_t i : of_block[b]) own = {own.lo.cwiseMin(sites[i]), own.hi.cwiseMax(sites[i])};
      evaluate_box(sites, own, near, r2, shells, result);
    }
  });
  return result;
}

}  // namespace gridstep
