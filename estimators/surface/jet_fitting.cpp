#include "estimators/catalogue.hpp"
#include "estimators/integral_invariant/curvature.hpp"

#ifdef GRIDSTEP_WITH_CGAL
#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Simple_cartesian.h>

#include <array>
#include <memory>

#include "estimators/integral_invariant/kernel.hpp"
#include "estimators/surface/ball_walk.hpp"
#include "shapes/base/parallel.hpp"
#endif

namespace gridstep {

namespace {

#ifdef GRIDSTEP_WITH_CGAL

/// All curvatures of the polynomial of degree 2 that fits, by least squares, the centres of the faces that the ball of
/// radius R around a surfel reaches, as a height over their principal plane [Cazals & Pouget, CAGD 22, 2005], by CGAL.
///   Degree 2: digital surfaces are off by up to a cell, and each further degree passes more of that on.
///   Units  1/length (gaussian: 1/length^2), positive where the set is convex. The normal is on the side that the
///          trivial normals of those faces sum up to.
///   Bound  none for digital surfaces; for points on a surface, curvatures are off by O(R) [ibid.].
///   Cost   O((R/h)^2).
/// Fewer than six points, of a set of hardly more than one voxel, make no polynomial: curvature 0, the trivial normal.
class JetFitting final : public Estimator<3> {
 public:
  explicit JetFitting(const DigitalSet<3>& set) : set_(set) {}

  void init(GridStep h, EuclideanLength R) override {
    radius_ = {0};
    const DigitalLength radius = to_digital(R, h);
    (void)squared_diameter(radius);
    radius_ = radius;
    h_ = h;
  }

  Estimates eval(std::span<const Surfel<3>> surfels) override {
    expects(radius_.value > 0, "init() before eval()");
    const QuadSurface surface(set_, surfels, {radius_.value + 2});
    PerWorker<BallWalk> walks{BallWalk(surface)};
    Estimates result =
        Estimates::zeros({kSurfaceQuantities.begin(), kSurfaceQuantities.end()}, surfels.size());
    parallel_chunks(surfels.size(), 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i != end; ++i)
        result.set_row(i, evaluate(surface, surfels[i], walks.local()));
    });
    work_.evaluations = std::int64_t(surfels.size());
    return result;
  }

  Estimates raw() const override { return {}; }
  EstimatorWork work() const override { return work_; }

 private:
  using Kernel = CGAL::Simple_cartesian<double>;
  static constexpr std::size_t kDegree = 2, kCoefficients = 6;

  std::array<double, kSurfaceQuantities.size()> evaluate(const QuadSurface& surface, const Surfel<3>& surfel,
                                                         BallWalk& walk) const {
    std::vector<Kernel::Point_3> points;  // in cells, the centre of the surfel first
    Eigen::Vector3d outwards = Eigen::Vector3d::Zero();
    const LatticePoint<3> centre = surfel.cell().coordinates;
    walk(surface.number_of(surfel), 2 * radius_.value, [&](std::uint32_t face) {
      const Surfel<3>& visited = surface.faces()[face];
      const LatticePoint<3> offset = visited.cell().coordinates - centre;
      points.emplace_back(0.5 * offset[0], 0.5 * offset[1], 0.5 * offset[2]);
      outwards += visited.normal();
    });
    if (points.size() < kCoefficients) {
      const RealPoint<3> n = surfel.normal(), d1 = n.unitOrthogonal(), d2 = n.cross(d1);
      return {0, 0, 0, 0, n[0], n[1], n[2], d1[0], d1[1], d1[2], d2[0], d2[1], d2[2]};
    }
    auto monge = CGAL::Monge_via_jet_fitting<Kernel>()(points.begin(), points.end(), kDegree, kDegree);
    // Heights are along the normal, and convex surfaces bend away from the outward one.
    monge.comply_wrt_given_normal(Kernel::Vector_3(-outwards[0], -outwards[1], -outwards[2]));
    const double k1 = monge.principal_curvatures(0) / h_.value, k2 = monge.principal_curvatures(1) / h_.value;
    const Kernel::Vector_3 n = -monge.normal_direction(), d1 = monge.maximal_principal_direction(),
                           d2 = monge.minimal_principal_direction();
    return {(k1 + k2) / 2, k1 * k2, k1,     k2,     n.x(),  n.y(), n.z(),
            d1.x(),        d1.y(),  d1.z(), d2.x(), d2.y(), d2.z()};
  }

  const DigitalSet<3>& set_;
  GridStep h_{};
  DigitalLength radius_{};
  EstimatorWork work_;
};

#endif

}  // namespace

EstimatorEntry describe_jet_fitting() {
  EstimatorEntry entry;
  entry.name = "jet-fitting";
  entry.summary = "all curvatures and the normal of a polynomial fitted to surfel centres in a ball (CGAL)";
  EstimatorEntry::Variant<3>& variant = entry.in_3d.emplace();
  for (const std::string quantity : kSurfaceQuantities)
    variant.quantities.push_back({quantity, std::nullopt});
  variant.evaluations = {};
  variant.centres = {};
#ifdef GRIDSTEP_WITH_CGAL
  variant.make = [](const DigitalSet<3>& set, const EstimatorOptions&) {
    return std::make_unique<JetFitting>(set);
  };
#else
  entry.not_built = "configure with -D GRIDSTEP_WITH_CGAL=ON (CGAL is under the GPL)";
#endif
  return entry;
}

}  // namespace gridstep
