#include <fmt/format.h>

#include <string>

#include "experiments/catalogue.hpp"

namespace gridstep {

namespace {

/// Two sweeps over the same, with as many shifts: without and with a random rotation.
std::string twice(const std::string& sweep, int shifts) {
  return fmt::format(R"json({{{0}, "shifts": {1}}}, {{{0}, "shifts": {1}, "rotate": true}})json", sweep,
                     shifts);
}

std::string study(const std::string& steps_2d, int shifts_2d, const std::string& shapes_3d,
                  const std::string& steps_3d, int shifts_3d) {
  const std::string plane = fmt::format(R"json(
    "shapes": ["disk:radius=15", "ellipse:a=20,b=7", "flower:radius=20,amplitude=5,petals=5",
               "lpball:radius=15,power=4"],
    "estimators": ["ii", "ii-parameter-free", "ii-pf1", "ii-ho1", "mdca", "lambda-mdca", "bc", "lambda-mst"],
    "schedule": {{"values": [{}]}})json",
                                        steps_2d);
  const std::string space = fmt::format(R"json(
    "shapes": [{}],
    "estimators": ["ii", "ii-covariance", "ii-pf1", "ii-ho1", "icnc", "ccnc", "vcm"],
    "schedule": {{"values": [{}]}})json",
                                        shapes_3d, steps_3d);
  return fmt::format(R"json({{
  "name": "rotation",
  "description": "errors under shifts, and under shifts with rotations",
  "tables": ["isotropy"],
  "sweeps": [{}, {}]
}})json",
                     twice(plane, shifts_2d), twice(space, shifts_3d));
}

}  // namespace

/// Whether errors depend on how a shape lies on the grid: as many shifts without as with a random rotation. The sphere is
/// the check on the study itself, as a rotation does nothing to it; the ellipse, the ellipsoid and what is flat or square
/// along the axes are where a lattice would show.
StudyEntry describe_rotation() {
  const std::string solids = R"("sphere:radius=9", "ellipsoid:a=9,b=7,c=5", "goursat")";
  return {"rotation", "is the error isotropic? As many random shifts without as with a random rotation",
          study("0.4, 0.25, 0.16, 0.1, 0.0625", 20, solids, "1.4, 1.1, 0.9, 0.7, 0.5", 10),
          study("0.4, 0.2, 0.1, 0.05, 0.025", 100, solids + R"(, "rounded-cube:radius=9")",
                "1, 0.7, 0.5, 0.35, 0.25", 40)};
}

}  // namespace gridstep
