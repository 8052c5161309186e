// Compiled once for each instruction set, by Highway (https://github.com/google/highway).

#include "shapes/analytic/simd_formula.hpp"

#define HWY_TARGET_INCLUDE "shapes/analytic/simd_formula.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "shapes/base/contracts.hpp"

#ifndef GRIDSTEP_SIMD_FORMULA_SHARED  // by all instruction sets
#define GRIDSTEP_SIMD_FORMULA_SHARED
namespace gridstep {
namespace {

/// One number for each of eight places.
struct alignas(64) Eight {
  std::array<double, 8> of;
};

}  // namespace
}  // namespace gridstep
#endif

HWY_BEFORE_NAMESPACE();
namespace gridstep::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<double, 8>;
using Numbers = hn::VFromD<Tag>;

HWY_INLINE Numbers all(double value) {
  return hn::Set(Tag(), value);
}
HWY_INLINE Numbers sum(Numbers a, Numbers b) {
  return hn::Add(a, b);
}
template <class... More>
HWY_INLINE Numbers sum(Numbers a, Numbers b, More... more) {
  return sum(hn::Add(a, b), more...);
}
HWY_INLINE Numbers product(Numbers a, Numbers b) {
  return hn::Mul(a, b);
}
template <class... More>
HWY_INLINE Numbers product(Numbers a, Numbers b, More... more) {
  return product(hn::Mul(a, b), more...);
}

/// Some places of a register, as many as a vector has.
struct Part {
  Eight* rows;
  std::size_t lane;

  HWY_INLINE Numbers operator[](std::size_t row) const { return hn::Load(Tag(), rows[row].of.data() + lane); }
  HWY_INLINE void set(std::size_t row, Numbers value) const {
    hn::Store(value, Tag(), rows[row].of.data() + lane);
  }
};

/// A register holds the values at `rows` times eight points.
struct Values {
  std::size_t rows;

  void constant(Part c, double number) const {
    for (std::size_t i = 0; i < rows; ++i) c.set(i, all(number));
  }
  void add(Part a, Part b, Part c) const {
    for (std::size_t i = 0; i < rows; ++i) c.set(i, hn::Add(a[i], b[i]));
  }
  void subtract(Part a, Part b, Part c) const {
    for (std::size_t i = 0; i < rows; ++i) c.set(i, hn::Sub(a[i], b[i]));
  }
  void multiply(Part a, Part b, Part c) const {
    for (std::size_t i = 0; i < rows; ++i) c.set(i, hn::Mul(a[i], b[i]));
  }
  void scale(Part a, double factor, Part c) const {
    for (std::size_t i = 0; i < rows; ++i) c.set(i, hn::Mul(a[i], all(factor)));
  }
  void square(Part a, Part c) const {
    for (std::size_t i = 0; i < rows; ++i) c.set(i, hn::Mul(a[i], a[i]));
  }
};

/// A register holds the Taylor models over eight boxes: their terms, errors and magnitudes. The operations are those of
/// TaylorModel, in the same order.
template <int d>
struct Models {
  using Model = TaylorModel<d>;
  static constexpr std::size_t kBends = 1 + d, kTerms = kBends + Model::kPairs, kError = kTerms,
                               kMagnitude = kTerms + 1, kRows = kTerms + 2;
  static constexpr std::size_t rows = kRows;

