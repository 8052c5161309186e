#include "shapes/analytic/formula.hpp"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "shapes/analytic/catalogue.hpp"
#include "shapes/analytic/implicit_shape.hpp"
#include "shapes/analytic/simd_formula.hpp"
#include "shapes/base/contracts.hpp"
#include "shapes/base/random.hpp"
#include "shapes/base/taylor_model.hpp"

namespace gridstep {
namespace {

double at(const Formula& formula, double x, double y = 0, double z = 0) {
  const std::array variables{x, y, z};
  return formula(std::span<const double>(variables));
}

std::string error_of(const std::string& text) {
  try {
    Formula formula(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

struct Case {
  std::string text;
  std::function<double(double, double, double)> value;
  int variables, degree;
};
void PrintTo(const Case& c, std::ostream* out) {
  *out << '"' << c.text << '"';
}

class FormulaValue : public testing::TestWithParam<Case> {};

TEST_P(FormulaValue, EqualsDirectEvaluation) {
  const Case& c = GetParam();
  const Formula formula(c.text);
  EXPECT_EQ(formula.variables(), c.variables);
  EXPECT_EQ(formula.degree(), c.degree);
  EXPECT_EQ(formula.text(), c.text);
  RandomStream random{1};
  for (int i = 0; i < 50; ++i) {
    const double x = 4 * random.uniform() - 2, y = 4 * random.uniform() - 2, z = 4 * random.uniform() - 2;
    const double expected = c.value(x, y, z);
    EXPECT_NEAR(at(formula, x, y, z), expected, 1e-12 * (1 + std::abs(expected)));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Grammar, FormulaValue,
    testing::Values(Case{"3", [](double, double, double) { return 3.0; }, 0, 0},
                    Case{"  x  ", [](double x, double, double) { return x; }, 1, 1},
                    Case{"z", [](double, double, double z) { return z; }, 3, 1},
                    Case{"x+y*z", [](double x, double y, double z) { return x + y * z; }, 3, 2},
                    Case{"x-y-z", [](double x, double y, double z) { return x - y - z; }, 3, 1},
                    Case{"(x-(y-z))", [](double x, double y, double z) { return x - y + z; }, 3, 1},
                    Case{"-x^2", [](double x, double, double) { return -(x * x); }, 1, 2},
                    Case{"(-x)^2", [](double x, double, double) { return x * x; }, 1, 2},
                    Case{"1-x^2", [](double x, double, double) { return 1 - x * x; }, 1, 2},
                    Case{"y*-x^2", [](double x, double y, double) { return -y * x * x; }, 2, 3},
                    Case{"--x", [](double x, double, double) { return x; }, 1, 1},
                    Case{"+x-+y", [](double x, double y, double) { return x - y; }, 2, 1},
                    Case{"x/2/4", [](double x, double, double) { return x / 8; }, 1, 1},
                    Case{"x/-2", [](double x, double, double) { return -x / 2; }, 1, 1},
                    Case{"x/2*y", [](double x, double y, double) { return x / 2 * y; }, 2, 2},
                    Case{"(x/9)^2+(y/7)^2-1",
                         [](double x, double y, double) { return x * x / 81 + y * y / 49 - 1; }, 2, 2},
                    Case{"2*x^3*y^2", [](double x, double y, double) { return 2 * x * x * x * y * y; }, 2, 5},
                    Case{"(x+y)^7", [](double x, double y, double) { return std::pow(x + y, 7); }, 2, 7},
                    Case{"x^0", [](double, double, double) { return 1.0; }, 1, 0},
                    Case{"x^1", [](double x, double, double) { return x; }, 1, 1},
                    Case{"(1*x)^0*x", [](double x, double, double) { return x; }, 1, 1},
                    Case{"(2*x)^0*2*x+y", [](double x, double y, double) { return 2 * x + y; }, 2, 1},
                    Case{"-2*x*-3^2", [](double x, double, double) { return 18 * x; }, 1, 1},
                    Case{"-(2-x)*y-x^0*4", [](double x, double y, double) { return (x - 2) * y - 4; }, 2, 2},
                    Case{"((x))^2", [](double x, double, double) { return x * x; }, 1, 2},
                    Case{"2*3+4*5-x", [](double x, double, double) { return 26 - x; }, 1, 1},
                    Case{"(6*6-2*2)*x^0+2*y", [](double, double y, double) { return 32 + 2 * y; }, 2, 1},
                    Case{"1.5e-1*x + .25", [](double x, double, double) { return 0.15 * x + 0.25; }, 1, 1}));

struct BadFormula {
  std::string text;
  std::vector<std::string> named;
};
void PrintTo(const BadFormula& bad, std::ostream* out) {
  *out << '"' << bad.text << '"';
}

class FormulaError : public testing::TestWithParam<BadFormula> {};

TEST_P(FormulaError, NamesTheFormulaAndTheCharacter) {
  const std::string message = error_of(GetParam().text);
  EXPECT_NE(message.find("polynomial '" + GetParam().text + "'"), std::string::npos) << message;
  for (const std::string& part : GetParam().named)
    EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' is not in: " << message;
}

INSTANTIATE_TEST_SUITE_P(
    Grammar, FormulaError,
    testing::Values(
        BadFormula{"", {"character 1", "where it ends"}}, BadFormula{"x+", {"character 3", "where it ends"}},
        BadFormula{"x y", {"an operator", "character 3", "'y'"}},
        BadFormula{"2x", {"an operator", "character 2", "'x'"}},
        BadFormula{"(x", {"')'", "character 3", "where it ends"}}, BadFormula{"x)", {"character 2", "')'"}},
        BadFormula{"x^y", {"an exponent 0 .. 64", "character 3", "'y'"}},
        BadFormula{"x^-2", {"an exponent 0 .. 64", "character 3"}},
        BadFormula{"x^65", {"an exponent 0 .. 64", "character 3"}},
        BadFormula{"x^99999999999", {"an exponent 0 .. 64"}},
        BadFormula{"x^2.5", {"an operator", "character 4", "'.'"}},
        BadFormula{"x^2^3", {"an operator", "character 4", "'^'"}},
        BadFormula{"x/y", {"a number to divide by", "character 3", "'y'"}},
        BadFormula{"x/0", {"divisor other than 0"}}, BadFormula{"x/1e-320", {"divisor other than 0"}},
        BadFormula{"x^40*y^40", {"a degree of at most 64"}},
        BadFormula{"(x^9)^9", {"a degree of at most 64"}}, BadFormula{"1e999*x", {"a number", "character 1"}},
        BadFormula{"nan", {"a number", "character 1"}}, BadFormula{"inf*x", {"a number"}},
        BadFormula{"sin(x)", {"character 1", "'s'"}}, BadFormula{"x;y", {"character 2", "';'"}},
        BadFormula{"X", {"character 1", "'X'"}}));

TEST(FormulaErrors, TakeOneLineWhateverTheTextIs) {
  EXPECT_EQ(error_of("x\n\x1b"),
            "polynomial 'x?"
            "?': expected an operator or the end at character 3, not '?'");
  EXPECT_EQ(error_of(std::string("x\0y", 3)),
            "polynomial 'x?y': expected an operator or the end at character 2, not '?'");
}

TEST(FormulaLimits, DeepNestingIsAnErrorNotAnOverflow) {
  EXPECT_EQ(at(Formula(std::string(150, '(') + "x" + std::string(150, ')')), 3), 3);
  for (const std::string& text : {std::string(1000000, '('), std::string(1000000, '-')})
    EXPECT_NE(error_of(text).find("at most 200 nested"), std::string::npos);
}

TEST(FormulaLimits, LongFormulasAreAnErrorNotAnExhaustion) {
  std::string text = "x";
  for (int i = 0; i < 2000; ++i) text += "+x";
  EXPECT_EQ(at(Formula(text), 1), 2001);
  for (int i = 0; i < 20000; ++i) text += "+x";
  EXPECT_NE(error_of(text).find("at most 10000 operations"), std::string::npos);
}

/// A random formula of bounded depth, so that every rule of the grammar meets every other.
std::string random_formula(RandomStream& random, int depth) {
  if (depth == 0)
    return random.below(3) == 0 ? std::to_string(random.below(9)) + ".5"
                                : std::string(1, "xyz"[random.below(3)]);
  const auto part = [&] { return random_formula(random, depth - 1); };
  switch (random.below(6)) {
    case 0:
      return part() + "+" + part();
    case 1:
      return part() + "-(" + part() + ")";
    case 2:
      return std::string("(").append(part()) + ")*(" + part() + ")";
    case 3:
      return std::string("(").append(part()) + ")^" + std::to_string(random.below(4));
    case 4:
      return std::string("-").append(part());
    default:
      return std::string("(").append(part()) + ")/" + std::to_string(1 + random.below(7));
  }
}

RealPoint<3> random_point(RandomStream& random) {
  return RealPoint<3>(random.uniform(), random.uniform(), random.uniform()) * 3 - RealPoint<3>::Constant(1.5);
}

TEST(FormulaProperties, IntervalsContainEveryComputedValue) {
  RandomStream random{2};
  for (int trial = 0; trial < 2000; ++trial) {
    const Formula formula(random_formula(random, 1 + trial % 3));
    const RealPoint<3> lo = random_point(random);
    const double width = std::exp2(-50 * random.uniform());  // down to a few units of the last place
    std::array<Interval, 3> box;
    for (int k = 0; k < 3; ++k) box[k] = Interval(lo[k], lo[k] + width * random.uniform());
    const Interval bound = formula(std::span<const Interval>(box));
    for (int sample = 0; sample < 30; ++sample) {
      std::array<double, 3> p;
      for (int k = 0; k < 3; ++k)
        p[k] =
            std::min(box[k].upper(), box[k].lower() + random.uniform() * (box[k].upper() - box[k].lower()));
      const double value = formula(std::span<const double>(p));
      ASSERT_LE(bound.lower(), value) << formula.text();
      ASSERT_GE(bound.upper(), value) << formula.text();
      std::array<double, 3> magnitudes{std::abs(p[0]), std::abs(p[1]), std::abs(p[2])};
      ASSERT_LE(std::abs(value), formula.magnitude(magnitudes) * (1 + 1e-12)) << formula.text();
    }
  }
}

TEST(FormulaProperties, TaylorModelsAndTheirBoundsHoldEveryComputedValue) {
  RandomStream random{4};
  double tightest = 1, tightest_bound = 1;
  for (int trial = 0; trial < 3000; ++trial) {
    const Formula formula(random_formula(random, 1 + trial % 3));
    const RealPoint<3> lo = random_point(random);
    const double width = 3 * std::exp2(-52 * random.uniform());  // down to a few units of the last place
    RealBox<3> box(lo, lo);
    for (int k = 0; k < 3; ++k) box.max()[k] += width * random.uniform();
    const auto variables = TaylorModel<3>::variables(box);
    const TaylorModel<3> model = formula(std::span<const TaylorModel<3>>(variables));
    const QuadraticBound<3> bound = bound_of(model, box);
    for (int sample = 0; sample < 30; ++sample) {
      std::array<double, 3> p;
      std::array<long double, 3> x{};
      long double quadratic = model.value(), of_bound = bound.value;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto axis = Eigen::Index(k);
        const double side = sample < 8 ? (sample >> k) & 1 : random.uniform();  // corners, then within
        p[k] = side == 1 ? box.max()[axis]
                         : std::min(box.min()[axis] + side * box.sizes()[axis], box.max()[axis]);
        const double reach = variables[k].slope()[axis];
        if (reach > 0) x[k] = (static_cast<long double>(p[k]) - variables[k].value()) / reach;
        quadratic += model.slope()[axis] * x[k];
      }
      const Eigen::Matrix<long double, 3, 1> from_centre =
          Eigen::Map<const RealPoint<3>>(p.data()).cast<long double>() - bound.centre.cast<long double>();
      of_bound +=
          from_centre.dot(bound.slope.cast<long double>() + bound.bend.cast<long double>() * from_centre);
      for (std::size_t j = 0, pair = 0; j < 3; ++j)
        for (std::size_t k = j; k < 3; ++k, ++pair)
          quadratic += model.bend()[Eigen::Index(pair)] * x[j] * x[k];
      const double value = formula(std::span<const double>(p));
      const double off = double(std::abs(value - quadratic)), off_bound = double(std::abs(value - of_bound));
      ASSERT_LE(off, model.error) << formula.text();
      ASSERT_LE(off_bound, bound.error) << formula.text();
      if (off > 0) tightest = std::min(tightest, 1 - off / model.error);
      if (off_bound > 0) tightest_bound = std::min(tightest_bound, 1 - off_bound / bound.error);
    }
  }
  EXPECT_LT(tightest, 0.01) << "errors are never reached: far too large";
  EXPECT_LT(tightest_bound, 0.01) << "errors are never reached: far too large";
}

/// On every instruction set that was compiled and that this processor has.
template <int d>
void expect_many_places_as_each() {
  RandomStream random{6};
  for (int trial = 0; trial < 500; ++trial) {
    std::string text = random_formula(random, 1 + trial % 4);
    if (d == 2) std::replace(text.begin(), text.end(), 'z', 'y');
    const Formula formula(text);
    const RealPoint<d> corner = random_point(random).template head<d>();
    const double width = 3 * std::exp2(-52 * random.uniform());
    const auto place = [&] {
      RealPoint<d> p = corner;
      for (int k = 0; k < d; ++k) p[k] += width * random.uniform();
      return p;
    };
    std::vector<RealPoint<d>> points;
    std::uint64_t at_most_zero_each = 0;
    for (std::size_t i = 0, count = random.below(65); i < count; ++i) {
      points.push_back(place());
      const double value = formula(std::span<const double>(points[i].data(), d));
      at_most_zero_each |= std::uint64_t(value <= 0) << i;
    }
    std::vector<RealBox<d>> boxes;
    for (std::size_t i = 0, count = random.below(12); i < count; ++i) {
      const RealPoint<d> p = place(), q = place();
      boxes.emplace_back(p.cwiseMin(q), p.cwiseMax(q));
    }
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
      hwy::GetChosenTarget().Update(target);
      EXPECT_EQ(at_most_zero<d>(formula, points), at_most_zero_each) << text;
      std::vector<TaylorModel<d>> models(boxes.size());
      models_over<d>(formula, boxes, models);
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        const auto variables = TaylorModel<d>::variables(boxes[i]);
        const TaylorModel<d> model = formula(std::span<const TaylorModel<d>>(variables));
        EXPECT_TRUE((models[i].terms == model.terms).all()) << text;
        EXPECT_EQ(models[i].error, model.error) << text;
        EXPECT_EQ(models[i].magnitude, model.magnitude) << text;
      }
    }
    hwy::GetChosenTarget().DeInit();
  }
}

TEST(FormulaProperties, ManyPlacesAtOnceHaveTheValuesAndModelsOfEach) {
  expect_many_places_as_each<2>();
  expect_many_places_as_each<3>();
}

TEST(FormulaProperties, TheErrorOfATaylorModelAndItsBoundShrinksWithTheCubeOfTheBox) {
  RandomStream random{5};
  const auto errors = [](const Formula& formula, const RealPoint<3>& p, double reach) {
    const RealBox<3> box{p.array() - reach, p.array() + reach};
    const auto variables = TaylorModel<3>::variables(box);
    const TaylorModel<3> model = formula(std::span<const TaylorModel<3>>(variables));
    return std::pair(model.error, bound_of(model, box).error);
  };
  for (int trial = 0; trial < 300; ++trial) {
    const Formula formula(random_formula(random, 1 + trial % 3));
    const RealPoint<3> p = random_point(random);
    const std::array<double, 3> magnitudes{2, 2, 2};
    const double rounding = 1e-11 * formula.magnitude(magnitudes);
    const auto [small, small_of_bound] = errors(formula, p, 1e-4);
    const auto [large, large_of_bound] = errors(formula, p, 1e-3);
    EXPECT_LE(small, large / 900 + rounding) << formula.text();
    EXPECT_LE(small_of_bound, large_of_bound / 900 + rounding) << formula.text();
  }
}

TEST(FormulaProperties, JetsAreTheDerivatives) {
  RandomStream random{3};
  for (int trial = 0; trial < 500; ++trial) {
    const Formula formula(random_formula(random, 1 + trial % 3));
    const RealPoint<3> p = random_point(random);
    std::array<Jet2<3>, 3> second;
    std::array<Jet1<double, 3>, 3> first;
    std::array<Jet1<Jet1<double, 3>, 3>, 3> nested;
    for (int k = 0; k < 3; ++k) {
      second[k] = Jet2<3>::variable(p[k], k);
      first[k] = Jet1<double, 3>::variable(p[k], k);
      nested[k] = Jet1<Jet1<double, 3>, 3>::variable(first[k], k);
    }
    const auto gradient_at = [&](const RealPoint<3>& q) {
      std::array<Jet2<3>, 3> moved;
      for (int k = 0; k < 3; ++k) moved[k] = Jet2<3>::variable(q[k], k);
      return formula(std::span<const Jet2<3>>(moved)).gradient;
    };
    const Jet2<3> jet = formula(std::span<const Jet2<3>>(second));
    const auto jet1 = formula(std::span<const Jet1<double, 3>>(first));
    const auto jet_of_jets = formula(std::span<const Jet1<Jet1<double, 3>, 3>>(nested));
    EXPECT_EQ(jet.value, at(formula, p[0], p[1], p[2]));
    const std::array<double, 3> magnitudes{2, 2, 2};
    const double tolerance = 1e-6 * (1 + formula.magnitude(magnitudes));
    constexpr double step = 1e-5;
    for (int k = 0; k < 3; ++k) {
      const RealPoint<3> e = step * RealPoint<3>::Unit(k);
      const RealPoint<3> up = p + e, down = p - e;
      EXPECT_NEAR(jet.gradient[k],
                  (at(formula, up[0], up[1], up[2]) - at(formula, down[0], down[1], down[2])) / (2 * step),
                  tolerance)
          << formula.text();
      EXPECT_NEAR(jet1.gradient[k], jet.gradient[k], tolerance) << formula.text();
      const RealPoint<3> row = (gradient_at(up) - gradient_at(down)) / (2 * step);
      for (int j = 0; j < 3; ++j) {
        EXPECT_NEAR(jet.hessian(k, j), row[j], tolerance) << formula.text();
        EXPECT_NEAR(jet_of_jets.gradient[k].gradient[j], jet.hessian(k, j), tolerance) << formula.text();
      }
    }
  }
}

template <int d>
std::string bounds_error(const std::string& text, double bound = 0) {
  try {
    bounds_of<d>(Formula(text), bound);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(BoundsOf, EmptyAndUnboundedSetsAreErrors) {
  for (const std::string text : {"x^2+y^2+z^2+1", "1", "x^2+y^2+z^2+0.001"}) {
    const std::string message = bounds_error<3>(text);
    EXPECT_NE(message.find("'" + text + "' is never negative"), std::string::npos) << message;
  }
  for (const std::string text : {"x", "x^2-1", "x^2+y^2-1", "-1", "x*y*z", "x^2+y^2-z^2"}) {
    const std::string message = bounds_error<3>(text);
    EXPECT_NE(message.find("'" + text + "' is unbounded"), std::string::npos) << message;
  }
  EXPECT_NE(bounds_error<2>("x^2+y^2+z^2-1").find("too many variables"), std::string::npos);
}

TEST(BoundsOf, AGivenBoundMustHoldTheShape) {
  EXPECT_NE(bounds_error<3>("x^2+y^2+z^2-25", 4).find("unbounded there"), std::string::npos);
  EXPECT_NE(bounds_error<3>("x^2+y^2+z^2-25", 4).find("half side 4"), std::string::npos);
  EXPECT_EQ(bounds_error<3>("x^2+y^2+z^2-25", 6), "no error");
  // Too large to be found without help.
  EXPECT_NE(bounds_error<3>("x^2+y^2+z^2-10000000000").find("try bound="), std::string::npos);
  EXPECT_EQ(bounds_error<3>("x^2+y^2+z^2-10000000000", 110000), "no error");
}

TEST(BoundsOf, TheBoxHoldsTheShapeAndIsTight) {
  struct Known {
    std::string text;
    RealPoint<3> reach;
  };
  for (const Known& known :
       {Known{"x^2+y^2+z^2-25", {5, 5, 5}}, Known{"(x/9)^2+(y/7)^2+(z/5)^2-1", {9, 7, 5}},
        Known{"x^4+y^4+z^4-6561", {9, 9, 9}}, Known{"x^2+y^2+z^2-0.01", {0.1, 0.1, 0.1}},
        Known{"x^2+100*y^2+z^2-40000", {200, 20, 200}}}) {
    const RealBox<3> box = bounds_of<3>(Formula(known.text));
    for (int k = 0; k < 3; ++k) {
      EXPECT_GE(box.max()[k], known.reach[k]) << known.text;
      EXPECT_LE(box.min()[k], -known.reach[k]) << known.text;
      EXPECT_LE(box.max()[k], 1.1 * known.reach[k]) << known.text;
      EXPECT_GE(box.min()[k], -1.1 * known.reach[k]) << known.text;
    }
  }
  const RealBox<3> moved = bounds_of<3>(Formula("(x-3)^2+(y+2)^2+z^2-1"));
  EXPECT_TRUE(moved.contains(RealBox<3>(RealPoint<3>(2, -3, -1), RealPoint<3>(4, -1, 1))));
  EXPECT_LE(moved.sizes().maxCoeff(), 2.5);
}

}  // namespace
}  // namespace gridstep
