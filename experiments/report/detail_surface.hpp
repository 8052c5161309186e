#pragma once

#include "experiments/report/results_folder.hpp"
#include "experiments/report/surface.hpp"

namespace gridstep {

/// One surface at several radii, as a study of detail left it. No truth: there is none of a volume.
struct DetailSurface : Surface {
  std::string input;  ///< what was digitized or read
  GridStep h;
  std::string estimator;
  std::vector<double> digital_radii;  ///< R/h; the estimates are one a radius
};

/// From the PLY files in the folder: what they hold is what was estimated, wherever the volume is by now.
/// @throws InputError where the surface has more than most_surfels_shown surfels, and where a file is missing or
/// is not what its summary tells of.
DetailSurface read_detail_surface(const ResultsFolder& folder);

}  // namespace gridstep
