#pragma once

#include <Eigen/Core>
#include <array>

#include "shapes/base/interval.hpp"

namespace gridstep {

/// A value with its first derivatives in d variables (forward differentiation); T is double, Interval, or
/// again a Jet1, for second derivatives.
template <class T, int d>
struct Jet1 {
  T value{};
  std::array<T, d> gradient{};

  Jet1() = default;
  explicit Jet1(double constant) : value(constant) { gradient.fill(T(0.0)); }
  static Jet1 variable(const T& x, int k) {
    Jet1 jet(0.0);
    jet.value = x;
    jet.gradient[std::size_t(k)] = T(1.0);
    return jet;
  }
  friend Jet1 operator+(Jet1 a, const Jet1& b) {
    a.value = a.value + b.value;
    for (int k = 0; k < d; ++k) a.gradient[k] = a.gradient[k] + b.gradient[k];
    return a;
  }
  friend Jet1 operator-(Jet1 a, const Jet1& b) {
    a.value = a.value - b.value;
    for (int k = 0; k < d; ++k) a.gradient[k] = a.gradient[k] - b.gradient[k];
    return a;
  }
  friend Jet1 operator*(const Jet1& a, const Jet1& b) {
    Jet1 c(0.0);
    c.value = a.value * b.value;
    for (int k = 0; k < d; ++k) c.gradient[k] = a.gradient[k] * b.value + a.value * b.gradient[k];
    return c;
  }
  friend Jet1 scaled(Jet1 a, double factor) {
    using gridstep::scaled;
    a.value = scaled(a.value, factor);
    for (T& slope : a.gradient) slope = scaled(slope, factor);
    return a;
  }
  friend Jet1 square(const Jet1& a) {
    using gridstep::square;
    Jet1 c(0.0);
    c.value = square(a.value);
    for (int k = 0; k < d; ++k) c.gradient[k] = T(2.0) * (a.value * a.gradient[k]);
    return c;
  }
};

/// A value with its gradient and Hessian in d variables.
template <int d>
struct Jet2 {
  using Vector = Eigen::Matrix<double, d, 1>;
  using Matrix = Eigen::Matrix<double, d, d>;
  double value = 0;
  Vector gradient = Vector::Zero();
  Matrix hessian = Matrix::Zero();

  Jet2() = default;
  explicit Jet2(double constant) : value(constant) {}
  Jet2(double f, const Vector& slopes, const Matrix& second) : value(f), gradient(slopes), hessian(second) {}
  static Jet2 variable(double x, int k) {
    Jet2 jet(x);
    jet.gradient[k] = 1;
    return jet;
  }
  friend Jet2 operator+(const Jet2& a, const Jet2& b) {
    return {a.value + b.value, a.gradient + b.gradient, a.hessian + b.hessian};
  }
  friend Jet2 operator-(const Jet2& a, const Jet2& b) {
    return {a.value - b.value, a.gradient - b.gradient, a.hessian - b.hessian};
  }
  friend Jet2 operator*(const Jet2& a, const Jet2& b) {
    return {a.value * b.value, a.value * b.gradient + b.value * a.gradient,
            a.value * b.hessian + b.value * a.hessian + a.gradient * b.gradient.transpose() +
                b.gradient * a.gradient.transpose()};
  }
  friend Jet2 scaled(const Jet2& a, double factor) {
    return {a.value * factor, a.gradient * factor, a.hessian * factor};
  }
  friend Jet2 square(const Jet2& a) {
    return {a.value * a.value, (2 * a.value) * a.gradient,
            (2 * a.value) * a.hessian + 2 * (a.gradient * a.gradient.transpose())};
  }
};

}  // namespace gridstep
