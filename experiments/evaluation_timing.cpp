#include "experiments/catalogue.hpp"

namespace gridstep {

/// The whole kernel against displacement masks, as in the timing figures of Coeurjolly, Lachaud, Levallois,
/// CVIU 2014, and against bricks. Their sums are compared before a time is kept.
StudyEntry describe_evaluation_timing() {
  return {"evaluation-timing", "full kernel, displacement masks and bricks: equal sums, times, growth exponents",
          R"json({
  "name": "evaluation-timing",
  "description": "the cost of the whole kernel, of displacement masks and of bricks, one thread",
  "timing": true,
  "sweeps": [{
    "shapes": ["flower:radius=20,amplitude=7,petals=6"],
    "estimators": ["ii"],
    "evaluations": ["full", "masks", "bricks"],
    "radii": [{"k": 5}],
    "schedule": {"from": 0.5, "to": 0.02, "steps": 6},
    "shifts": 1
  }, {
    "shapes": ["sphere:radius=5"],
    "estimators": ["ii", "ii-covariance"],
    "evaluations": ["full", "masks", "bricks"],
    "radii": [{"k": 3}],
    "schedule": {"from": 0.5, "to": 0.1, "steps": 6},
    "shifts": 1
  }]
})json",
          R"json({
  "name": "evaluation-timing",
  "description": "the cost of the whole kernel, of displacement masks and of bricks, one thread",
  "timing": true,
  "sweeps": [{
    "shapes": ["flower:radius=20,amplitude=7,petals=6"],
    "estimators": ["ii"],
    "evaluations": ["full", "masks", "bricks"],
    "radii": [{"k": 5}],
    "schedule": {"from": 0.5, "to": 0.005, "steps": 12},
    "shifts": 3
  }, {
    "shapes": ["sphere:radius=5", "goursat"],
    "estimators": ["ii", "ii-covariance"],
    "evaluations": ["full", "masks", "bricks"],
    "radii": [{"k": 3}],
    "schedule": {"from": 0.5, "to": 0.08, "steps": 10},
    "shifts": 3
  }]
})json"};
}

}  // namespace gridstep
