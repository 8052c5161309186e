#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "estimators/estimator.hpp"
#include "estimators/options.hpp"
#include "estimators/value_position.hpp"

namespace gridstep {

/// What a quantity is, for tables and for the comparison with the truth.
struct Quantity {
  std::string name;  ///< a column: kappa, mean, gaussian, k1, k2, normal_x, ...
  /// Exponent p of the proven bound O(h^p) of its sup error, where there is one, with R = k h^(1/3).
  std::optional<double> proven_rate;
};

template <int d>
using EstimatorFactory =
    std::function<std::unique_ptr<Estimator<d>>(const DigitalSet<d>& set, const EstimatorOptions& options)>;

/// What an estimator is in one dimension.
template <int d>
struct EstimatorVariant {
  std::vector<Quantity> quantities;
  EstimatorFactory<d> make;
  ValuePosition position = ValuePosition::surfel_centre;
  bool takes_radius = true;         ///< else the R of Estimator::init() is ignored
  double usual_k = d == 2 ? 5 : 3;  ///< of R = k h^(1/3), where nobody asks for another
  /// What there is to choose between in the options; nothing where there are no sums over balls.
  std::vector<Evaluation> evaluations{Evaluation::full, Evaluation::masks, Evaluation::bricks};
  std::vector<KernelCentre> centres{KernelCentre::spels, KernelCentre::surfel};
  bool takes_options() const { return !evaluations.empty(); }

  /// Bytes of tables that it has beside those of sums over balls, by Evaluation::bricks; none: no such tables.
  std::function<double(DigitalLength)> table_memory{};

  /// @throws InputError naming an evaluation that the estimator does not have, and listing those that it has.
  void require(Evaluation evaluation, const std::string& estimator) const;
  /// The centre asked for, or the only one there is.
  KernelCentre centre(KernelCentre wanted) const;
};

/// A line of the catalogue. An estimator may exist in one dimension or in both, with different quantities.
struct EstimatorEntry {
  template <int d>
  using Variant = EstimatorVariant<d>;

  std::string name;
  std::string summary;
  std::optional<Variant<2>> in_2d;
  std::optional<Variant<3>> in_3d;
  std::string not_built{};  ///< how to get the estimator, where this build is without it; else empty

  /// @throws InputError where the estimator does not exist in dimension d, or not in this build.
  template <int d>
  const Variant<d>& variant() const;
};

/// All estimators, in the order of estimators/catalogue.inc.
const std::vector<EstimatorEntry>& estimator_catalogue();

/// @throws InputError naming an unknown estimator and listing the known ones.
const EstimatorEntry& find_estimator(const std::string& name);

}  // namespace gridstep
