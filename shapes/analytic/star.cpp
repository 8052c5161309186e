#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "shapes/analytic/polynomial_entry.hpp"
#include "shapes/base/random.hpp"

namespace gridstep {

namespace {

/// x^i y^j z^k, and the greatest value of its modulus on the unit sphere: sqrt(i^i j^j k^k / n^n), n = i + j + k.
struct Monomial {
  std::string text;
  double greatest;
};

std::vector<Monomial> monomials(int degree) {
  const auto power = [](int n) {
    double result = 1;
    for (int i = 0; i < n; ++i) result *= n;
    return result;
  };
  std::vector<Monomial> result;
  for (int i = degree; i >= 0; --i)
    for (int j = degree - i; j >= 0; --j) {
      const int k = degree - i - j;
      result.push_back({fmt::format("x^{}*y^{}*z^{}", i, j, k),
                        std::sqrt(power(i) * power(j) * power(k) / power(degree))});
    }
  return result;
}

/// A random form of a degree, of modulus at most `bound` on the unit sphere, as text: " + c * x^i*y^j*z^k ...".
std::string random_form(int degree, double bound, RandomStream& random) {
  const std::vector<Monomial> all = monomials(degree);
  std::vector<double> share;
  double sum = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    share.push_back(2 * random.uniform() - 1);
    sum += std::abs(share.back());
  }
  std::string text;
  for (std::size_t i = 0; i < all.size(); ++i)
    text += fmt::format("{}{}*{}", share[i] < 0 ? "-" : "+",
                        std::abs(share[i]) / sum * bound / all[i].greatest, all[i].text);
  return text;
}

/// With lengths in units of the radius, f(t u) = t^4 (1/2 + q(u)) + t^3 p(u) + t^2/2 - 1 on the ray through u. It grows
/// with t, so that the ray leaves the shape once, where the discriminant of its derivative's other factor is negative:
/// 9 p^2 < 16 (1/2 + q), and |p| <= 0.6, |q| <= 0.25 see to that.
std::string formula(double roughness, std::uint64_t seed) {
  RandomStream random{seed};
  const std::string cubic = random_form(3, 0.6 * roughness, random);
  const std::string quartic = random_form(4, 0.25 * roughness, random);
  return "0.5*(x^2+y^2+z^2)^2+0.5*(x^2+y^2+z^2)" + cubic + quartic + "-1";
}

}  // namespace

ShapeEntry describe_star() {
  return {"star",
          "t^4 + t^2 + 2 roughness (p(u) t^3 + q(u) t^4) <= 2, t = |x| / radius, u = x / |x|, with random "
          "forms p and q "
          "of degree 3 and 4: every ray from the centre leaves it once",
          {Parameter::count("seed", 1, 0, "of the forms"),
           Parameter::length("radius", 9, "where roughness is 0, that of the sphere"),
           {"roughness", 0.9, "1", "|p| <= 0.6, |q| <= 0.25, times this", 0.0, 1.0}},
          ShapeFactory<3>([](const ParameterValues& p, const RealPoint<3>& centre) {
            return enlarged_polynomial(formula(p["roughness"], std::uint64_t(p["seed"])), p["radius"],
                                       centre);
          })};
}

}  // namespace gridstep