  void constant(Part c, double number) const {
    for (std::size_t i = 0; i < kRows; ++i) c.set(i, all(0));
    c.set(0, all(number));
    c.set(kMagnitude, all(std::abs(number)));
  }
  void add(Part a, Part b, Part c) const {
    for (std::size_t i = 0; i < kTerms; ++i) c.set(i, hn::Add(a[i], b[i]));
    set_error(c,
              sum(a[kError], b[kError], product(all(Model::kRounding), sum(a[kMagnitude], b[kMagnitude]))));
  }
  void subtract(Part a, Part b, Part c) const {
    for (std::size_t i = 0; i < kTerms; ++i) c.set(i, hn::Sub(a[i], b[i]));
    set_error(c,
              sum(a[kError], b[kError], product(all(Model::kRounding), sum(a[kMagnitude], b[kMagnitude]))));
  }
  void multiply(Part a, Part b, Part c) const {
    const Numbers a0 = a[0], b0 = b[0];
    c.set(0, hn::Mul(a0, b0));
    for (std::size_t k = 1; k <= d; ++k) c.set(k, sum(product(a0, b[k]), product(b0, a[k])));
    for (std::size_t j = 1, pair = kBends; j <= d; ++j)
      for (std::size_t k = j; k <= d; ++k, ++pair) {
        const Numbers bend = sum(product(a0, b[pair]), product(b0, a[pair]), product(a[j], b[k]));
        c.set(pair, j == k ? bend : sum(bend, product(a[k], b[j])));
      }
    const Numbers bend_a = bending(a), bend_b = bending(b);
    set_error(c, sum(product(sloping(a), bend_b), product(bend_a, sum(sloping(b), bend_b)),
                     product(a[kError], b[kMagnitude]), product(b[kError], a[kMagnitude]),
                     product(all(Model::kRounding), a[kMagnitude], b[kMagnitude]), all(Model::kUnderflow)));
  }
  void scale(Part a, double factor, Part c) const {
    for (std::size_t i = 0; i < kTerms; ++i) c.set(i, hn::Mul(a[i], all(factor)));
    const Numbers error = sum(a[kError], product(all(Model::kRounding), a[kMagnitude]));
    set_error(c, sum(product(all(std::abs(factor)), error), all(Model::kUnderflow)));
  }
  void square(Part a, Part c) const {
    const Numbers two = all(2), a0 = a[0], twice = product(two, a0);
    c.set(0, hn::Mul(a0, a0));
    for (std::size_t k = 1; k <= d; ++k) c.set(k, product(twice, a[k]));
    for (std::size_t j = 1, pair = kBends; j <= d; ++j)
      for (std::size_t k = j; k <= d; ++k, ++pair)
        c.set(pair, sum(product(twice, a[pair]), j == k ? product(a[j], a[k]) : product(two, a[j], a[k])));
    const Numbers bend = bending(a);
    set_error(c,
              sum(product(bend, sum(product(two, sloping(a)), bend)), product(two, a[kError], a[kMagnitude]),
                  product(all(Model::kRounding), a[kMagnitude], a[kMagnitude]), all(Model::kUnderflow)));
  }

 private:
  /// Of the absolute values of some rows.
  static HWY_INLINE Numbers sum_of(Part a, std::size_t begin, std::size_t end) {
    Numbers result = hn::Abs(a[begin]);
    for (std::size_t i = begin + 1; i < end; ++i) result = hn::Add(result, hn::Abs(a[i]));
    return result;
  }
  static HWY_INLINE Numbers sloping(Part a) { return sum_of(a, 1, kBends); }
  static HWY_INLINE Numbers bending(Part a) { return sum_of(a, kBends, kTerms); }
  static HWY_INLINE void set_error(Part c, Numbers error) {
    c.set(kError, error);
    c.set(kMagnitude, hn::Add(sum_of(c, 0, kTerms), error));
  }
};

/// Carries out all operations: the i-th writes the i-th register.
template <class Held>
void run(std::span<const Formula::Operation> operations, Held on, const Eight* variables, Eight* registers) {
  const std::size_t rows = on.rows;
  for (std::size_t i = 0; i < operations.size(); ++i) {
    const Formula::Operation& o = operations[i];
    if (o.kind == Formula::Kind::variable) {
      std::copy_n(variables + std::size_t(o.left) * rows, rows, registers + i * rows);
      continue;
    }
    for (std::size_t lane = 0; lane < 8; lane += hn::Lanes(Tag())) {
      const Part a{registers + std::size_t(o.left) * rows, lane},
          b{registers + std::size_t(o.right) * rows, lane}, c{registers + i * rows, lane};
      switch (o.kind) {
        case Formula::Kind::constant:
          on.constant(c, o.number);
          break;
        case Formula::Kind::sum:
          on.add(a, b, c);
          break;
        case Formula::Kind::difference:
          on.subtract(a, b, c);
          break;
        case Formula::Kind::product:
          on.multiply(a, b, c);
          break;
        case Formula::Kind::scaled:
          on.scale(a, o.number, c);
          break;
        case Formula::Kind::square:
          on.square(a, c);
          break;
        case Formula::Kind::variable:
          break;
      }
    }
  }
}

