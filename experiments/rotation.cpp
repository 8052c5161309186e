#include "experiments/catalogue.hpp"

namespace gridstep {

/// Whether errors depend on how a shape lies on the grid: as many shifts without as with a random rotation. The sphere is
/// the check on the study itself, as a rotation does nothing to it; the ellipse, the ellipsoid and what is flat or square
/// along the axes are where a lattice would show.
StudyEntry describe_rotation() {
  return {"rotation", "is the error isotropic? As many random shifts without as with a random rotation",
          R"json({
  "name": "rotation",
  "description": "errors under shifts, and under shifts with rotations",
  "tables": ["isotropy"],
  "sweeps": [{
    "shapes": ["disk:radius=15", "ellipse:a=20,b=7", "flower:radius=20,amplitude=5,petals=5",
               "lpball:radius=15,power=4"],
    "estimators": ["ii", "ii-parameter-free", "ii-pf1", "ii-ho1", "mdca", "lambda-mdca", "bc", "lambda-mst"],
    "schedule": {"values": [0.4, 0.25, 0.16, 0.1, 0.0625]},
    "shifts": 20
  }, {
    "shapes": ["disk:radius=15", "ellipse:a=20,b=7", "flower:radius=20,amplitude=5,petals=5",
               "lpball:radius=15,power=4"],
    "estimators": ["ii", "ii-parameter-free", "ii-pf1", "ii-ho1", "mdca", "lambda-mdca", "bc", "lambda-mst"],
    "schedule": {"values": [0.4, 0.25, 0.16, 0.1, 0.0625]},
    "shifts": 20,
    "rotate": true
  }, {
    "shapes": ["sphere:radius=9", "ellipsoid:a=9,b=7,c=5", "goursat"],
    "estimators": ["ii", "ii-covariance", "ii-pf1", "ii-ho1", "icnc", "ccnc", "vcm"],
    "schedule": {"values": [1.4, 1.1, 0.9, 0.7, 0.5]},
    "shifts": 10
  }, {
    "shapes": ["sphere:radius=9", "ellipsoid:a=9,b=7,c=5", "goursat"],
    "estimators": ["ii", "ii-covariance", "ii-pf1", "ii-ho1", "icnc", "ccnc", "vcm"],
    "schedule": {"values": [1.4, 1.1, 0.9, 0.7, 0.5]},
    "shifts": 10,
    "rotate": true
  }]
})json",
          R"json({
  "name": "rotation",
  "description": "errors under shifts, and under shifts with rotations",
  "tables": ["isotropy"],
  "sweeps": [{
    "shapes": ["disk:radius=15", "ellipse:a=20,b=7", "flower:radius=20,amplitude=5,petals=5",
               "lpball:radius=15,power=4"],
    "estimators": ["ii", "ii-parameter-free", "ii-pf1", "ii-ho1", "mdca", "lambda-mdca", "bc", "lambda-mst"],
    "schedule": {"values": [0.4, 0.2, 0.1, 0.05, 0.025]},
    "shifts": 100
  }, {
    "shapes": ["disk:radius=15", "ellipse:a=20,b=7", "flower:radius=20,amplitude=5,petals=5",
               "lpball:radius=15,power=4"],
    "estimators": ["ii", "ii-parameter-free", "ii-pf1", "ii-ho1", "mdca", "lambda-mdca", "bc", "lambda-mst"],
    "schedule": {"values": [0.4, 0.2, 0.1, 0.05, 0.025]},
    "shifts": 100,
    "rotate": true
  }, {
    "shapes": ["sphere:radius=9", "ellipsoid:a=9,b=7,c=5", "goursat", "rounded-cube:radius=9"],
    "estimators": ["ii", "ii-covariance", "ii-pf1", "ii-ho1", "ii-ho1-guarded", "icnc", "ccnc", "vcm"],
    "schedule": {"values": [1, 0.7, 0.5, 0.35, 0.25]},
    "shifts": 40
  }, {
    "shapes": ["sphere:radius=9", "ellipsoid:a=9,b=7,c=5", "goursat", "rounded-cube:radius=9"],
    "estimators": ["ii", "ii-covariance", "ii-pf1", "ii-ho1", "ii-ho1-guarded", "icnc", "ccnc", "vcm"],
    "schedule": {"values": [1, 0.7, 0.5, 0.35, 0.25]},
    "shifts": 40,
    "rotate": true
  }]
})json"};
}

}  // namespace gridstep
