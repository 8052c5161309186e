#include "estimators/integral_invariant/radial/radial_kernel.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <numbers>

#include "shapes/base/contracts.hpp"

namespace gridstep {
namespace {

using std::numbers::pi;

void expect_coefficients(const RadialKernel& kernel, const std::vector<double>& expected) {
  ASSERT_EQ(kernel.coefficients.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(kernel.coefficients[i], expected[i], 1e-11);
}

TEST(VanishingKernel, HasTheKnownForms) {
  expect_coefficients(vanishing_kernel(3, 1, {}), {1});
  expect_coefficients(vanishing_kernel(3, 0, std::array{0}), {1, -2});
  expect_coefficients(vanishing_kernel(3, 1, std::array{0}), {1, -3});
  expect_coefficients(vanishing_kernel(3, 2, std::array{0}), {1, -4});
  expect_coefficients(vanishing_kernel(3, 1, std::array{0, 4}), {1, -7, 8});
  expect_coefficients(vanishing_kernel(3, 1, std::array{6}), {1, -1.5});
  expect_coefficients(vanishing_kernel(2, 1, std::array{0}), {1, -5});
  expect_coefficients(vanishing_kernel(2, 1, std::array{0, 4}), {1, -58 / 5.0, 77 / 5.0});
}

TEST(VanishingKernel, HasNoneOfTheMoments) {
  for (const int d : {2, 3})
    for (const int p : {0, 1, 2, 5})
      for (const auto& orders : {std::vector{0}, {4}, {0, 4}, {0, 4, 6}, {0, 4, 6, 8}, {2, 6}}) {
        const RadialKernel kernel = vanishing_kernel(d, p, orders);
        double scale = 0;
        for (const double c : kernel.coefficients) scale += std::abs(c);
        for (const int order : orders)
          EXPECT_NEAR(kernel.moment(d - 1, order), 0, 1e-13 * scale) << d << p << order;
        EXPECT_GT(std::abs(kernel.moment(d - 1, orders.front() == 2 ? 0 : 2)), 1e-6);
      }
}

TEST(RadialKernel, MomentsAreIntegrals) {
  boost::math::quadrature::tanh_sinh<long double> integrator;
  for (const RadialKernel& kernel :
       {RadialKernel{0, {1}}, RadialKernel{1, {1, -7, 8}}, RadialKernel{3, {0.5, 2, -1, 4}}})
    for (const int order : {0, 1, 2, 4, 6})
      for (const int dimension : {1, 2, 3}) {
        const long double sphere = dimension == 1 ? 2 : dimension == 2 ? 2 * pi : 4 * pi;
        const long double integral = integrator.integrate(
            [&](long double r) {
              return sphere * std::pow(r, static_cast<long double>(order + dimension - 1)) *
                     kernel(double(r * r));
            },
            0.0L, 1.0L);
        EXPECT_NEAR(kernel.moment(dimension, order), double(integral), 1e-13);
      }
}

TEST(VanishingKernel, RefusesWhatItCannotMake) {
  EXPECT_THROW(vanishing_kernel(4, 1, std::array{0}), InputError);
  EXPECT_THROW(vanishing_kernel(3, -1, std::array{0}), InputError);
  EXPECT_THROW(vanishing_kernel(3, 9, std::array{0}), InputError);
  EXPECT_THROW(vanishing_kernel(3, 1, std::array{1}), InputError);
  EXPECT_THROW(vanishing_kernel(3, 1, std::array{-2}), InputError);
  EXPECT_THROW(vanishing_kernel(3, 1, std::array{4, 4}), InputError);
  EXPECT_THROW(vanishing_kernel(3, 1, std::array{0, 2, 4, 6, 8, 10, 12}), InputError);
}

}  // namespace
}  // namespace gridstep