/// Returns where the last value is at most 0.
std::uint64_t run_values(std::span<const Formula::Operation> operations, std::size_t rows,
                         const Eight* variables, Eight* registers) {
  run(operations, Values{rows}, variables, registers);
  Eight* const last = registers + (operations.size() - 1) * rows;
  std::uint64_t result = 0;
  for (std::size_t i = 0; i < 8 * rows; i += hn::Lanes(Tag())) {
    std::array<std::uint8_t, 8> bits{};
    hn::StoreMaskBits(Tag(), hn::Le(Part{last, i % 8}[i / 8], all(0)), bits.data());
    result |= std::uint64_t(bits[0]) << i;
  }
  return result;
}
void run_models_2d(std::span<const Formula::Operation> operations, const Eight* variables, Eight* registers) {
  run(operations, Models<2>(), variables, registers);
}
void run_models_3d(std::span<const Formula::Operation> operations, const Eight* variables, Eight* registers) {
  run(operations, Models<3>(), variables, registers);
}

}  // namespace
}  // namespace gridstep::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gridstep {

HWY_EXPORT(run_values);
HWY_EXPORT(run_models_2d);
HWY_EXPORT(run_models_3d);

namespace {

/// For one call: other threads have their own.
std::vector<Eight>& registers(std::size_t rows) {
  thread_local std::vector<Eight> result;
  if (result.size() < rows) result.resize(rows);
  return result;
}

}  // namespace

template <int d>
std::uint64_t at_most_zero(const Formula& formula, std::span<const RealPoint<d>> points) {
  expects(points.size() <= 64, "at most 64 points");
  constexpr std::size_t kMostRows = 4;  // so that the registers of most formulas stay near the processor
  const auto operations = formula.operations();
  std::uint64_t result = 0;
  for (std::size_t first = 0; first < points.size(); first += 8 * kMostRows) {
    const std::size_t count = std::min(8 * kMostRows, points.size() - first), rows = (count + 7) / 8;
    std::vector<Eight>& all = registers((d + operations.size()) * rows);
    for (std::size_t i = 0; i < 8 * rows; ++i) {
      const RealPoint<d>& point = points[first + std::min(i, count - 1)];
      for (std::size_t k = 0; k < d; ++k) all[k * rows + i / 8].of[i % 8] = point[Eigen::Index(k)];
    }
    result |= HWY_DYNAMIC_DISPATCH(run_values)(operations, rows, all.data(), all.data() + d * rows) << first;
  }
  return points.size() < 64 ? result & ((std::uint64_t{1} << points.size()) - 1) : result;
}

template <int d>
void models_over(const Formula& formula, std::span<const RealBox<d>> boxes,
                 std::span<TaylorModel<d>> models) {
  constexpr auto kTerms = std::size_t(TaylorModel<d>::Terms::SizeAtCompileTime), kRows = kTerms + 2;
  const auto operations = formula.operations();
  for (std::size_t first = 0; first < boxes.size(); first += 8) {
    const std::size_t count = std::min<std::size_t>(8, boxes.size() - first);
    std::array<Eight, d * kRows> variables{};
    for (std::size_t i = 0; i < 8; ++i) {
      const auto of_box = TaylorModel<d>::variables(boxes[first + std::min(i, count - 1)]);
      for (std::size_t k = 0; k < d; ++k) {
        variables[k * kRows].of[i] = of_box[k].terms[0];
        variables[k * kRows + 1 + k].of[i] = of_box[k].terms[Eigen::Index(1 + k)];
        variables[k * kRows + kTerms + 1].of[i] = of_box[k].magnitude;
      }
    }
    std::vector<Eight>& all = registers(operations.size() * kRows);
    if constexpr (d == 2)
      HWY_DYNAMIC_DISPATCH(run_models_2d)(operations, variables.data(), all.data());
    else
      HWY_DYNAMIC_DISPATCH(run_models_3d)(operations, variables.data(), all.data());
    const Eight* const last = all.data() + (operations.size() - 1) * kRows;
    for (std::size_t i = 0; i < count; ++i) {
      TaylorModel<d>& model = models[first + i];
      for (std::size_t row = 0; row < kTerms; ++row) model.terms[Eigen::Index(row)] = last[row].of[i];
      model.error = last[kTerms].of[i];
      model.magnitude = last[kTerms + 1].of[i];
    }
  }
}

template std::uint64_t at_most_zero(const Formula&, std::span<const RealPoint<2>>);
template std::uint64_t at_most_zero(const Formula&, std::span<const RealPoint<3>>);
template void models_over(const Formula&, std::span<const RealBox<2>>, std::span<TaylorModel<2>>);
template void models_over(const Formula&, std::span<const RealBox<3>>, std::span<TaylorModel<3>>);

}  // namespace gridstep
#endif
