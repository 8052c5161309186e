#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "experiments/memory.hpp"
#include "experiments/program/estimation.hpp"
#include "experiments/program/say.hpp"
#include "experiments/program/surfel_output.hpp"
#include "shapes/digital/boundary.hpp"

namespace gridstep {

namespace {

constexpr double kDefaultRadius = 5;  // in voxels

}  // namespace

void estimate_on_volume(EstimateOptions options) {
  // Without a quantity, all there are: from the estimator that has them all.
  if (options.estimators.empty())
    options.estimators = {options.quantity.empty() ? "ii-covariance"
                                                   : estimators_with_quantity<3>(options).front()};
  std::optional<GreyRange> range;
  if (!options.volume.threshold.empty()) range = grey_range(options.volume.threshold);
  const GreyVolume volume = read_volume(options.volume);
  const GridStep h{options.h == 0 ? volume.spacing : checked("--h", options.h)};
  const EuclideanLength R = radius_of(options, h).value_or(EuclideanLength{kDefaultRadius * h.value});
  std::vector<Estimation<3>> estimations = chosen<3>(options, R);
  if (!range) range = foreground(volume);
  const DigitalSet<3> set = threshold(volume, *range);
  const double predicted = predicted_memory<3>(estimations, size_of(set), h, R, options);
  require_memory(predicted, options.volume.path);
  SurfelOutput output(options.csv, options.out, 3);
  const DigitalSurface<3> surface = connected_boundary(set);
  evaluate<3>(estimations, set, surface.surfels, h, R, options);
  if (!output.empty()) {
    SurfelTable table = surfel_table<3>(estimations, surface.surfels, h, surface.component_begin);
    for (const Estimation<3>& e : estimations) add_estimates(table, e, title_prefix(estimations, e), options);
    output.write<3>(table, surface.surfels, h);
  }

  if (options.json) {
    nlohmann::ordered_json json{{"volume", options.volume.path},
                                {"extent", {volume.extent[0], volume.extent[1], volume.extent[2]}},
                                {"type", name_of(volume.type)},
                                {"foreground", {range->low, range->high}},
                                {"voxels", set.size()}};
    json.update(head_json(h, R, surface.surfels.size(), surface.components()));
    for (const Estimation<3>& e : estimations) json["estimates"].push_back(to_json(e, options));
    return fmt::print("{}\n", json.dump(2));
  }
  std::FILE* out = output.summary_stream();
  say(out, "{}: {} x {} x {} voxels of {}, {} in [{}, {}], h = {}{}, {}\n", options.volume.path,
      volume.extent[0], volume.extent[1], volume.extent[2], name_of(volume.type), set.size(), range->low,
      range->high, h.value, radius_text(R, h), fmt::join(options.estimators, ", "));
  say(out, "surfels {}, components {}\n", surface.surfels.size(), surface.components());
  for (const Estimation<3>& e : estimations) {
    if (estimations.size() > 1) say(out, "{}\n", e.name);
    for (std::size_t q = 0; q < e.estimates.quantities.size(); ++q) {
      if (!wanted(options, e.estimates.quantities[q])) continue;
      const auto [least, most] =
          std::minmax_element(e.estimates.columns[q].begin(), e.estimates.columns[q].end());
      say(out, "{:<10} from {:.4g} to {:.4g}\n", e.estimates.quantities[q], *least, *most);
    }
    say_text(out, work_text(e, options, surface.surfels.size()));
  }
  say(out, "{}\n", memory_report(predicted, std::int64_t(surface.surfels.size())));
}

}  // namespace gridstep
