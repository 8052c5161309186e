#pragma once

#include <string>
#include <vector>

#include "estimators/estimator.hpp"
#include "experiments/record.hpp"
#include "shapes/scene.hpp"

namespace gridstep {

/// A digital surface, with what is estimated at each surfel, several times, and the truth.
struct Surface {
  std::vector<Surfel<3>> surfels;
  std::vector<Estimates> estimates;
  std::vector<std::vector<std::string>> quantities;  ///< of each of the estimates, those that are drawn
  Truth truth;                                       ///< of no quantity where nothing is known
};

/// As an earlier study had it.
struct RecordedSurface : Surface {
  std::vector<const Record*> records;  ///< of one digitization; the estimates are one a record
};

/// More are slow to send and to turn.
inline constexpr std::int64_t most_surfels_shown = 200'000;

/// For each 3D shape, in the order of the records, those of the finest digitization that has at most that many
/// surfels: shift 0, neither rotated nor noisy; of each estimator the first one, so its first radius.
std::vector<std::vector<const Record*>> records_of_surfaces(const std::vector<Record>& records);

/// Digitizes and estimates again what the records tell of. Its quantities are those that are compared and are one
/// number.
/// @throws InputError where that cannot be done, or where its number of surfels or its errors are not those of
/// the records, as another version of the program may have it.
RecordedSurface remake_surface(const std::vector<const Record*>& records);

}  // namespace gridstep
