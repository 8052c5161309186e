#pragma once

#include <span>
#include <string>
#include <vector>

#include "shapes/base/interval.hpp"

namespace gridstep {

/// A polynomial in x, y, z as it was written: a list of operations on registers, kept in the order of the
/// text, so that doubles, intervals and derivatives are all evaluated alike. What the text repeats is done once.
///
///   sum = product {("+" | "-") product};  product = power {("*" | "/") power};  power = ["-" | "+"] atom
///   ["^" integer] atom = number | "x" | "y" | "z" | "(" sum ")";  a divisor must be a number other than 0
class Formula {
 public:
  /// @throws InputError naming the formula and the character at which it does not parse.
  explicit Formula(const std::string& text);

  const std::string& text() const { return text_; }
  /// Number of variables needed: 3 where z occurs, 2 where y does and z does not, and so on.
  int variables() const { return variables_; }
  int degree() const { return degree_; }

  /// Its value where variables[k] is the k-th coordinate. Scalar: double, Interval, a jet; has +, -, *, square() and
  /// scaled(), and is made from a double.
  template <class Scalar>
  Scalar operator()(std::span<const Scalar> variables) const {
    thread_local std::vector<Scalar> r;
    r.resize(operations_.size());
    for (std::size_t i = 0; i < operations_.size(); ++i) {
      const Operation& o = operations_[i];
      switch (o.kind) {
        case Kind::constant:
          r[i] = Scalar(o.number);
          break;
        case Kind::variable:
          r[i] = variables[std::size_t(o.left)];
          break;
        case Kind::sum:
          r[i] = r[std::size_t(o.left)] + r[std::size_t(o.right)];
          break;
        case Kind::difference:
          r[i] = r[std::size_t(o.left)] - r[std::size_t(o.right)];
          break;
        case Kind::product:
          r[i] = r[std::size_t(o.left)] * r[std::size_t(o.right)];
          break;
        case Kind::scaled:
          r[i] = scaled(r[std::size_t(o.left)], o.number);
          break;
        case Kind::square:
          r[i] = square(r[std::size_t(o.left)]);
          break;
      }
    }
    return r.back();
  }

  enum class Kind { constant, variable, sum, difference, product, scaled, square };
  struct Operation {
    Kind kind;
    int left = 0, right = 0;  ///< registers, or the number of the variable
    double number = 0;
    friend bool operator==(const Operation&, const Operation&) = default;
  };
  /// What to carry out, one after the other: operation i writes register i; the last one is the value.
  std::span<const Operation> operations() const { return operations_; }

  /// A bound on the sum of the absolute values of all terms where |variables[k]| <= magnitudes[k]: rounding
  /// errors are relative to it.
  double magnitude(std::span<const double> magnitudes) const;

 private:
  class Parser;

  /// Drops what the value in a register does not need, so that this is the last one.
  void keep_operands_of(int value);

  std::string text_;
  std::vector<Operation> operations_;
  int variables_ = 0, degree_ = 0;
};

}  // namespace gridstep
