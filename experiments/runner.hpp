#pragma once

#include <cstdio>
#include <filesystem>
#include <functional>
#include <vector>

#include "experiments/record.hpp"
#include "experiments/study.hpp"

namespace gridstep {

struct RunOptions {
  std::filesystem::path journal;  ///< finished digitizations, kept until the study is done; empty: none
  bool resume = false;            ///< go on from an existing journal; without it, one is an error
  std::FILE* progress = nullptr;  ///< where to tell how far the study is
};

/// Bytes that the largest job of a study will hold, to within a factor of about two.
/// @throws InputError where that is more than the machine has available.
double predicted_memory(const Study& study);

/// All records of a study, in the order of its sweeps, shapes, noise, h, shifts, radii, estimators,
/// evaluations.
///
/// Each digitization serves all estimators, and its records are journalled together, so a kill loses at most
/// the one under way. The numbers depend on the study alone, timings aside. Runs on all threads of the
/// current arena.
/// @throws InputError as predicted_memory(), before anything is computed or written; or where the journal is another
/// study's.
/// @throws std::runtime_error where two evaluations differ in one of their sums.
std::vector<Record> run_study(const Study& study, const nlohmann::json& source, const RunOptions& options);

}  // namespace gridstep
