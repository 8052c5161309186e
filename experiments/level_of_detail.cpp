#include "experiments/catalogue.hpp"

namespace gridstep {

/// A surface at several radii: what a small kernel resolves, a large one smooths, as in Fig. 3 of Coeurjolly, Lachaud,
/// Levallois, DGCI 2013, where the surface is that of a volume. Goursat's surface stands in for one, at steps that leave it
/// small enough for the page.
StudyEntry describe_level_of_detail() {
  return {"level-of-detail",
          "curvatures of a surface at several radii side by side; of any volume with --volume FILE",
          R"json({
  "name": "level-of-detail",
  "description": "all curvatures of one digital surface at several radii, in voxels",
  "detail": {
    "shape": "goursat",
    "h": 0.25,
    "estimator": "ii-covariance",
    "digital_radii": [14, 7]
  }
})json",
          R"json({
  "name": "level-of-detail",
  "description": "all curvatures of one digital surface at several radii, in voxels",
  "detail": {
    "shape": "goursat",
    "h": 0.125,
    "estimator": "ii-covariance",
    "digital_radii": [28, 20, 14, 10, 7, 5]
  }
})json"};
}

}  // namespace gridstep
