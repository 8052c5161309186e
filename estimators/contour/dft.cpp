#include "estimators/contour/dft.hpp"

#include <algorithm>
#include <cstdint>
#include <numbers>

#include "shapes/base/contracts.hpp"

namespace gridstep {

namespace {

/// The smallest number from `least` on with no factor above 5: what the library transforms fast.
std::size_t smooth_length(std::size_t least) {
  const auto is_smooth = [](std::size_t n) {
    for (const std::size_t p : {2, 3, 5})
      while (n % p == 0) n /= p;
    return n == 1;
  };
  while (!is_smooth(least)) ++least;
  return least;
}

}  // namespace

DiscreteFourierTransform::DiscreteFourierTransform(std::size_t length) {
  expects(0 < length && length < (std::size_t(1) << 29), "a length in (0, 2^29)");
  fft_.SetFlag(Eigen::FFT<double>::Unscaled);
  const std::size_t M = smooth_length(2 * length);
  chirp_.resize(length);
  std::vector<std::complex<double>> conjugate(M);
  for (std::size_t j = 0; j < length; ++j) {
    // Reduced as an integer: the angle of j^2 itself would lose digits.
    const std::uint64_t square = std::uint64_t(j) * j % (2 * length);
    chirp_[j] = std::polar(1.0, -std::numbers::pi * double(square) / double(length));
    conjugate[j] = conjugate[(M - j) % M] = std::conj(chirp_[j]);
  }
  spectrum_.resize(M);
  fft_.fwd(spectrum_.data(), conjugate.data(), Eigen::Index(M));
  for (auto& value : spectrum_) value /= double(M);
}

std::vector<std::complex<double>> DiscreteFourierTransform::forward(std::span<const std::complex<double>> x) {
  expects(x.size() == length(), "as many values as the transform is long");
  const std::size_t N = length(), M = spectrum_.size();
  std::vector<std::complex<double>> padded(M), transformed(M);
  for (std::size_t j = 0; j < N; ++j) padded[j] = chirp_[j] * x[j];
  fft_.fwd(transformed.data(), padded.data(), Eigen::Index(M));
  for (std::size_t k = 0; k < M; ++k) transformed[k] *= spectrum_[k];
  fft_.inv(padded.data(), transformed.data(), Eigen::Index(M));
  padded.resize(N);
  for (std::size_t k = 0; k < N; ++k) padded[k] *= chirp_[k];
  return padded;
}

std::vector<std::complex<double>> DiscreteFourierTransform::inverse(std::span<const std::complex<double>> X) {
  std::vector<std::complex<double>> x = forward(X);
  std::reverse(x.begin() + 1, x.end());
  for (auto& value : x) value /= double(length());
  return x;
}

}  // namespace gridstep
