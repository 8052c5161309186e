#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "shapes/base/units.hpp"
#include "shapes/digital/digital_set.hpp"
#include "shapes/digital/khalimsky.hpp"

namespace gridstep {

/// Estimates over a range of surfels: columns[c][i] belongs to quantity c and surfel i.
struct Estimates {
  std::vector<std::string> quantities;
  std::vector<std::vector<double>> columns;

  /// A table of that many rows, to be filled.
  static Estimates zeros(std::vector<std::string> quantities, std::size_t rows);
  /// values[c] is for quantity c; any more are left out. Rows may be set from several threads at once.
  template <class Values>
  void set_row(std::size_t i, const Values& values) {
    for (std::size_t c = 0; c < columns.size(); ++c) columns[c][i] = double(values[c]);
  }

  /// @throws ContractViolation where there is no such quantity.
  const std::vector<double>& operator[](const std::string& quantity) const;
};

/// What an estimator did: deterministic, whatever the number of threads.
struct EstimatorWork {
  std::int64_t evaluations = 0;  ///< points at which the kernel was evaluated (spels serve several surfels)
  /// Cells of the digital set that were read; by Evaluation::bricks, bricks and runs of bricks, or surfels.
  std::int64_t cells_visited = 0;
  std::int64_t restarts = 0;     ///< whole-kernel evaluations among incremental ones
  std::int64_t kernel_size = 0;  ///< cells of one kernel
  /// Cells gained by each displacement mask (as many are lost), in the order of DisplacementMasks::steps().
  std::vector<std::int64_t> mask_sizes{};
  std::int64_t fallbacks = 0;  ///< surfels at which a guard chose another kernel than the first

  /// Of two ranges of surfels, with one kernel.
  EstimatorWork& operator+=(const EstimatorWork& other);
};

/// A local estimator on the boundary of a digital set. It sees the set, the grid step and the radius, and
/// never the shape that was digitized.
template <int d>
class Estimator {
 public:
  virtual ~Estimator() = default;

  /// Precomputes what depends on h and R alone (kernel, masks). To be called before eval(), any number of
  /// times.
  /// @throws InputError where R/h < 1.
  virtual void init(GridStep h, EuclideanLength R) = 0;

  /// One value of each quantity for each surfel, in the order of the range. Surfels must bound the digital
  /// set. Runs on all threads of the current arena; the values do not depend on their number.
  virtual Estimates eval(std::span<const Surfel<d>> surfels) = 0;
  Estimates eval(const Surfel<d>& surfel) { return eval({&surfel, 1}); }

  /// What the estimates were made from, for `--raw`: exact where it is an integer. Valid after eval().
  virtual Estimates raw() const = 0;
  /// Of the kernel and of the last eval().
  virtual EstimatorWork work() const = 0;
};

}  // namespace gridstep
