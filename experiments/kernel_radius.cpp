#include "experiments/catalogue.hpp"

namespace gridstep {

/// Error against k of R = k h^(1/3), for each estimator that takes a radius, with the optimum: where the usual k come from.
StudyEntry describe_kernel_radius() {
  return {"kernel-radius", "error against the k of R = k h^(1/3), with the best one, for each estimator and shape",
          R"json({
  "name": "kernel-radius",
  "description": "error against k",
  "tables": ["best-radius"],
  "sweeps": [{
    "shapes": ["ellipse:a=20,b=7,angle=0.3", "flower:radius=20,amplitude=5,petals=5"],
    "estimators": ["ii", "ii-pf1", "ii-ho1", "ii-ho2"],
    "radii": [{"k": 2}, {"k": 3}, {"k": 4}, {"k": 5}, {"k": 6.5}, {"k": 8}, {"k": 10}, {"k": 12}],
    "schedule": {"values": [0.4, 0.2, 0.1, 0.05, 0.025]},
    "shifts": 3
  }, {
    "shapes": ["ellipsoid:a=9,b=7,c=5", "goursat", "torus:major=6,minor=2"],
    "estimators": ["ii", "ii-pf1", "ii-ho1", "ii-ho1-guarded", "ii-ho2", "icnc"],
    "radii": [{"k": 2}, {"k": 3}, {"k": 4}, {"k": 5}, {"k": 6.75}, {"k": 8}, {"k": 10}],
    "schedule": {"values": [1.4, 1, 0.7, 0.5, 0.35]},
    "shifts": 2
  }]
})json",
          R"json({
  "name": "kernel-radius",
  "description": "error against k",
  "tables": ["best-radius"],
  "sweeps": [{
    "shapes": ["ellipse:a=20,b=7,angle=0.3", "flower:radius=20,amplitude=5,petals=5",
               "flower:radius=20,amplitude=10,petals=6,phase=3", "lpball:radius=15,power=4"],
    "estimators": ["ii", "ii-pf1", "ii-ho1", "ii-ho2"],
    "radii": [{"k": 2}, {"k": 3}, {"k": 4}, {"k": 5}, {"k": 6.5}, {"k": 8}, {"k": 10}, {"k": 12}],
    "schedule": {"values": [0.4, 0.2, 0.1, 0.05, 0.025, 0.0125]},
    "shifts": 10
  }, {
    "shapes": ["ellipsoid:a=9,b=7,c=5", "goursat", "torus:major=6,minor=2", "sphere:radius=9", "rounded-cube:radius=9"],
    "estimators": ["ii", "ii-covariance", "ii-pf1", "ii-ho1", "ii-ho1-guarded", "ii-ho2", "icnc", "ccnc", "vcm"],
    "radii": [{"k": 2}, {"k": 3}, {"k": 4}, {"k": 5}, {"k": 6.75}, {"k": 8}, {"k": 10}],
    "schedule": {"values": [1, 0.7, 0.5, 0.35, 0.25, 0.125]},
    "shifts": 10
  }]
})json"};
}

}  // namespace gridstep
