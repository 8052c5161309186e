#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "experiments/program/estimation.hpp"
#include "experiments/program/say.hpp"
#include "experiments/program/surfel_output.hpp"
#include "shapes/digital/boundary.hpp"
#include "shapes/files/image_file.hpp"

namespace gridstep {

namespace {

constexpr double kDefaultRadius = 5;  // in pixels

}  // namespace

void estimate_on_image(EstimateOptions options) {
  const GridStep h{options.h == 0 ? 1.0 : checked("--h", options.h)};
  const EuclideanLength R = radius_of(options, h).value_or(EuclideanLength{kDefaultRadius * h.value});
  if (options.estimators.empty()) options.estimators = estimators_with_quantity<2>(options);
  std::vector<Estimation<2>> estimations = chosen<2>(options, R);
  const GreyImage image = read_image(options.image);
  std::vector<double> bounds = options.volume.threshold;
  if (bounds.empty()) {
    const auto [least, most] = std::minmax_element(image.values.begin(), image.values.end());
    if (*most > 1)
      throw InputError(fmt::format(
          "{}: a grey image, with values from {} to {}; --threshold LOW,HIGH says which are the foreground",
          options.image, *least, *most));
    bounds = {1, 1};
  }
  const GreyRange range = grey_range(bounds);
  SurfelOutput output(options.csv, options.out, 2);
  const DigitalSet<2> set = threshold(image, range.low, range.high);
  const DigitalSurface<2> contours = connected_boundary(set);
  evaluate<2>(estimations, set, contours.surfels, h, R, options);
  const auto& begin = contours.component_begin;
  if (!output.empty()) {
    SurfelTable table = surfel_table<2>(estimations, contours.surfels, h, begin);
    for (const Estimation<2>& e : estimations) add_estimates(table, e, title_prefix(estimations, e), options);
    output.write<2>(table, contours.surfels, h);
  }

  if (options.json) {
    nlohmann::ordered_json json{{"image", options.image},
                                {"extent", {image.width, image.height}},
                                {"foreground", {range.low, range.high}},
                                {"pixels", set.size()}};
    json.update(head_json(h, R, contours.surfels.size(), contours.components()));
    for (const Estimation<2>& e : estimations) json["estimates"].push_back(to_json(e, options));
    return fmt::print("{}\n", json.dump(2));
  }
  std::FILE* out = output.summary_stream();
  say(out, "{}: {} x {} pixels, {} in [{}, {}], h = {}{}\n", options.image, image.width, image.height,
      set.size(), range.low, range.high, h.value, radius_text(R, h));
  for (std::size_t c = 0; c < contours.components(); ++c) {
    say(out, "contour {}: {} linels\n", c, begin[c + 1] - begin[c]);
    for (const Estimation<2>& e : estimations)
      for (std::size_t q = 0; q < e.estimates.quantities.size(); ++q) {
        if (!wanted(options, e.estimates.quantities[q])) continue;
        const auto first = e.estimates.columns[q].begin();
        const auto [least, most] =
            std::minmax_element(first + std::ptrdiff_t(begin[c]), first + std::ptrdiff_t(begin[c + 1]));
        say(out, "  {:<18} {:<10} from {:.4g} to {:.4g}\n", e.name, e.estimates.quantities[q], *least, *most);
      }
  }
  for (const Estimation<2>& e : estimations)
    say(out, "{}: {}", e.name, work_text(e, options, contours.surfels.size()));
}

}  // namespace gridstep
