#include "experiments/core/schedule.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "experiments/core/json_reader.hpp"
#include "shapes/base/contracts.hpp"

namespace gridstep {
namespace {

Schedule read(const std::string& text) {
  const nlohmann::json value = nlohmann::json::parse(text);
  JsonReader reader(value, "study.json");
  return Schedule::read(reader);
}

std::string failure_of(const std::string& text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no failure";
}

TEST(Schedule, IsGeometricWithBothEndsExact) {
  const std::vector<double> h = Schedule::geometric(1, 0.05, 12).values();
  ASSERT_EQ(h.size(), 12u);
  EXPECT_EQ(h.front(), 1);
  EXPECT_EQ(h.back(), 0.05);
  for (std::size_t i = 1; i < h.size(); ++i) EXPECT_NEAR(h[i] / h[i - 1], std::pow(0.05, 1.0 / 11), 1e-14);
  EXPECT_EQ(Schedule::geometric(0.3, 0.1, 2).values(), (std::vector<double>{0.3, 0.1}));
}

TEST(Schedule, HasTheStepsOfThePapers) {
  const std::vector<double> h = Schedule::papers(0, 87).values();
  ASSERT_EQ(h.size(), 88u);
  EXPECT_EQ(h[0], 1);
  EXPECT_DOUBLE_EQ(h[10], std::exp(-1.0));
  EXPECT_DOUBLE_EQ(h[87], std::exp(-8.7));
}

TEST(Schedule, IsReadFromJson) {
  EXPECT_EQ(read(R"({"from": 1, "to": 0.05, "steps": 12})").values(),
            Schedule::geometric(1, 0.05, 12).values());
  EXPECT_EQ(read(R"({"papers": {"first": 0, "last": 87}})").values(), Schedule::papers(0, 87).values());
  EXPECT_EQ(read(R"({"values": [1, 0.5, 0.125]})").values(), (std::vector<double>{1, 0.5, 0.125}));
}

TEST(Schedule, NamesTheKeyAndTheValueThatAreWrong) {
  const std::pair<const char*, const char*> cases[] = {
      {R"({"from": -1, "to": 0.05, "steps": 12})", "from = -1 must be a positive, finite number"},
      {R"({"from": 1, "to": 0, "steps": 12})", "to = 0 must be a positive, finite number"},
      {R"({"from": 0.1, "to": 1, "steps": 12})",
       "to = 1 must be less than from = 0.1: steps go from coarse to fine"},
      {R"({"from": 1, "to": 1, "steps": 12})",
       "to = 1 must be less than from = 1: steps go from coarse to fine"},
      {R"({"from": 1, "to": 0.5, "steps": 1})", "steps = 1 must be from 2 to 10000"},
      {R"({"from": 1, "to": 0.5, "steps": 2000000000})", "steps = 2000000000 must be from 2 to 10000"},
      {R"({"from": 1, "to": 0.5, "steps": 2.5})", "steps = 2.5 must be an integer"},
      {R"({"from": null, "to": 0.5, "steps": 2})", "from = null must be a number"},
      {R"({"from": 1, "steps": 2})", "key 'to' is missing"},
      {R"({"from": 1, "to": 0.5, "steps": 3, "step": 2})",
       "unknown key 'step' (known: from, papers, steps, to, values)"},
      {R"({"papers": {"first": 5, "last": 5}})", "papers: last = 5 must be greater than first = 5"},
      {R"({"papers": {"first": 0, "last": 100000}})", "papers: last = 100000 must be from -1000 to 1000"},
      {R"({"values": []})", "values = [] must have at least one grid step"},
      {R"({"values": [1, 2]})", "values[1] = 2 must be less than values[0] = 1"},
      {R"({"values": [1, "a"]})", "values[1] = \"a\" must be a number"},
      {R"({"values": [1, -2]})", "values[1] = -2 must be a positive, finite number"}};
  for (const auto& [text, message] : cases)
    EXPECT_EQ(failure_of(text), std::string("study.json: ") + message);
}

TEST(Schedule, RefusesNotANumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  EXPECT_THROW(Schedule::geometric(nan, 0.5, 3), InputError);
  EXPECT_THROW(Schedule::geometric(1, nan, 3), InputError);
  EXPECT_THROW(Schedule::geometric(inf, 1, 3), InputError);
  EXPECT_THROW(Schedule::of({1, nan}), InputError);
}

}  // namespace
}  // namespace gridstep
