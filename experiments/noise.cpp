#include "experiments/catalogue.hpp"

namespace gridstep {

/// How far Kanungo noise disturbs the estimates, of every estimator with its usual radius. Theory says nothing of noise:
/// verdicts are on convergence at all. No estimator refuses a noisy boundary; the errors of those that follow each linel
/// (maximal segments and arcs) do not fall as h does, which the table `noise` marks, and corrected currents fail by far at
/// few faces.
StudyEntry describe_noise() {
  return {"noise",
          "all estimators on noisy digitizations: Kanungo noise, beta from 0 to 0.5, the largest component kept",
          R"json({
  "name": "noise",
  "description": "errors under Kanungo noise; the largest component of the boundary",
  "tables": ["noise"],
  "sweeps": [{
    "shapes": ["ellipse:a=20,b=7,angle=0.3", "flower:radius=20,amplitude=7,petals=6"],
    "estimators": ["ii", "ii-parameter-free", "ii-pf1", "ii-ho1", "mdca", "lambda-mdca", "bc",
                   "mdss-length", "mdss-length-width", "mst", "lambda-mst"],
    "noise": [0, 0.1, 0.2, 0.3, 0.4, 0.5],
    "schedule": {"from": 0.5, "to": 0.05, "steps": 7},
    "shifts": 5
  }, {
    "shapes": ["goursat"],
    "estimators": ["ii", "ii-covariance", "ii-pf1", "ii-ho1", "ii-ho1-guarded", "icnc", "ccnc", "vcm"],
    "noise": [0, 0.1, 0.2, 0.3, 0.4, 0.5],
    "schedule": {"from": 1.4, "to": 0.6, "steps": 5},
    "shifts": 2
  }]
})json",
          R"json({
  "name": "noise",
  "description": "errors under Kanungo noise; the largest component of the boundary",
  "tables": ["noise"],
  "sweeps": [{
    "shapes": ["ellipse:a=20,b=7,angle=0.3", "flower:radius=20,amplitude=7,petals=6"],
    "estimators": ["ii", "ii-parameter-free", "ii-pf1", "ii-ho1", "mdca", "lambda-mdca", "bc",
                   "mdss-length", "mdss-length-width", "mst", "lambda-mst"],
    "noise": [0, 0.1, 0.2, 0.3, 0.4, 0.5],
    "schedule": {"papers": {"first": 5, "last": 50}},
    "shifts": 10
  }, {
    "shapes": ["sphere:radius=9", "ellipsoid:a=9,b=7,c=5", "goursat"],
    "estimators": ["ii", "ii-covariance", "ii-pf1", "ii-ho1", "ii-ho1-guarded", "icnc", "ccnc", "vcm"],
    "noise": [0, 0.1, 0.2, 0.3, 0.4, 0.5],
    "schedule": {"papers": {"first": 0, "last": 20}},
    "shifts": 5
  }]
})json"};
}

}  // namespace gridstep
