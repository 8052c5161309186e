#include <fmt/format.h>

#include <string>

#include "experiments/catalogue.hpp"

namespace gridstep {

namespace {

/// Sizes differ in their steps, a list of numbers, and in the number of shifts.
std::string study(const char* steps_2d, int shifts_2d, const char* steps_3d, int shifts_3d) {
  return fmt::format(
      R"json({{
  "name": "accuracy-frontier",
  "description": "errors at equal h, usual radii",
  "timing": true,
  "tables": ["convergence", "cost", "work-precision", "equal-error"],
  "sweeps": [{{
    "shapes": ["ellipse:a=20,b=7,angle=0.3", "flower:radius=20,amplitude=5,petals=5",
               "flower:radius=20,amplitude=10,petals=6,phase=3", "lpball:radius=15,power=4"],
    "estimators": ["ii", "ii-parameter-free", "ii-pf1", "ii-ho1", "ii-ho2", "mdca", "lambda-mdca", "bc", "mdss-length"],
    "schedule": {{"values": [{steps_2d}]}},
    "shifts": {shifts_2d}
  }}, {{
    "shapes": ["sphere:radius=9", "ellipsoid:a=9,b=7,c=5", "goursat", "torus:major=6,minor=2", "rounded-cube:radius=9",
               "polynomial:0.0081*(x^4+y^4+z^4)-0.45*(x^2+y^2+z^2)-6", "star", "heart:radius=9,away=4.5"],
    "estimators": ["ii", "ii-covariance", "ii-pf1", "ii-ho1", "ii-ho1-guarded", "ii-ho2", "icnc", "ccnc", "vcm"],
    "schedule": {{"values": [{steps_3d}]}},
    "shifts": {shifts_3d}
  }}, {{
    "shapes": ["ellipsoid:a=9,b=7,c=5"],
    "estimators": ["ii", "ii-pf1", "ii-ho1", "ii-ho2", "icnc"],
    "schedule": {{"values": [{steps_3d}]}},
    "rotate": true,
    "shifts": {shifts_3d}
  }}]
}})json",
      fmt::arg("steps_2d", steps_2d), fmt::arg("shifts_2d", shifts_2d), fmt::arg("steps_3d", steps_3d),
      fmt::arg("shifts_3d", shifts_3d));
}

}  // namespace

/// The most accurate estimators on the same surfels with the same truth, each with its usual radius. Shapes have a size of
/// about ten, so that one k serves them all: the blobby cube is ten times larger than elsewhere. Nobody chose a k on the
/// blobby cube, the star, the heart and the ellipsoid under random rotations. The heart has singular points, and no truth
/// within 4.5 of them, a little more than the greatest of the usual radii at h = 0.25: from there on, no ball around a
/// point with a truth holds a point where curvature is infinite.
StudyEntry describe_accuracy_frontier() {
  return {"accuracy-frontier",
          "the most accurate estimators at equal h, each with its usual radius: errors and time",
          study("0.4, 0.2, 0.1, 0.05, 0.025", 5, "1, 0.7, 0.5, 0.35, 0.25", 2),
          study("0.4, 0.2, 0.1, 0.05, 0.025, 0.0125, 0.00625", 10,
                "1, 0.7, 0.5, 0.35, 0.25, 0.175, 0.125, 0.0875, 0.0625", 10)};
}

}  // namespace gridstep
