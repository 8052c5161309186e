#include <fmt/format.h>
#include <tbb/global_control.h>

#include <memory>
#include <optional>

#include "experiments/program/commands.hpp"
#include "experiments/program/estimate_options.hpp"
#include "experiments/program/surfel_output.hpp"
#include "shapes/base/contracts.hpp"

namespace gridstep {

void add_estimate_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "estimate",
      "Estimators on one digitized shape, on the contours of an image, or on the surface of a volume");
  const auto options = std::make_shared<EstimateOptions>();
  auto* shape =
      command->add_option("--shape", options->shape, "Such as ellipse:a=20,b=7; see gridstep list shapes");
  auto* image = command->add_option("--image", options->image, "PGM or PBM file, instead of a shape");
  image->excludes(shape);
  auto* volume =
      command->add_option("--volume", options->volume.path,
                          "Instead of a shape, a file: .vol, .longvol, .pgm3d, .raw, .nrrd, .nii, .nii.gz");
  volume->excludes(shape)->excludes(image);
  command
      ->add_option(
          "--threshold", options->volume.threshold,
          "Of image or volume: LOW,HIGH, the grey values of the foreground, both included (default where "
          "there are but two values: the one that is not 0; of PBM: black)")
      ->delimiter(',')
      ->excludes(shape);
  add_raw_layout_options(*command, options->volume);
  command->add_option(
      "--h", options->h,
      "Grid step (default for images: 1, the pixel; for volumes: the spacing in the file, or 1)");
  command
      ->add_option(
          "--estimator", options->estimators,
          "One or several: NAME,NAME; see gridstep list estimators (default for images: all; for volumes: "
          "ii-covariance, or the first that has the quantity)")
      ->delimiter(',');
  command->add_option(
      "--quantity", options->quantity,
      "Only this one: kappa, mean, gaussian, k1, k2, normal, ... (default: all of the estimator; by ii-pf1, ii-ho1 and "
      "ii-ho2, mean alone is several times faster)");
  auto* radius = command->add_option(
      "--radius", options->radius,
      "Kernel radius R, in the unit of the shape; for images and volumes that is the unit of h: "
      "with --h 1, pixels or voxels (default: 5 of them)");
  auto* k = command->add_option("--k", options->k, "R = K h^ALPHA")->excludes(radius);
  command->add_option("--alpha", options->alpha, "Exponent of h in R (default: 1/3)")->needs(k);
  command->add_option("--evaluation", options->evaluation,
                      "bricks (default), masks or full; the sums are the same");
  command->add_option("--centre", options->centre,
                      "Kernel centres: spels (default; mean of inner and outer) or surfel");
  command->add_option("--shift", options->shift, "Sub-grid shift of the shape, in cells: X,Y[,Z]")
      ->delimiter(',')
      ->needs(shape);
  command->add_option("--noise", options->noise, "Kanungo noise: beta in [0, 1)")->needs(shape);
  command->add_option("--seed", options->seed, "Seed of the noise")->check(not_negative);
  command->add_option("--csv", options->csv, "File for one row a surfel; - is standard output");
  command
      ->add_option(
          "--out", options->out,
          "File for surfels and values, by extension .csv or .npy; of 3D surfaces also .ply, .vtp or .obj; "
          "several times for several")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->add_flag("--raw", options->raw, "In the files, also the sums that the estimates come from");
  command->add_flag("--json", options->json, "What is printed, as JSON, for other programs");
  command->add_option("--threads", options->threads, "Number of threads (default: all)")
      ->check(CLI::Range(1, 4096));
  command->footer(
      "A volume is evaluated on every component of the surface of its foreground; its voxel (x, y, z) is the "
      "point\n"
      "(x, y, z), and its unit is that of the spacing in the file, where it has one, else the voxel.\n"
      "The CSV has a header and one row a surfel (2D: along the contours, shape on the left):\n"
      "  kx,ky[,kz]    Khalimsky coordinates; the spel z has 2z+1, a surfel one even coordinate\n"
      "  px,py         the pointel at which the linel starts, where an estimator's values belong to it\n"
      "  x,y[,z]       centre of the surfel, in the unit of the shape\n"
      "  component     number of the contour or of the surface (images and volumes), by size\n"
      "  the estimator's quantities: kappa; tangent_x, tangent_y; mean, gaussian, k1, k2, normal_x, ...\n"
      "  with --raw: sum (mean of inner and outer sum), in 3D cov_xx, cov_xy, cov_xz, cov_yy, cov_yz, "
      "cov_zz\n"
      "  true_kappa, ...: exact values at the closest boundary point; empty at singular points\n"
      "  error (of the first quantity), error_gaussian, ...: estimate minus truth; of vectors, the angle\n"
      "With several estimators, each has its columns: mdca.kappa, mdca.true_kappa, mdca.error, ...\n"
      "NPY has the same columns; PLY and VTP have the squares with a value each (VTP: normal_x, _y, _z as a "
      "vector),\n"
      "OBJ has the first quantity alone, as texture coordinate. No value: an empty field in CSV, else NaN.\n"
      "Examples:\n"
      "  gridstep estimate --shape flower:radius=20,amplitude=7,petals=6 --h 0.1 --estimator ii --k 5 --csv "
      "flower.csv\n"
      "  gridstep estimate --shape goursat --h 0.25 --shift 0.1,0.2,0.3 --estimator ii-covariance --radius 2 "
      "--csv - --raw\n"
      "  gridstep estimate --shape ellipse:a=20,b=7 --h 0.1 --estimator mdca,bc,lambda-mst\n"
      "  gridstep estimate --image contour.pgm --threshold 0,127 --radius 5 --csv contours.csv\n"
      "  gridstep estimate --volume al.vol --radius 7 --quantity gaussian --out al.ply\n"
      "  gridstep estimate --volume scan.nii.gz --threshold 300,3000 --radius 2.5 --out scan.vtp --out "
      "scan.npy");
  command->callback([options, command] {
    options->has_radius = command->count("--radius") > 0;
    options->has_k = command->count("--k") > 0;
    std::optional<tbb::global_control> limit;
    if (options->threads > 0)
      limit.emplace(tbb::global_control::max_allowed_parallelism, std::size_t(options->threads));
    const VolumeOptions& input = options->volume;
    if (!input.size.empty() && input.path.empty()) throw InputError("--size is for --volume");
    if (options->json && is_standard_output(options->csv))
      throw InputError(fmt::format("--json and --csv {}: both write to standard output", options->csv));
    if (!input.path.empty()) return estimate_on_volume(*options);
    if (!options->image.empty()) return estimate_on_image(*options);
    if (options->shape.empty()) throw InputError("one of --shape, --image and --volume is needed");
    if (command->count("--h") == 0) throw InputError("--h is needed with --shape");
    if (options->estimators.empty() && options->quantity.empty())
      throw InputError("--estimator or --quantity is needed with --shape");
    estimate_on_shape(*options);
  });
}

}  // namespace gridstep
