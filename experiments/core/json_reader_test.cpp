#include "experiments/core/json_reader.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "experiments/core/testing_files.hpp"
#include "shapes/base/contracts.hpp"

namespace gridstep {
namespace {

using nlohmann::json;

std::string failure_of_loading(const std::string& text) {
  const TemporaryFolder folder;
  const std::string file = folder.path() / "study.json";
  std::ofstream(file) << text;
  const std::string what = failure_of([&] { load_json(file); });
  EXPECT_TRUE(what.starts_with(file + ": ")) << what;
  return what.substr(file.size() + 2);
}

TEST(JsonReader, ReadsEveryKindOfValue) {
  const json value = json::parse(R"({"n": 1.5, "i": 12.0, "s": 18446744073709551615, "b": true, "t": "x",
                                     "ns": [1, 2.5], "ts": ["a"], "o": {"k": 3}, "os": [{"k": 1}, {"k": 2}]})");
  JsonReader reader(value, "study.json");
  EXPECT_EQ(reader.number("n"), 1.5);
  EXPECT_EQ(reader.number("absent", 7), 7);
  EXPECT_EQ(reader.integer("i"), 12);
  EXPECT_EQ(reader.integer("absent", 8), 8);
  EXPECT_EQ(reader.seed("s", 0), 18446744073709551615u);
  EXPECT_EQ(reader.seed("absent", 9), 9u);
  EXPECT_TRUE(reader.boolean("b", false));
  EXPECT_EQ(reader.text("t"), "x");
  EXPECT_EQ(reader.text("absent", "y"), "y");
  EXPECT_EQ(reader.numbers("ns"), (std::vector<double>{1, 2.5}));
  EXPECT_EQ(reader.texts("ts"), std::vector<std::string>{"a"});
  EXPECT_EQ(reader.object("o").integer("k"), 3);
  EXPECT_EQ(reader.objects("os")[1].integer("k"), 2);
  EXPECT_NO_THROW(reader.finish());
}

TEST(JsonReader, NamesThePathTheKeyAndTheValue) {
  const json value =
      json::parse(R"({"sweeps": [{"radius": {"k": "three", "kk": 1, "alpha": 0.3}}], "list": [1, "two"]})");
  JsonReader reader(value, "study.json");
  JsonReader radius = reader.objects("sweeps")[0].object("radius");
  EXPECT_EQ(failure_of([&] { radius.number("k"); }),
            "study.json: sweeps[0].radius: k = \"three\" must be a number");
  EXPECT_EQ(failure_of([&] { radius.text("name"); }), "study.json: sweeps[0].radius: key 'name' is missing");
  radius = reader.objects("sweeps")[0].object("radius");
  radius.has("k");
  radius.number("alpha", 1);
  EXPECT_EQ(failure_of([&] { radius.finish(); }),
            "study.json: sweeps[0].radius: unknown key 'kk' (known: alpha, k)");
  EXPECT_EQ(failure_of([&] { reader.numbers("list"); }), "study.json: list[1] = \"two\" must be a number");
  EXPECT_EQ(failure_of([&] { reader.object("list"); }), "study.json: list: [1,\"two\"] must be an object");
  EXPECT_EQ(failure_of([&] { reader.objects("list"); }), "study.json: list[0]: 1 must be an object");
  EXPECT_EQ(failure_of([&] { radius.fail("alpha", "greater than 1"); }),
            "study.json: sweeps[0].radius: alpha = 0.3 must be greater than 1");
  EXPECT_EQ(failure_of([] { JsonReader(json(3), "study.json"); }), "study.json: 3 must be an object");
}

TEST(JsonReader, RefusesNumbersOfTheWrongKind) {
  const json value = json::parse(R"({"half": 0.5, "huge": 1e10, "negative": -1, "text": "1", "null": null})");
  JsonReader reader(value, "x");
  for (const char* key : {"half", "huge", "text", "null"})
    EXPECT_THROW(reader.integer(key), InputError) << key;
  for (const char* key : {"half", "negative", "text", "null"})
    EXPECT_THROW(reader.seed(key, 0), InputError) << key;
  EXPECT_THROW(reader.number("null", 1), InputError);
  EXPECT_THROW(reader.boolean("text", true), InputError);
}

TEST(JsonReader, CutsLongValuesShort) {
  const json value = {{"k", std::string(1000, 'x')}};
  EXPECT_LT(failure_of([&] { JsonReader(value, "x").number("k"); }).size(), 100u);
}

TEST(LoadJson, ReadsWhatIsWellFormed) {
  const TemporaryFolder folder;
  const std::string file = folder.path() / "study.json";
  std::ofstream(file) << R"({"a": {"k": 1}, "b": {"k": 2}, "c": [{"k": 3}, {"k": 4}]})";
  EXPECT_EQ(load_json(file)["c"][1]["k"], 4);  // a key may come back in another object
}

TEST(LoadJson, SaysInOneLineWhereAFileIsMalformed) {
  EXPECT_TRUE(failure_of_loading("{\n  \"a\": 1,\n  oops\n}").starts_with("line 3, column 3: syntax error"));
  EXPECT_TRUE(failure_of_loading("").starts_with("line 1, column 1: "));
  EXPECT_TRUE(failure_of_loading("{} {}").starts_with("line 1, column 4: "));
  EXPECT_NE(failure_of_loading("[1e999]").find("1e999"), std::string::npos);
  EXPECT_EQ(failure_of_loading("{\n \"a\": [").find('\n'), std::string::npos);
}

TEST(LoadJson, RefusesAKeyGivenTwice) {
  EXPECT_EQ(failure_of_loading(R"({"a": {"k": 1, "b": {"k": 1}, "k": 2}})"),
            "key 'k' is given twice in one object");
}

TEST(LoadJson, DeepNestingIsAnErrorNotAnOverflow) {
  const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  EXPECT_NO_THROW(parse_json(nested(100), "text"));
  for (const std::size_t depth : {102, 1000000})
    EXPECT_EQ(failure_of([&] { parse_json(nested(depth), "text"); }), "text: nested deeper than 100");
}

TEST(LoadJson, SaysWhyAFileCannotBeRead) {
  EXPECT_EQ(failure_of([] { load_json("/nonexistent/study.json"); }),
            "/nonexistent/study.json: cannot be read: No such file or directory");
  EXPECT_EQ(failure_of([] { load_json("/proc/self"); }), "/proc/self: cannot be read: Is a directory");
}

}  // namespace
}  // namespace gridstep
