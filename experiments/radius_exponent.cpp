#include "experiments/catalogue.hpp"

namespace gridstep {

/// R = 5 h^alpha for the exponents that Coeurjolly, Lachaud, Levallois, CVIU 2014 compare on the ellipse.
StudyEntry describe_radius_exponent() {
  return {"radius-exponent", "the slope against alpha in R = k h^alpha, on the ellipse",
          R"json({
  "name": "radius-exponent",
  "description": "2D curvature on the ellipse, R = 5 h^alpha",
  "sweeps": [{
    "shapes": ["ellipse:a=20,b=7"],
    "estimators": ["ii"],
    "radii": [{"k": 5, "alpha": 0.5}, {"k": 5, "alpha": 0.4}, {"k": 5, "alpha": 0.3333333333333333},
              {"k": 5, "alpha": 0.2857142857142857}, {"k": 5, "alpha": 0.25}],
    "schedule": {"from": 1, "to": 0.005, "steps": 16},
    "shifts": 10
  }]
})json",
          R"json({
  "name": "radius-exponent",
  "description": "2D curvature on the ellipse, R = 5 h^alpha, the published range",
  "sweeps": [{
    "shapes": ["ellipse:a=20,b=7"],
    "estimators": ["ii"],
    "radii": [{"k": 5, "alpha": 0.5}, {"k": 5, "alpha": 0.4}, {"k": 5, "alpha": 0.3333333333333333},
              {"k": 5, "alpha": 0.2857142857142857}, {"k": 5, "alpha": 0.25}],
    "schedule": {"papers": {"first": 0, "last": 75}},
    "shifts": 10
  }]
})json"};
}

}  // namespace gridstep
