#include "estimators/contour/binomial.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "estimators/testing_sets.hpp"
#include "shapes/digital/boundary.hpp"

namespace gridstep {
namespace {

using Sequence = std::vector<std::complex<double>>;
using Extended = std::vector<std::complex<long double>>;

/// Quarter-integer points of a closed walk, far from the origin: coordinates as contours have them.
Sequence closed_walk(std::size_t N) {
  RandomStream random({N});
  Sequence z(N);
  std::complex<double> at(1000, -2000);
  for (std::size_t i = 0; i < N; ++i) {
    z[i] = at + std::polar(double(N) / 8, 2 * std::numbers::pi * double(i) / double(N));
    z[i] = {std::floor(4 * z[i].real()) / 4, std::floor(4 * z[i].imag()) / 4};
    if (random.uniform() < 0.5) z[i] += 0.5;
  }
  return z;
}

/// The definition: differences first, then the sum with the mask, wrapped.
Extended direct_sum(const Sequence& z, int n, int order) {
  const std::size_t N = z.size();
  Extended x(z.begin(), z.end());
  for (int times = 0; times < order; ++times) {
    const Extended before = x;
    for (std::size_t i = 0; i < N; ++i) x[i] = before[i] - before[(i + N - 1) % N];
  }
  long double weight = 1;  // C(2n, n + k) / 4^n, here at k = 0
  for (int j = 1; j <= n; ++j) weight *= 1 - 0.5L / j;
  std::vector<long double> mask(N);
  for (int k = 0; k <= n; ++k) {
    mask[std::size_t(k) % N] += weight;
    if (k > 0) mask[(N - std::size_t(k) % N) % N] += weight;
    weight *= (long double)(n - k) / (n + k + 1);
  }
  Extended sum(N);
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t k = 0; k < N; ++k) sum[i] += mask[k] * x[(i + N - k) % N];
  return sum;
}

TEST(BinomialConvolution, IsTheDirectSum) {
  for (const std::size_t N : {4u, 6u, 10u, 2u * 31u, 331u, 512u, 2u * 499u})
    for (const int n : {1, 2, 7, int(N) / 2, int(N), int(5 * N), 20684}) {
      if (n > int(5 * N * N)) continue;  // the mask leaves nothing but the mean: below any rounding
      const Sequence z = closed_walk(N);
      BinomialConvolution smoothed(z, n);
      for (const int order : {0, 1, 2}) {
        const Sequence values = smoothed.difference(order);
        const Extended expected = direct_sum(z, n, order);
        long double largest = 0, error = 0;
        for (std::size_t i = 0; i < N; ++i) {
          largest = std::max(largest, std::abs(expected[i]));
          error = std::max(error, std::abs(std::complex<long double>(values[i]) - expected[i]));
        }
        EXPECT_LE(error, 1e-10L * largest) << "N = " << N << ", n = " << n << ", order " << order;
      }
    }
}

// Sampled circles are eigenvectors: the closed form at sizes where the direct sum is out of reach.
TEST(BinomialConvolution, ScalesCircles) {
  for (const std::size_t N : {28600u, 2u * 14303u})
    for (const double n : {300.0, 20684.0, 1e7}) {
      const auto angle = [&](double i) { return 2 * std::numbers::pi * i / double(N); };
      Sequence z(N);
      for (std::size_t i = 0; i < N; ++i) z[i] = std::polar(2000.0, angle(double(i)));
      BinomialConvolution smoothed(z, n);
      const double sine = std::sin(angle(0.5));
      const auto radius = double(2000 * std::pow(std::cos(std::numbers::pi_v<long double> / N), 2.0L * n));
      const Sequence s = smoothed.difference(0), first = smoothed.difference(1),
                     second = smoothed.difference(2);
      for (std::size_t i = 0; i < N; i += 97) {
        const auto at = double(i);
        EXPECT_LT(std::abs(s[i] - std::polar(radius, angle(at))), 1e-10 * radius);
        const double chord = 2 * radius * sine;
        EXPECT_LT(std::abs(first[i] - std::polar(chord, angle(at - 0.5 + double(N) / 4))), 1e-10 * chord);
        const double bend = 4 * radius * sine * sine;
        EXPECT_LT(std::abs(second[i] + std::polar(bend, angle(at - 1))), 1e-10 * bend);
      }
    }
}

TEST(BinomialConvolution, NeedsAMaskAndPoints) {
  EXPECT_THROW(BinomialConvolution(closed_walk(8), 0), ContractViolation);
  EXPECT_THROW(BinomialConvolution(Sequence{}, 3), ContractViolation);
  EXPECT_THROW(BinomialConvolution(closed_walk(8), 1).difference(-1), ContractViolation);
}

TEST(BinomialMaskSize, IsTheDiameterInCellsOverTheCubeRootOfTheGridStep) {
  // 5 x 3 cells.
  const DigitalSet<2> set = set_where<2>({LatticePoint<2>{-9, -9}, LatticePoint<2>{9, 9}}, [](const auto& z) {
    return z[0] >= 2 && z[0] < 7 && z[1] > -2 && z[1] < 2;
  });
  const DigitalContour contour = closed_contours(connected_boundary(set).surfels).at(0);
  EXPECT_EQ(binomial_mask_size(contour, {1.0}), 5);
  EXPECT_EQ(binomial_mask_size(contour, {0.125}), 10);
  EXPECT_EQ(binomial_mask_size(contour, {0.1}), 11);  // 10.77
  EXPECT_EQ(binomial_mask_size(contour, {1000.0}), 1);
}

}  // namespace
}  // namespace gridstep
