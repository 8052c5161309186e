#include "shapes/analytic/parameters.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "shapes/analytic/catalogue.hpp"
#include "shapes/base/contracts.hpp"

namespace gridstep {
namespace {

/// Runs `action` and returns the message of its InputError.
template <class Action>
std::string error_of(Action action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

struct BadText {
  std::string text;
  std::vector<std::string> named;  // what the message must name
};
void PrintTo(const BadText& bad, std::ostream* out) {
  *out << '"' << bad.text << '"';
}

class BadShape : public testing::TestWithParam<BadText> {};

TEST_P(BadShape, IsAnErrorThatNamesKeyAndValue) {
  const std::string message = error_of([] { make_shape(ShapeSpec::parse(GetParam().text)); });
  for (const std::string& part : GetParam().named)
    EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' is not in: " << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << "more than one line: " << message;
}

INSTANTIATE_TEST_SUITE_P(
    Texts, BadShape,
    testing::Values(
        BadText{"elipse", {"unknown shape 'elipse'", "ellipse"}}, BadText{"", {"unknown shape ''"}},
        BadText{" disk", {"unknown shape ' disk'"}},
        BadText{"disk:r=3", {"'disk'", "no parameter 'r'", "radius"}},
        BadText{"sphere:cw=3", {"no parameter 'cw'", "cz"}}, BadText{"disk:cz=1", {"no parameter 'cz'"}},
        BadText{"disk:radius=five", {"radius", "'five'", "not a number"}},
        BadText{"disk:radius=", {"radius", "''", "not a number"}},
        BadText{"disk:radius=5m", {"radius", "'5m'", "not a number"}},
        BadText{"disk:radius= 5", {"radius", "' 5'", "not a number"}},
        BadText{"disk:radius=+-5", {"radius", "'+-5'", "not a number"}},
        BadText{"disk:radius=0x10", {"radius", "'0x10'", "not a number"}},
        BadText{"disk:radius=1e999", {"radius", "'1e999'"}},
        BadText{"disk:radius=nan", {"radius", "nan", "finite"}},
        BadText{"disk:radius=inf", {"radius", "inf", "finite"}},
        BadText{"disk:cx=-inf", {"cx", "-inf", "finite"}}, BadText{"disk:radius=-5", {"radius", "-5", "> 0"}},
        BadText{"disk:radius=0", {"radius = 0", "> 0"}},
        BadText{"disk:5,radius=6", {"radius", "given twice"}},
        BadText{"disk:radius=5,radius=5", {"radius", "given twice"}},
        BadText{"disk:1,2,3,4", {"too many", "'4'"}}, BadText{"disk:", {"name=value", "''"}},
        BadText{"disk:5,,1", {"name=value", "''"}}, BadText{"disk:=5", {"name=value", "'=5'"}},
        BadText{"flower:radius=7,amplitude=7",
                {"amplitude", "smaller than radius", "amplitude=7", "radius=7"}},
        BadText{"accflower:5,6", {"amplitude", "smaller than radius", "amplitude=6"}},
        BadText{"flower:amplitude=-1", {"amplitude", "-1", ">= 0"}},
        BadText{"flower:petals=2.5", {"petals", "2.5", "integer"}},
        BadText{"flower:petals=0", {"petals", "0", ">= 1"}}, BadText{"ngon:sides=2", {"sides", "2", ">= 3"}},
        BadText{"lpball:power=3", {"power", "even", "power=3"}},
        BadText{"lpball:power=34", {"power", "34", "<= 32"}},
        BadText{"torus:2,6", {"minor", "smaller than major", "minor=6"}},
        BadText{"polynomial:bound=-1", {"bound", "-1"}},
        BadText{"polynomial:x^2+q", {"x^2+q", "character 5", "'q'"}},
        BadText{"polynomial:x^2+y^2+z^2+1", {"x^2+y^2+z^2+1", "never negative"}}));

TEST(ShapeSpec, ValuesGoByPositionOrByName) {
  const std::string by_name = ShapeSpec::parse("ellipse:b=7,a=20,angle=0.3").canonical();
  EXPECT_EQ(by_name, "ellipse:a=20,b=7,angle=0.3");
  EXPECT_EQ(ShapeSpec::parse("ellipse:20,7,0.3").canonical(), by_name);
  EXPECT_EQ(ShapeSpec::parse("ellipse:20,7,angle=+0.3").canonical(), by_name);
  EXPECT_EQ(ShapeSpec::parse("ellipse:2e1,7.0,.3,0,0").canonical(), by_name);
}

TEST(ShapeSpec, ATextParameterIsKeptAsItIs) {
  const ShapeSpec spec = ShapeSpec::parse("polynomial:x^2+y^2+z^2-9,bound=4");
  EXPECT_EQ(std::get<std::string>(spec.values.at("formula")), "x^2+y^2+z^2-9");
  EXPECT_EQ(spec.canonical(), "polynomial:formula=x^2+y^2+z^2-9,bound=4");
  EXPECT_EQ(ShapeSpec::parse(spec.canonical()).canonical(), spec.canonical());
}

TEST(ShapeSpec, JsonMeansTheSameAsText) {
  const auto object = nlohmann::json::parse(R"({"name": "ellipse", "a": 20, "b": 7, "angle": 0.3})");
  EXPECT_EQ(ShapeSpec::parse(object).canonical(), ShapeSpec::parse("ellipse:20,7,0.3").canonical());
  EXPECT_EQ(ShapeSpec::parse(nlohmann::json("ellipse:20,7,0.3")).canonical(),
            ShapeSpec::parse("ellipse:20,7,0.3").canonical());
}

TEST(ShapeSpec, JsonOfTheWrongTypeIsAnErrorThatNamesKeyAndValue) {
  const auto error = [](const char* text) {
    return error_of([&] { make_shape(ShapeSpec::parse(nlohmann::json::parse(text))); });
  };
  EXPECT_NE(error("[1]").find("[1]"), std::string::npos);
  EXPECT_NE(error(R"({"a": 1})").find("\"name\""), std::string::npos);
  EXPECT_NE(error(R"({"name": 3})").find("{\"name\":3}"), std::string::npos);
  EXPECT_NE(error(R"({"name": "disk", "radius": true})").find("radius = true"), std::string::npos);
  EXPECT_NE(error(R"({"name": "disk", "radius": [5]})").find("radius = [5]"), std::string::npos);
  EXPECT_NE(error(R"({"name": "disk", "radius": null})").find("radius = null"), std::string::npos);
  EXPECT_NE(error(R"({"name": "disk", "radius": "5"})").find("radius = '5' must be a number"),
            std::string::npos);
  EXPECT_NE(error(R"({"name": "polynomial", "formula": 5})").find("formula = '5' must be a text"),
            std::string::npos);
  EXPECT_NE(error(R"({"name": "disc"})").find("unknown shape 'disc'"), std::string::npos);
  EXPECT_NE(error(R"({"name": "disk", "r": 2})").find("no parameter 'r'"), std::string::npos);
}

}  // namespace
}  // namespace gridstep
