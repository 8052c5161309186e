#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "shapes/analytic/shape.hpp"
#include "shapes/base/placement.hpp"
#include "shapes/digital/boundary.hpp"
#include "shapes/digital/gauss_digitize.hpp"

namespace gridstep {

/// How a shape is turned into a digital set.
template <int d>
struct SceneSettings {
  GridStep h{1};
  Placement<d> placement;
  double noise = 0;  ///< beta of kanungo_noise(); 0: none
  std::uint64_t noise_seed = 0;
};

/// What estimators get to see: the digital set and its boundary.
template <int d>
struct Scene {
  SceneSettings<d> settings;
  DigitalSet<d> set;
  std::vector<Surfel<d>>
      surfels;                 ///< contours in walking order in 2D; with noise, the largest component alone
  std::size_t components = 0;  ///< of the boundary; only counted in 2D and with noise, else 0
  DigitizationWork work;
};

/// @throws InputError where the digital set has no boundary: the step is coarser than the shape.
template <int d>
Scene<d> make_scene(const Shape<d>& shape, const SceneSettings<d>& settings);

/// Whether surfels can be taken part by part: not in 2D and with noise, where they go by contours and components.
template <int d>
bool comes_in_parts(const SceneSettings<d>& settings) {
  return d == 3 && settings.noise == 0;
}

/// Calls visit(scene) with the scene's set and successive parts of its surfels, in the same order, of at most `most`
/// surfels each: for a boundary that is too large to be listed at once. Where it does not come in parts there is one, of
/// any size. The scene is the same object each time.
/// @throws InputError as make_scene().
template <int d>
void for_each_part(const Shape<d>& shape, const SceneSettings<d>& settings, std::size_t most,
                   const std::function<void(const Scene<d>&)>& visit);

/// The exact values at the boundary points closest to given points of the digital boundary: the answer key,
/// kept apart from the scene.
struct Truth {
  std::vector<std::string> quantities;
  std::vector<std::vector<double>> columns;  ///< columns[q][i] belongs to point i; 0 where known[i] is 0
  std::vector<std::uint8_t> known;
  std::int64_t singular = 0;  ///< points whose closest point is a corner, an edge or a singular point
  std::int64_t far = 0;  ///< with noise alone: points with no certified closest point within twelve cells
  double worst_residual = 0;  ///< relative to the size of the shape
};

/// Names: kappa; mean, gaussian, k1, k2; normal_x.., dir1_x.., dir2_x..; tangent_x... The tangent goes with
/// the shape on its left.
/// @param points in the unit of the shape, in the frame of the digital set
/// @param within how far the boundary may be from them in a scene without noise
/// @throws UncertifiedProjection where a point of a scene without noise has no certified closest point there.
template <int d>
Truth truth_at(const Shape<d>& shape, const SceneSettings<d>& settings,
               const std::vector<RealPoint<d>>& points, EuclideanLength within,
               const std::vector<std::string>& quantities);

/// The same at the surfels' centres. The boundary is within h/2, by Gauss digitization.
template <int d>
Truth truth_at_surfels(const Shape<d>& shape, const SceneSettings<d>& settings,
                       const std::vector<Surfel<d>>& surfels, const std::vector<std::string>& quantities);

}  // namespace gridstep
