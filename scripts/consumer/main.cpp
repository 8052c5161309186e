// The curvature of a digital ellipse and its sup error, from the installed package alone.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <estimators/catalogue.hpp>
#include <shapes/analytic/catalogue.hpp>
#include <shapes/scene.hpp>

int main() {
  using namespace gridstep;
  const auto ellipse = make_shape<2>("ellipse");
  SceneSettings<2> settings;
  settings.h = GridStep{0.05};
  const Scene<2> scene = make_scene<2>(*ellipse, settings);
  const auto ii = find_estimator("ii").variant<2>().make(scene.set, {});
  ii->init(settings.h, EuclideanLength{5 * std::cbrt(settings.h.value)});
  const std::vector<double> estimate = ii->eval(scene.surfels)["kappa"];
  const Truth truth = truth_at_surfels<2>(*ellipse, settings, scene.surfels, {"kappa"});

  double sup = 0;
  for (std::size_t i = 0; i < estimate.size(); ++i) {
    const double error = std::abs(estimate[i] - truth.columns[0][i]);
    if (!std::isfinite(error)) return 1;
    sup = std::max(sup, error);
  }
  // The curvature goes from b/a^2 = 0.0175 to a/b^2 = 0.41: a wrong sign or unit costs more than 0.1.
  std::printf("%zu surfels, sup error %.4f\n", estimate.size(), sup);
  return estimate.size() > 1000 && sup < 0.1 ? 0 : 1;
}
