#pragma once

#include <cstdint>

#include "estimators/integral_invariant/radial/radial_sum.hpp"
#include "estimators/integral_invariant/radial/radial_weights.hpp"

namespace gridstep {

/// Weights of one point, and sums of them along x, for trace and edge alone. Weights are at most 2^20, and lines have a few
/// hundred points.
struct CurvatureFlux {
  std::int32_t trace = 0, edge = 0;

  CurvatureFlux& operator+=(const CurvatureFlux& other) {
    trace += other.trace;
    edge += other.edge;
    return *this;
  }
  /// Of a point whose coordinate along x from the centre, in half cells, is x.
  static CurvatureFlux of(const RadialTriple& weight, std::int64_t /*x*/) {
    return {std::int32_t(weight.trace), std::int32_t(weight.edge)};
  }

  /// Of many lines.
  struct Sum {
    std::int64_t trace = 0, edge = 0;

    Sum& operator+=(const Sum& other) {
      trace += other.trace;
      edge += other.edge;
      return *this;
    }
    Sum& operator-=(const Sum& other) {
      trace -= other.trace;
      edge -= other.edge;
      return *this;
    }
    explicit operator RadialSum() const { return {trace, edge, {}, {}}; }
  };

  /// Sums over some lines of one z.
  class Slice {
   public:
    template <int sign>
    void add(const CurvatureFlux& line, std::int64_t /*y*/) {
      sum_.trace += sign * std::int64_t{line.trace};
      sum_.edge += sign * std::int64_t{line.edge};
    }
    Sum at(std::int64_t /*z*/) const { return sum_; }

   private:
    Sum sum_;
  };
};

/// The same for all that a RadialSum has. A cache line.
struct alignas(64) WholeFlux {
  using Sum = RadialSum;

  std::int64_t trace = 0, edge = 0, edge_x = 0, tensor = 0, tensor_x = 0, tensor_xx = 0;

  WholeFlux& operator+=(const WholeFlux& other) {
    trace += other.trace;
    edge += other.edge;
    edge_x += other.edge_x;
    tensor += other.tensor;
    tensor_x += other.tensor_x;
    tensor_xx += other.tensor_xx;
    return *this;
  }
  static WholeFlux of(const RadialTriple& weight, std::int64_t x) {
    return {weight.trace,  weight.edge,       weight.edge * x,
            weight.tensor, weight.tensor * x, weight.tensor * x * x};
  }

  class Slice {
   public:
    template <int sign>
    void add(const WholeFlux& line, std::int64_t y) {
      trace_ += sign * line.trace;
      edge_ += sign * line.edge;
      edge_x_ += sign * line.edge_x;
      edge_y_ += sign * line.edge * y;
      tensor_ += sign * line.tensor;
      tensor_x_ += sign * line.tensor_x;
      tensor_xx_ += sign * line.tensor_xx;
      tensor_xy_ += sign * line.tensor_x * y;
      const std::int64_t tensor_y = sign * line.tensor * y;
      tensor_y_ += tensor_y;
      tensor_yy_ += tensor_y * y;
    }
    RadialSum at(std::int64_t z) const {
      return {trace_,
              edge_,
              {edge_x_, edge_y_, edge_ * z},
              {tensor_xx_, tensor_xy_, tensor_x_ * z, tensor_yy_, tensor_y_ * z, tensor_ * z * z}};
    }

   private:
    std::int64_t trace_ = 0, edge_ = 0, edge_x_ = 0, edge_y_ = 0, tensor_ = 0, tensor_x_ = 0, tensor_y_ = 0,
                 tensor_xx_ = 0, tensor_xy_ = 0, tensor_yy_ = 0;
  };
};

}  // namespace gridstep
