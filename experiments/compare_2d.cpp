#include "experiments/catalogue.hpp"

namespace gridstep {

/// All 2D estimators on the same contours with the same truth, as the comparisons of Roussillon & Lachaud,
/// IWCIA 2011, and of Coeurjolly, Lachaud, Levallois, CVIU 2014, made them; once more under noise; and on the shapes of
/// the former (15 and 10 are half axes and least and largest radii there).
StudyEntry describe_compare_2d() {
  return {"compare-2d", "all 2D estimators of curvature and tangent on the same contours: errors, time, noise",
          R"json({
  "name": "compare-2d",
  "description": "2D curvature and tangent, all estimators; lpball is a square with round corners",
  "timing": true,
  "tables": ["convergence", "cost", "work-precision", "equal-error"],
  "sweeps": [{
    "shapes": ["ellipse:a=20,b=7", "flower:radius=20,amplitude=7,petals=6",
               "accflower:radius=20,amplitude=7,petals=3", "lpball:radius=15,power=4"],
    "estimators": ["ii", "ii-parameter-free", "mdca", "lambda-mdca", "mdss-length", "mdss-length-width", "bc",
                   "mst", "lambda-mst"],
    "radii": [{"k": 5}],
    "schedule": {"from": 1, "to": 0.02, "steps": 10},
    "shifts": 10
  }, {
    "shapes": ["ellipse:a=20,b=7", "flower:radius=20,amplitude=7,petals=6"],
    "estimators": ["ii", "ii-parameter-free", "mdca", "lambda-mdca", "mdss-length", "mdss-length-width", "bc",
                   "mst", "lambda-mst"],
    "radii": [{"k": 5}],
    "noise": [0.3],
    "schedule": {"from": 0.5, "to": 0.1, "steps": 5},
    "shifts": 10
  }, {
    "shapes": ["ellipse:a=15,b=10,angle=0.333", "flower:radius=12.5,amplitude=2.5,petals=5"],
    "estimators": ["ii", "mdca", "lambda-mdca", "bc"],
    "radii": [{"k": 3}],
    "schedule": {"values": [1, 0.316, 0.1, 0.0316, 0.01]},
    "shifts": 10
  }]
})json",
          R"json({
  "name": "compare-2d",
  "description": "2D curvature and tangent, all estimators; lpball is a square with round corners",
  "timing": true,
  "tables": ["convergence", "cost", "work-precision", "equal-error"],
  "sweeps": [{
    "shapes": ["ellipse:a=20,b=7", "flower:radius=20,amplitude=7,petals=6",
               "accflower:radius=20,amplitude=7,petals=3", "lpball:radius=15,power=4"],
    "estimators": ["ii", "ii-parameter-free", "mdca", "lambda-mdca", "mdss-length", "mdss-length-width", "bc",
                   "mst", "lambda-mst"],
    "radii": [{"k": 5}],
    "schedule": {"from": 1, "to": 0.002, "steps": 16},
    "shifts": 10
  }, {
    "shapes": ["ellipse:a=20,b=7", "flower:radius=20,amplitude=7,petals=6"],
    "estimators": ["ii", "ii-parameter-free", "mdca", "lambda-mdca", "mdss-length", "mdss-length-width", "bc",
                   "mst", "lambda-mst"],
    "radii": [{"k": 5}],
    "noise": [0.1, 0.3, 0.5],
    "schedule": {"from": 0.5, "to": 0.01, "steps": 10},
    "shifts": 10
  }, {
    "shapes": ["ellipse:a=15,b=10,angle=0.333", "flower:radius=12.5,amplitude=2.5,petals=5"],
    "estimators": ["ii", "mdca", "lambda-mdca", "bc"],
    "radii": [{"k": 3}],
    "schedule": {"values": [1, 0.316, 0.1, 0.0316, 0.01]},
    "shifts": 10
  }]
})json"};
}

}  // namespace gridstep
