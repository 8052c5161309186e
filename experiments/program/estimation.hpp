#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "estimators/catalogue.hpp"
#include "experiments/memory.hpp"
#include "experiments/program/estimate_options.hpp"
#include "shapes/base/quadratic_bound.hpp"
#include "shapes/files/surfel_table.hpp"

// What gridstep estimate does alike on shapes, images and volumes.
namespace gridstep {

/// What an estimator gave on a boundary.
template <int d>
struct Estimation {
  std::string name;
  const EstimatorEntry::Variant<d>* variant;
  Estimates estimates, raw;
  EstimatorWork work;
  double seconds_init, seconds_eval;
};

/// @throws InputError naming the option unless the value is positive and finite.
double checked(const char* option, double value);

/// The radius that the options ask for, in one of two ways, if they do. @throws InputError where R/h < 1.
std::optional<EuclideanLength> radius_of(const EstimateOptions& options, GridStep h);

/// Whether --quantity asks for a column: the quantity itself or a coordinate of it; all without the option.
bool wanted(const EstimateOptions& options, const std::string& column);

/// The names of all estimators of dimension d that have the quantity asked for, in the order of the catalogue.
template <int d>
std::vector<std::string> estimators_with_quantity(const EstimateOptions& options);

/// The estimators by name, with all options that they depend on checked: all must exist in dimension d and have
/// the quantity asked for, and those that need a radius must have one.
template <int d>
std::vector<Estimation<d>> chosen(const EstimateOptions& options, const std::optional<EuclideanLength>& R);

/// Bytes that a digital set, its surface and all that the estimators make of it will hold.
template <int d>
double predicted_memory(const std::vector<Estimation<d>>& estimations, SetSize size, GridStep h,
                        const std::optional<EuclideanLength>& R, const EstimateOptions& options);

template <int d>
void evaluate(std::vector<Estimation<d>>& estimations, const DigitalSet<d>& set,
              std::span<const Surfel<d>> surfels, GridStep h, EuclideanLength R,
              const EstimateOptions& options);

/// A table without values: kx,ky[,kz], the start pointels px,py where an estimator's values belong to them,
/// x,y[,z], and the component where there are several. The arguments have to outlive it.
template <int d>
SurfelTable surfel_table(const std::vector<Estimation<d>>& estimations, std::span<const Surfel<d>> surfels,
                         GridStep h, std::span<const std::size_t> component_begin);

/// With several estimators, the titles of its columns start with its name.
template <int d>
std::string title_prefix(const std::vector<Estimation<d>>& estimations, const Estimation<d>& e) {
  return estimations.size() > 1 ? e.name + "." : "";
}

/// Adds the estimates that --quantity wants, and with --raw the sums. The estimation has to outlive the table.
template <int d>
void add_estimates(SurfelTable& table, const Estimation<d>& e, const std::string& prefix,
                   const EstimateOptions& options);

/// Lines on kernel, work and time.
template <int d>
std::string work_text(const Estimation<d>& e, const EstimateOptions& options, std::size_t surfels);

/// For --json, what is there of every input: h, R, and the boundary.
nlohmann::ordered_json head_json(GridStep h, const std::optional<EuclideanLength>& R, std::size_t surfels,
                                 std::size_t components);

/// For --json, an estimator: the ranges of the quantities that --quantity wants, work and seconds.
template <int d>
nlohmann::ordered_json to_json(const Estimation<d>& e, const EstimateOptions& options);

/// ", R = 5 (R/h = 10)", or nothing.
std::string radius_text(const std::optional<EuclideanLength>& R, GridStep h);

}  // namespace gridstep
