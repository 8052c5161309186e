#include "experiments/catalogue.hpp"

namespace gridstep {

/// Curvature on the 2D shapes of Coeurjolly, Lachaud, Levallois, "Multigrid convergent principal curvature
/// estimators in digital geometry", CVIU 2014, with R = 5 h^(1/3); the full range ends at h = e^-8.7
/// = 1.67e-4.
StudyEntry describe_paper_2d() {
  return {"paper-2d", "curvature by integral invariants on ellipse, flower and accelerated flower",
          R"json({
  "name": "paper-2d",
  "description": "2D curvature by integral invariants, R = 5 h^(1/3)",
  "sweeps": [{
    "shapes": ["ellipse:a=20,b=7", "flower:radius=20,amplitude=7,petals=6", "accflower:radius=20,amplitude=7,petals=3"],
    "estimators": ["ii"],
    "radii": [{"k": 5}],
    "schedule": {"from": 1, "to": 0.005, "steps": 16},
    "shifts": 10
  }]
})json",
          R"json({
  "name": "paper-2d",
  "description": "2D curvature by integral invariants, R = 5 h^(1/3), the published range",
  "sweeps": [{
    "shapes": ["ellipse:a=20,b=7", "flower:radius=20,amplitude=7,petals=6", "accflower:radius=20,amplitude=7,petals=3"],
    "estimators": ["ii"],
    "radii": [{"k": 5}],
    "schedule": {"papers": {"first": 0, "last": 87}},
    "shifts": 10
  }]
})json"};
}

}  // namespace gridstep
