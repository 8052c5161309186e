#include "estimators/contour/dft.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "shapes/base/contracts.hpp"
#include "shapes/base/random.hpp"

namespace gridstep {
namespace {

using Sequence = std::vector<std::complex<double>>;

Sequence random_sequence(std::size_t length) {
  RandomStream random({length});
  Sequence z(length);
  for (auto& value : z) value = {random.uniform() - 0.5, random.uniform() - 0.5};
  return z;
}

/// One, small, smooth, prime, twice a prime.
const std::size_t kLengths[] = {1, 2, 3, 4, 60, 128, 331, 2 * 331};

TEST(DiscreteFourierTransform, IsTheDirectSum) {
  for (const std::size_t N : kLengths) {
    const Sequence x = random_sequence(N);
    DiscreteFourierTransform transform(N);
    const Sequence X = transform.forward(x);
    ASSERT_EQ(X.size(), N);
    for (std::size_t k = 0; k < N; ++k) {
      std::complex<double> sum = 0;
      for (std::size_t j = 0; j < N; ++j)
        sum += x[j] * std::polar(1.0, -2 * std::numbers::pi * double(j * k % N) / double(N));
      EXPECT_LT(std::abs(X[k] - sum), 1e-13 * double(N)) << N;
    }
  }
}

TEST(DiscreteFourierTransform, IsUndoneByItsInverse) {
  for (const std::size_t N : kLengths) {
    const Sequence x = random_sequence(N);
    DiscreteFourierTransform transform(N);
    const Sequence y = transform.inverse(transform.forward(x));
    for (std::size_t j = 0; j < N; ++j) EXPECT_LT(std::abs(y[j] - x[j]), 1e-14) << N;
  }
}

TEST(DiscreteFourierTransform, ChecksLengths) {
  EXPECT_THROW(DiscreteFourierTransform(0), ContractViolation);
  DiscreteFourierTransform transform(5);
  EXPECT_THROW(transform.forward(random_sequence(4)), ContractViolation);
}

}  // namespace
}  // namespace gridstep
