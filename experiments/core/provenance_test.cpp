#include "experiments/core/provenance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "experiments/core/norms.hpp"

namespace gridstep {
namespace {

/// In a pattern 0 stands for any digit, every other character for itself.
bool matches(std::string_view text, std::string_view pattern) {
  return std::equal(text.begin(), text.end(), pattern.begin(), pattern.end(),
                    [](char c, char p) { return p == '0' ? '0' <= c && c <= '9' : c == p; });
}

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
    EXPECT_NE(version.get<std::string>().find_first_of("123456789"), std::string::npos) << library;
  EXPECT_TRUE(p["dirty"].is_boolean());
  EXPECT_GE(p["cores"], 1);
  EXPECT_EQ(p["norms"], norm_definition);
  EXPECT_NE(p["flags"].get<std::string>().find("-ffp-contract=off"), std::string::npos);
}

TEST(Provenance, CommitIsAHashOrUnknown) {
  const std::string commit = provenance()["commit"];
  const bool is_hash =
      commit.size() >= 40 && commit.find_first_not_of("0123456789abcdef") == std::string::npos;
  EXPECT_TRUE(is_hash || commit == "unknown") << commit;
}

TEST(Provenance, TimeIsUtc) {
  EXPECT_TRUE(matches(provenance()["time"].get<std::string>(), "0000-00-00T00:00:00Z"));
}

}  // namespace
}  // namespace gridstep
