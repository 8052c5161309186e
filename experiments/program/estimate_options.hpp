#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "estimators/options.hpp"
#include "experiments/program/volume_options.hpp"

namespace gridstep {

/// The options of gridstep estimate, as they were given.
struct EstimateOptions {
  std::string shape, image;
  VolumeOptions volume;
  std::string quantity, evaluation = to_string(EstimatorOptions{}.evaluation), centre = "spels", csv;
  std::vector<std::string> estimators, out;
  double h = 0, radius = 0, k = 0, alpha = 1.0 / 3.0, noise = 0;
  std::vector<double> shift;
  std::uint64_t seed = 1;
  int threads = 0;
  bool raw = false, json = false, has_radius = false, has_k = false;
};

void estimate_on_shape(const EstimateOptions& options);
void estimate_on_image(EstimateOptions options);
void estimate_on_volume(EstimateOptions options);

}  // namespace gridstep
