#include "experiments/catalogue.hpp"

namespace gridstep {

/// How far Kanungo noise disturbs the estimates. Theory says nothing of noise: verdicts are on convergence at all.
StudyEntry describe_noise() {
  return {"noise",
          "curvature of noisy digitizations: Kanungo noise, beta from 0 to 0.5, the largest component kept",
          R"json({
  "name": "noise",
  "description": "curvature under Kanungo noise; the largest component of the boundary",
  "sweeps": [{
    "shapes": ["flower:radius=20,amplitude=7,petals=6"],
    "estimators": ["ii"],
    "radii": [{"k": 5}],
    "noise": [0, 0.1, 0.25, 0.5],
    "schedule": {"from": 0.5, "to": 0.025, "steps": 10},
    "shifts": 10
  }, {
    "shapes": ["goursat"],
    "estimators": ["ii-covariance"],
    "radii": [{"k": 3}],
    "noise": [0, 0.1, 0.25, 0.5],
    "schedule": {"from": 1, "to": 0.5, "steps": 5},
    "shifts": 3
  }]
})json",
          R"json({
  "name": "noise",
  "description": "curvature under Kanungo noise; the largest component of the boundary",
  "sweeps": [{
    "shapes": ["ellipse:a=20,b=7", "flower:radius=20,amplitude=7,petals=6"],
    "estimators": ["ii"],
    "radii": [{"k": 5}],
    "noise": [0, 0.1, 0.2, 0.3, 0.4, 0.5],
    "schedule": {"papers": {"first": 5, "last": 50}},
    "shifts": 10
  }, {
    "shapes": ["sphere:radius=9", "goursat"],
    "estimators": ["ii-covariance"],
    "radii": [{"k": 3}],
    "noise": [0, 0.1, 0.25, 0.5],
    "schedule": {"papers": {"first": 0, "last": 20}},
    "shifts": 5
  }]
})json"};
}

}  // namespace gridstep
