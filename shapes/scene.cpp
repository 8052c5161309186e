#include "shapes/scene.hpp"

#include <fmt/format.h>
#include "shapes/base/parallel.hpp"
#include "shapes/digital/kanungo_noise.hpp"

namespace gridstep {

namespace {

/// Without surfels.
template <int d>
Scene<d> digitized_scene(const Shape<d>& shape, const SceneSettings<d>& settings) {
  DigitizationWork work;
  const PlacedRegion<d> placed(shape, settings.placement, settings.h);
  DigitalSet<d> set = gauss_digitize<d>(placed, settings.h, &work);
  if (settings.noise > 0) set = kanungo_noise(set, settings.noise, settings.noise_seed);
  return {settings, std::move(set), {}, 0, work};
}

[[noreturn]] void throw_empty(GridStep h) {
  throw InputError(
      fmt::format("h = {}: the digital set is empty; the grid step is coarser than the shape", h.value));
}

/// How to read a quantity off a boundary point. @throws ContractViolation where there is none of that name.
template <int d>
std::function<double(const BoundaryPoint<d>&)> reader_of(const std::string& name) {
  using Point = BoundaryPoint<d>;
  for (int k = 0; k < d; ++k) {
    const std::string end = std::string("_") + "xyz"[k];
    if (name == "normal" + end) return [k](const Point& p) { return p.normal[k]; };
    if (name == (d == 2 ? "tangent" : "dir1") + end) return [k](const Point& p) { return p.direction[0][k]; };
    if constexpr (d == 3)
      if (name == "dir2" + end) return [k](const Point& p) { return p.direction[1][k]; };
  }
  if constexpr (d == 2) {
    if (name == "kappa") return [](const Point& p) { return p.curvature[0]; };
  } else {
    if (name == "mean") return [](const Point& p) { return (p.curvature[0] + p.curvature[1]) / 2; };
    if (name == "gaussian") return [](const Point& p) { return p.curvature[0] * p.curvature[1]; };
    if (name == "k1") return [](const Point& p) { return p.curvature[0]; };
    if (name == "k2") return [](const Point& p) { return p.curvature[1]; };
  }
  throw ContractViolation("expected a quantity of differential geometry, not '" + name + "'");
}

}  // namespace

template <int d>
Scene<d> make_scene(const Shape<d>& shape, const SceneSettings<d>& settings) {
  Scene<d> scene = digitized_scene(shape, settings);
  if (!comes_in_parts(settings)) {
    DigitalSurface<d> surface = connected_boundary(scene.set);
    scene.components = surface.components();
    if (settings.noise > 0 && scene.components > 1) surface.surfels.resize(surface.component_begin[1]);
    scene.surfels = std::move(surface.surfels);
  } else {
    scene.surfels = boundary(scene.set);
  }
  if (scene.surfels.empty()) throw_empty(settings.h);
  return scene;
}

template <int d>
void for_each_part(const Shape<d>& shape, const SceneSettings<d>& settings, std::size_t most,
                   const std::function<void(const Scene<d>&)>& visit) {
  if (!comes_in_parts(settings)) return visit(make_scene(shape, settings));
  Scene<d> scene = digitized_scene(shape, settings);
  bool empty = true;
  for_each_boundary_chunk<d>(scene.set, most, [&](std::span<const Surfel<d>> surfels) {
    empty = false;
    scene.surfels.assign(surfels.begin(), surfels.end());
    visit(scene);
  });
  if (empty) throw_empty(settings.h);
}

template <int d>
Truth truth_at(const Shape<d>& shape, const SceneSettings<d>& settings,
               const std::vector<RealPoint<d>>& points, EuclideanLength within,
               const std::vector<std::string>& quantities) {
  const GridStep h = settings.h;
  const bool noisy = settings.noise > 0;
  if (noisy) within.value = 12 * h.value;
  Truth truth;
  truth.quantities = quantities;
  truth.columns.assign(quantities.size(), std::vector<double>(points.size(), 0.0));
  truth.known.assign(points.size(), 0);
  std::vector<std::function<double(const BoundaryPoint<d>&)>> readers;
  for (const std::string& quantity : quantities) readers.push_back(reader_of<d>(quantity));
  struct Tally {
    std::int64_t singular = 0, far = 0;
    double worst_residual = 0;
  };
  PerWorker<Tally> tallies;
  parallel_chunks(points.size(), 64, [&](std::size_t begin, std::size_t end) {
    Tally& tally = tallies.local();
    for (std::size_t i = begin; i != end; ++i) {
      std::optional<BoundaryPoint<d>> point;
      try {
        point = shape.project(settings.placement.to_shape(points[i], h), within);
      } catch (const UncertifiedProjection&) {
        if (!noisy) throw;
        ++tally.far;
        continue;
      }
      if (!point) {
        ++tally.singular;
        continue;
      }
      point->normal = settings.placement.direction_to_world(point->normal);
      for (RealPoint<d>& direction : point->direction)
        direction = settings.placement.direction_to_world(direction);
      truth.known[i] = 1;
      tally.worst_residual = std::max(tally.worst_residual, point->residual);
      for (std::size_t q = 0; q < quantities.size(); ++q) truth.columns[q][i] = readers[q](*point);
    }
  });
  tallies.for_each([&](const Tally& tally) {
    truth.singular += tally.singular;
    truth.far += tally.far;
    truth.worst_residual = std::max(truth.worst_residual, tally.worst_residual);
  });
  return truth;
}

template <int d>
Truth truth_at_surfels(const Shape<d>& shape, const SceneSettings<d>& settings,
                       const std::vector<Surfel<d>>& surfels, const std::vector<std::string>& quantities) {
  std::vector<RealPoint<d>> points;
  points.reserve(surfels.size());
  for (const Surfel<d>& surfel : surfels) points.push_back(centre(surfel, settings.h.value));
  // An inner and an outer point are h apart, the boundary passes between them; the slack is for their
  // rounding.
  return truth_at<d>(shape, settings, points, {0.5 * settings.h.value * (1 + 1e-9)}, quantities);
}

#define GRIDSTEP_INSTANTIATE(d)                                                                            \
  template Scene<d> make_scene(const Shape<d>&, const SceneSettings<d>&);                                  \
  template void for_each_part(const Shape<d>&, const SceneSettings<d>&, std::size_t,                       \
                              const std::function<void(const Scene<d>&)>&);                                \
  template Truth truth_at(const Shape<d>&, const SceneSettings<d>&, const std::vector<RealPoint<d>>&,      \
                          EuclideanLength, const std::vector<std::string>&);                               \
  template Truth truth_at_surfels(const Shape<d>&, const SceneSettings<d>&, const std::vector<Surfel<d>>&, \
                                  const std::vector<std::string>&);
GRIDSTEP_INSTANTIATE(2)
GRIDSTEP_INSTANTIATE(3)
#undef GRIDSTEP_INSTANTIATE

}  // namespace gridstep
