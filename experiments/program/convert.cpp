#include <fmt/format.h>

#include <memory>

#include "experiments/core/output_file.hpp"
#include "experiments/program/commands.hpp"
#include "experiments/program/say.hpp"
#include "experiments/program/volume_options.hpp"
#include "shapes/files/volume_file.hpp"

namespace gridstep {

namespace {

struct Options {
  VolumeOptions in;
  std::string out;
};

void run(const Options& options) {
  const VolumeFormat& format = writable_volume_format(options.out);
  std::optional<GreyRange> range;
  if (!options.in.threshold.empty()) range = grey_range(options.in.threshold);
  GreyVolume volume = read_volume(options.in);
  if (range) volume = binary(volume, *range);
  OutputFile file(options.out);
  format.write(volume, [&](std::string_view bytes) { file.write(bytes); });
  file.commit();
  say(stdout, "{}: {} x {} x {} voxels of {}, spacing {}\n", options.in.path, volume.extent[0],
      volume.extent[1], volume.extent[2], name_of(volume.type), volume.spacing);
  say(stdout, "written: {}\n", options.out);
}

}  // namespace

void add_convert_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand("convert", "A volume from one file format into another");
  const auto options = std::make_shared<Options>();
  command
      ->add_option("in", options->in.path,
                   "File to read: .vol, .longvol, .pgm3d, .raw, .nrrd, .nii or .nii.gz")
      ->required();
  command->add_option("out", options->out, "File to write: .vol, .longvol, .pgm3d, .raw, .nrrd or .vti")
      ->required();
  command
      ->add_option("--threshold", options->in.threshold,
                   "LOW,HIGH: write 1 for the grey values between, both included, and 0 for the others")
      ->delimiter(',')
      ->expected(1, 2);
  add_raw_layout_options(*command, options->in);
  command->footer(
      "Values are never changed: those that the format written cannot hold are an error. Of .vol (0 to "
      "255),\n"
      ".longvol, .pgm3d (0 to 65535) and .raw, none keeps the spacing. A .raw file is written little "
      "endian.\n"
      "Examples:\n"
      "  gridstep convert scan.nii.gz bone.vol --threshold 300,3000\n"
      "  gridstep convert scan.raw scan.nrrd --size 256,256,128 --type int16");
  command->callback([options] { run(*options); });
}

}  // namespace gridstep
