#include "estimators/integral_invariant/radial/radial_kernel.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "shapes/base/contracts.hpp"

namespace gridstep {

double RadialKernel::operator()(double t) const {
  double polynomial = 0;
  for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c) polynomial = polynomial * t + *c;
  return std::pow(1 - t, edge_power) * polynomial;
}

double RadialKernel::integral(double a) const {
  double sum = 0;
  for (std::size_t i = 0; i < coefficients.size(); ++i)
    sum += coefficients[i] * std::beta(a + double(i) + 1, edge_power + 1.0);
  return sum;
}

namespace {

/// Half the measure of the unit sphere in dimension m; |x|^(n + m - 1) d|x| is t^((n + m) / 2 - 1) dt / 2.
double half_sphere(int dimension) {
  expects(1 <= dimension && dimension <= 3, "a dimension from 1 to 3");
  static constexpr double kHalfSphere[] = {1, std::numbers::pi, 2 * std::numbers::pi};
  return kHalfSphere[dimension - 1];
}

}  // namespace

double RadialKernel::moment(int dimension, int order) const {
  expects(order >= 0, "an order of at least 0");
  return half_sphere(dimension) * integral((order + dimension) / 2.0 - 1);
}

double RadialKernel::slope_integral(int dimension) const {
  double sum = 0;
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    const double a = double(i) + dimension / 2.0;
    if (i > 0) sum += coefficients[i] * double(i) * std::beta(a - 1, edge_power + 1.0);
    if (edge_power > 0) sum -= coefficients[i] * edge_power * std::beta(a, double(edge_power));
  }
  return half_sphere(dimension) * sum;
}

RadialKernel vanishing_kernel(int d, int edge_power, std::span<const int> orders) {
  if (d != 2 && d != 3) throw InputError(fmt::format("kernel in dimension {}: must be 2 or 3", d));
  if (edge_power < 0 || edge_power > 8)
    throw InputError(fmt::format("kernel with edge power {}: must be from 0 to 8", edge_power));
  if (orders.size() > 6)
    throw InputError(fmt::format("kernel with {} vanishing moments: must be at most 6", orders.size()));
  for (std::size_t i = 0; i < orders.size(); ++i)
    if (orders[i] < 0 || orders[i] % 2 != 0 ||
        std::find(orders.begin(), orders.begin() + long(i), orders[i]) != orders.begin() + long(i))
      throw InputError(
          fmt::format("vanishing moment of order {}: orders are even, at least 0 and distinct", orders[i]));

  // One equation for each order in c_1, ..., c_n: the moments of the single terms (1 - t)^p t^i.
  const auto n = Eigen::Index(orders.size());
  Eigen::MatrixXd terms(n, n);
  Eigen::VectorXd constant(n);
  for (Eigen::Index row = 0; row < n; ++row)
    for (Eigen::Index i = 0; i <= n; ++i) {
      RadialKernel term{edge_power, std::vector<double>(std::size_t(i) + 1)};
      term.coefficients.back() = 1;
      const double moment = term.moment(d - 1, orders[std::size_t(row)]);
      if (i == 0)
        constant[row] = -moment;
      else
        terms(row, i - 1) = moment;
    }
  const Eigen::VectorXd solution =
      n == 0 ? Eigen::VectorXd() : Eigen::VectorXd(terms.fullPivLu().solve(constant));
  RadialKernel kernel{edge_power, {1}};
  kernel.coefficients.insert(kernel.coefficients.end(), solution.begin(), solution.end());
  return kernel;
}

}  // namespace gridstep
