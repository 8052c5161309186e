#include "experiments/core/provenance.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "experiments/core/norms.hpp"

namespace gridstep {
namespace {

TEST(Provenance, SaysEverythingAndInTheSameOrder) {
  const nlohmann::ordered_json p = provenance();
  const std::vector<std::string> keys{"program",    "version", "commit",    "dirty", "compiler",
                                      "build_type", "flags",   "libraries", "cpu",   "cores",
                                      "os",         "norms",   "time"};
  std::vector<std::string> found;
  for (const auto& [key, value] : p.items()) found.push_back(key);
  EXPECT_EQ(found, keys);
  for (const char* key : {"version", "commit", "compiler", "flags", "cpu", "os"})
    EXPECT_NE(p[key], "") << key;
  for (const auto& [library, version] : p["libraries"].items())
    EXPECT_TRUE(std::regex_match(version.get<std::string>(), std::regex(R"(\d+\.\d+(\.\d+)?)"))) << library;
  EXPECT_TRUE(p["dirty"].is_boolean());
  EXPECT_GE(p["cores"], 1);
  EXPECT_EQ(p["norms"], norm_definition);
  EXPECT_NE(p["flags"].get<std::string>().find("-ffp-contract=off"), std::string::npos);
}

TEST(Provenance, CommitIsAHashOrUnknown) {
  const std::string commit = provenance()["commit"];
  EXPECT_TRUE(commit == "unknown" || std::regex_match(commit, std::regex("[0-9a-f]{40,64}"))) << commit;
}

TEST(Provenance, TimeIsUtc) {
  EXPECT_TRUE(std::regex_match(provenance()["time"].get<std::string>(),
                               std::regex(R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ)")));
}

}  // namespace
}  // namespace gridstep
