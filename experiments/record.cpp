#include "experiments/record.hpp"

#include <nlohmann/json.hpp>

#include "shapes/base/contracts.hpp"

namespace gridstep {

using nlohmann::ordered_json;

ordered_json setting_json(const Setting& s) {
  const ordered_json none;
  return {{"shape", s.shape},
          {"dimension", s.dimension},
          {"noise", s.noise},
          {"rotated", s.rotated},
          {"estimator", s.estimator},
          {"centre", s.takes_radius() ? ordered_json(s.centre) : none},
          {"k", s.takes_radius() ? ordered_json(s.k) : none},
          {"alpha", s.takes_radius() ? ordered_json(s.alpha) : none}};
}

ordered_json to_json(const ErrorNorms& norms) {
  return {{"sup", norms.sup}, {"rms", norms.rms}, {"mean", norms.mean}, {"count", norms.count}};
}

ordered_json to_json(const EstimatorWork& work) {
  return {{"evaluations", work.evaluations},
          {"cells_visited", work.cells_visited},
          {"restarts", work.restarts},
          {"kernel_size", work.kernel_size},
          {"mask_sizes", work.mask_sizes},
          {"fallbacks", work.fallbacks}};
}

ordered_json to_json(const Record& r) {
  ordered_json errors = ordered_json::object();
  for (const auto& [quantity, norms] : r.errors) errors[quantity] = to_json(norms);
  ordered_json json = setting_json(r);
  json.update({{"evaluation", r.evaluation.empty() ? ordered_json() : ordered_json(r.evaluation)},
               {"h", r.h},
               {"digital_radius", r.takes_radius() ? ordered_json(r.digital_radius) : ordered_json()},
               {"shift", r.shift},
               {"offset", r.offset},
               {"surfels", r.surfels},
               {"singular", r.singular},
               {"far", r.far},
               {"components", r.components},
               {"truth_residual", r.worst_residual},
               {"errors", errors},
               {"work", to_json(r.work)},
               {"seconds",
                {{"digitize", r.seconds_digitize},
                 {"truth", r.seconds_truth},
                 {"init", r.seconds_init},
                 {"eval", r.seconds_eval}}}});
  return json;
}

Record record_from(const ordered_json& json) {
  try {
    Record r;
    json.at("shape").get_to(r.shape);
    json.at("dimension").get_to(r.dimension);
    json.at("noise").get_to(r.noise);
    json.at("rotated").get_to(r.rotated);
    json.at("h").get_to(r.h);
    json.at("shift").get_to(r.shift);
    json.at("offset").get_to(r.offset);
    json.at("estimator").get_to(r.estimator);
    if (!json.at("evaluation").is_null()) json.at("evaluation").get_to(r.evaluation);
    if (!json.at("centre").is_null()) json.at("centre").get_to(r.centre);
    if (!json.at("k").is_null()) {
      json.at("k").get_to(r.k);
      json.at("alpha").get_to(r.alpha);
      json.at("digital_radius").get_to(r.digital_radius);
    }
    json.at("surfels").get_to(r.surfels);
    json.at("singular").get_to(r.singular);
    json.at("far").get_to(r.far);
    json.at("components").get_to(r.components);
    json.at("truth_residual").get_to(r.worst_residual);
    for (const auto& [quantity, norms] : json.at("errors").items())
      r.errors.emplace_back(quantity,
                            ErrorNorms{norms.at("sup").get<double>(), norms.at("rms").get<double>(),
                                       norms.at("mean").get<double>(), norms.at("count").get<std::size_t>()});
    const ordered_json& work = json.at("work");
    r.work = {work.at("evaluations"), work.at("cells_visited"), work.at("restarts"), work.at("kernel_size"),
              work.at("mask_sizes"), work.at("fallbacks")};
    const ordered_json& seconds = json.at("seconds");
    r.seconds_digitize = seconds.at("digitize");
    r.seconds_truth = seconds.at("truth");
    r.seconds_init = seconds.at("init");
    r.seconds_eval = seconds.at("eval");
    return r;
  } catch (const nlohmann::json::exception& error) {
    throw InputError(std::string("not a record: ") + error.what());
  }
}

}  // namespace gridstep
