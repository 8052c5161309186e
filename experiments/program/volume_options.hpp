#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "shapes/files/grey_volume.hpp"

namespace gridstep {

/// The options that say which file of voxels to read, and what of it is the foreground.
struct VolumeOptions {
  std::string path;
  std::vector<double> threshold;
  std::vector<std::int64_t> size;
  std::string type = "uint8";
};

/// --size and --type, which a .raw file needs.
void add_raw_layout_options(CLI::App& command, VolumeOptions& options);

/// @throws InputError naming the file, or the option, and what is wrong with it.
GreyVolume read_volume(const VolumeOptions& options);

/// Of --threshold LOW,HIGH. @throws InputError unless LOW <= HIGH.
GreyRange grey_range(const std::vector<double>& threshold);

}  // namespace gridstep
