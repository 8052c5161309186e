#include "experiments/catalogue.hpp"

namespace gridstep {

/// Mean, Gaussian and principal curvatures on the 3D shapes of Coeurjolly, Lachaud, Levallois, CVIU 2014,
/// with R = 3 h^(1/3). The blobby cube is ten times smaller than the others: its steps are too, and its k is
/// such that R is the same part of its size.
StudyEntry describe_paper_3d() {
  return {"paper-3d",
          "mean, Gaussian and principal curvatures on sphere, rounded cube, Goursat's surface, blobby cube",
          R"json({
  "name": "paper-3d",
  "description": "3D curvatures by integral invariants, R = 3 h^(1/3)",
  "sweeps": [{
    "shapes": ["sphere:radius=9", "rounded-cube:radius=9", "goursat"],
    "estimators": ["ii", "ii-covariance"],
    "radii": [{"k": 3}],
    "schedule": {"from": 1, "to": 0.2, "steps": 10},
    "shifts": 10
  }, {
    "shapes": ["blobby-cube"],
    "estimators": ["ii", "ii-covariance"],
    "radii": [{"k": 0.6463}],
    "schedule": {"from": 0.1, "to": 0.02, "steps": 10},
    "shifts": 10
  }]
})json",
          R"json({
  "name": "paper-3d",
  "description": "3D curvatures by integral invariants, R = 3 h^(1/3), the published range",
  "sweeps": [{
    "shapes": ["sphere:radius=9", "rounded-cube:radius=9", "goursat"],
    "estimators": ["ii", "ii-covariance"],
    "radii": [{"k": 3}],
    "schedule": {"papers": {"first": 0, "last": 32}},
    "shifts": 10
  }, {
    "shapes": ["blobby-cube"],
    "estimators": ["ii", "ii-covariance"],
    "radii": [{"k": 0.6463}],
    "schedule": {"papers": {"first": 23, "last": 55}},
    "shifts": 10
  }]
})json"};
}

}  // namespace gridstep
