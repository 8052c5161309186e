#pragma once

#include <ostream>
#include <string>

namespace gridstep {

/// How the sums of f(s) g(s - x) over the lattice are evaluated. The results are the same; for integers,
/// exactly.
///   full   the whole kernel at every evaluation point: the plain reference, O((R/h)^d) each
///   masks  from the sum at a 0-adjacent evaluation point through a displacement mask, O((R/h)^(d-1)) each; where
///          there is no such point, the whole kernel (a restart)
///   bricks from 512 points at a time, and only where the ball's boundary may cross the set's: O((R/h)^(d-2)) each;
///          balls only, R/h at most 700 in 3D, 16384 in 2D (see bricks/ball_sums.hpp)
enum class Evaluation { full, masks, bricks };

/// @throws InputError naming an unknown strategy and listing the known ones.
Evaluation parse_evaluation(const std::string& name);
std::string to_string(Evaluation evaluation);
inline std::ostream& operator<<(std::ostream& out, Evaluation evaluation) {
  return out << to_string(evaluation);
}

/// Where the kernel is centred: the value at a surfel is the mean of the sums at its two spels (the
/// convention of the DGtal library), or comes from one sum around the surfel's own centre.
enum class KernelCentre { spels, surfel };

/// @throws InputError naming an unknown centre and listing the known ones.
KernelCentre parse_kernel_centre(const std::string& name);

struct EstimatorOptions {
  Evaluation evaluation = Evaluation::bricks;
  KernelCentre centre = KernelCentre::spels;
  /// The one quantity that is wanted, none: all. An estimator may save the work for others, and then has this one alone.
  std::string only = {};
};

}  // namespace gridstep
