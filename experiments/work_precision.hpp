#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "experiments/analysis.hpp"

namespace gridstep {

/// What an estimator reaches, and at what cost, along a schedule: error and evaluation time at each h.
struct WorkPrecision : Setting {
  struct Point {
    double h;
    double seconds;  ///< evaluation of the whole boundary, by the fastest evaluation there is
    double error;    ///< mean over the shifts
  };
  std::string quantity, norm;
  std::vector<Point> points;  ///< from coarse to fine
  SlopeFit fit;
  Verdict verdict;
};

/// One entry a series that has costs, in the order of the series.
std::vector<WorkPrecision> work_precision_of(const std::vector<Convergence>& series,
                                             const std::vector<Cost>& costs);

/// The value of a column (h or seconds) at which the error is reached: between the last step above the error
/// and the first one from which on all are at or below it, on the line through both in logarithms. Nothing
/// where the finest step is above it; the coarsest value where all are at or below it.
std::optional<double> where_reached(const WorkPrecision& curve, double error,
                                    double WorkPrecision::Point::*column);

/// Evaluation time in which each estimator reaches an error: rows are shape, quantity, norm and the error;
/// columns the estimators.
Table work_precision_table(const std::vector<WorkPrecision>& curves);

/// The h' that each estimator needs to reach the error that the first one has at h: rows are shape, quantity,
/// norm and h, columns the estimators. "~" where h' is beyond the range measured, on the fitted line; "-"
/// where that line does not fall for certain.
Table equal_error_table(const std::vector<WorkPrecision>& curves);

nlohmann::ordered_json to_json(const std::vector<WorkPrecision>& curves);

}  // namespace gridstep
