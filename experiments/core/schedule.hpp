#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

namespace gridstep {

class JsonReader;

/// The grid steps h of a study, strictly decreasing: from coarse to fine.
class Schedule {
 public:
  /// h_i = from (to/from)^(i/(steps-1)), both ends exact. @throws InputError unless from > to > 0 and steps
  /// >= 2.
  static Schedule geometric(double from, double to, int steps);

  /// h_j = e^(-j/10), j = first .. last, the steps of the published sweeps of integral invariants.
  /// @throws InputError unless first < last, within +-1000.
  static Schedule papers(int first, int last);

  /// @throws InputError unless there is a value, and all are positive, finite and strictly decreasing.
  static Schedule of(std::vector<double> values);

  /// One of {"from": 1, "to": 0.05, "steps": 12}, {"papers": {"first": 0, "last": 87}} and {"values": [1,
  /// 0.5]}.
  /// @throws InputError naming the place, the key and the value; finishes the reader.
  static Schedule read(JsonReader& reader);

  const std::vector<double>& values() const { return values_; }

 private:
  explicit Schedule(std::vector<double> values) : values_(std::move(values)) {}

  std::vector<double> values_;
};

}  // namespace gridstep
