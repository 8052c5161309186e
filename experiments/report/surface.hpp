#pragma once

#include <string>
#include <vector>

#include "estimators/estimator.hpp"
#include "experiments/record.hpp"
#include "shapes/scene.hpp"

namespace gridstep {

/// A digital surface as an earlier study had it, with what its estimators say at each surfel and the truth.
struct Surface {
  std::vector<const Record*> records;  ///< of one digitization, one an estimator
  std::vector<Surfel<3>> surfels;
  std::vector<Estimates> estimates;  ///< one a record
  Truth truth;                       ///< of every quantity that is compared and is one number
};

/// More are slow to send and to turn.
inline constexpr std::int64_t most_surfels_shown = 200'000;

/// For each 3D shape, in the order of the records, those of the finest digitization that has at most that many
/// surfels: shift 0, neither rotated nor noisy; of each estimator the first one, so its first radius.
std::vector<std::vector<const Record*>> records_of_surfaces(const std::vector<Record>& records);

/// Digitizes and estimates again what the records tell of.
/// @throws InputError where that cannot be done, or where its number of surfels or its errors are not those of
/// the records, as another version of the program may have it.
Surface remake_surface(const std::vector<const Record*>& records);

}  // namespace gridstep
