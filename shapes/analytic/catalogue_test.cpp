#include "shapes/analytic/catalogue.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "shapes/analytic/testing_catalogue.hpp"
#include "shapes/scene.hpp"

namespace gridstep {
namespace {

using std::numbers::pi;

/// The contracts of Shape, over every line of the catalogue with its default parameters.
class CatalogueContract : public testing::TestWithParam<std::string> {
 protected:
  /// Calls check(shape) with the shape in its own dimension.
  template <class Check>
  static void with_shape(Check check) {
    std::visit([&](const auto& shape) { check(*shape); }, make_shape(ShapeSpec{GetParam(), {}}));
  }
};

INSTANTIATE_TEST_SUITE_P(Shapes, CatalogueContract, testing::ValuesIn(all_names()), test_name);

template <int d>
RealPoint<d> random_direction(RandomStream& random) {
  return random_rotation<d>(random).col(0);
}

template <int d>
RealBox<d> widened(const RealBox<d>& box, double factor) {
  const RealPoint<d> reach = box.sizes() * (factor / 2);
  return {box.center() - reach, box.center() + reach};
}

/// The part of the bounds, and of what is around them, that is worth sampling.
template <int d>
RealBox<d> sampled_box(const Region<d>& region, double size) {
  const RealBox<d> bounds = widened(region.bounds(), 1.3);
  const RealPoint<d> reach = RealPoint<d>::Constant(1.5 * size);
  return bounds.intersection(RealBox<d>(bounds.center() - reach, bounds.center() + reach));
}

/// Between a point inside and a point outside, to the last bit but a few.
template <int d>
RealPoint<d> random_boundary_point(const Region<d>& region, const RealBox<d>& box, RandomStream& random) {
  RealPoint<d> in = random_point(box, random), out = random_point(box, random);
  for (int i = 0; i < 100000 && !region.contains(in); ++i) in = random_point(box, random);
  for (int i = 0; i < 100000 && region.contains(out); ++i) out = random_point(box, random);
  for (int halving = 0; halving < 48; ++halving) {
    const RealPoint<d> middle = (in + out) / 2;
    (region.contains(middle) ? in : out) = middle;
  }
  return in;
}

/// At most `most` surfels, evenly taken: enough of them to see every part of the boundary.
template <int d>
std::vector<Surfel<d>> thinned(const std::vector<Surfel<d>>& surfels, std::size_t most) {
  const std::size_t stride = 1 + surfels.size() / most;
  std::vector<Surfel<d>> result;
  for (std::size_t i = 0; i < surfels.size(); i += stride) result.push_back(surfels[i]);
  return result;
}

TEST_P(CatalogueContract, PointsInsideLieInBounds) {
  with_shape([]<int d>(const Shape<d>& shape) {
    RandomStream random{1};
    const RealBox<d> bounds = shape.bounds(), around = sampled_box(shape, feature(shape));
    // Rounding may let a point on the boundary look inside.
    const double slack = 1e-7 * shape.size();
    const RealBox<d> allowed(bounds.min().array() - slack, bounds.max().array() + slack);
    int inside = 0;
    for (int i = 0; i < 50000; ++i) {
      const RealPoint<d> p = random_point(around, random);
      if (!shape.contains(p)) continue;
      ++inside;
      EXPECT_TRUE(allowed.contains(p)) << p.transpose();
    }
    EXPECT_GT(inside, 500) << "the bounds are far too large, or the shape is empty";
  });
}

TEST_P(CatalogueContract, ManyPointsAreTestedAsOneByOne) {
  with_shape([]<int d>(const Shape<d>& shape) {
    RandomStream random{2};
    for (std::size_t count = 1; count <= 64; ++count) {
      std::vector<RealPoint<d>> points;
      for (std::size_t i = 0; i < count; ++i) points.push_back(random_point(shape.bounds(), random));
      const std::uint64_t bits = shape.inside(points);
      for (std::size_t i = 0; i < 64; ++i)
        EXPECT_EQ((bits >> i) & 1, i < count && shape.contains(points[i])) << i << " of " << count;
    }
  });
}

/// Boxes of all sizes, half of them at the boundary, where a bound that is too eager shows first.
template <int d>
void check_side(const Region<d>& region, double size, std::uint64_t seed) {
  RandomStream random{seed};
  const RealBox<d> around = sampled_box(region, size);
  int inside = 0, outside = 0, far = 0, far_decided = 0;
  for (int i = 0; i < 1500; ++i) {
    const bool at_boundary = i % 2 == 0;
    RealPoint<d> centre =
        at_boundary ? random_boundary_point(region, around, random) : random_point(around, random);
    const double scale = size * std::exp2(-(at_boundary ? 44 : 12) * random.uniform());
    if (at_boundary) centre += 1.5 * scale * random_direction<d>(random);
    RealPoint<d> reach;
    for (int k = 0; k < d; ++k) reach[k] = scale * random.uniform();
    const RealBox<d> box(centre - reach, centre + reach);
    const Side side = region.side(box);
    if (!at_boundary && scale < size / 256) {
      ++far;
      far_decided += side != Side::crossing;
    }
    if (side == Side::crossing) continue;
    ++(side == Side::inside ? inside : outside);
    std::vector<RealPoint<d>> points;
    for (int c = 0; c < (1 << d); ++c) points.push_back(box.corner(typename RealBox<d>::CornerType(c)));
    while (points.size() < 64)
      points.push_back(random_point(box, random).cwiseMax(box.min()).cwiseMin(box.max()));
    EXPECT_EQ(region.inside(points), side == Side::inside ? ~std::uint64_t{0} : 0)
        << "box " << box.min().transpose() << " .. " << box.max().transpose();
  }
  EXPECT_GT(inside, 50) << "side() never says inside: nothing was tested";
  EXPECT_GT(outside, 50);
  EXPECT_GT(far_decided, 0.6 * far) << "side() is of no use to digitization";
}

TEST_P(CatalogueContract, SideNeverContradictsInside) {
  with_shape([]<int d>(const Shape<d>& shape) { check_side<d>(shape, feature(shape), 3); });
}

TEST_P(CatalogueContract, SideOfAPlacedShapeNeverContradictsInside) {
  with_shape([]<int d>(const Shape<d>& shape) {
    const auto settings = random_settings<d>(feature(shape) / 10, 4);
    check_side<d>(PlacedRegion<d>(shape, settings.placement, settings.h), feature(shape), 5);
  });
}

/// The normal turns at the rate of the curvature along a principal direction, and not across it.
template <int d>
bool check_curvature_by_differences(const Shape<d>& shape, const BoundaryPoint<d>& foot) {
  double sharpest = 1 / shape.size();
  for (const double k : foot.curvature) sharpest = std::max(sharpest, std::abs(k));
  const double step = 1e-4 / sharpest, tolerance = 2e-3 * sharpest;
  if (step < 1e-7 * shape.size()) return false;  // rounding of the foot over the step
  for (int i = 0; i < d - 1; ++i) {
    std::array<std::optional<BoundaryPoint<d>>, 2> neighbours;
    for (int side = 0; side < 2; ++side) {
      try {
        neighbours[side] =
            shape.project(foot.position + (side == 0 ? -step : step) * foot.direction[i], {step});
      } catch (const UncertifiedProjection&) {
        return false;  // beyond an edge or a cusp
      }
      if (!neighbours[side] || neighbours[side]->normal.dot(foot.normal) < 0.99) return false;
    }
    const RealPoint<d> moved = neighbours[1]->position - neighbours[0]->position;
    const RealPoint<d> turned = neighbours[1]->normal - neighbours[0]->normal;
    for (int j = 0; j < d - 1; ++j) {
      const double expected = i == j ? foot.curvature[i] : 0;
      EXPECT_NEAR(turned.dot(foot.direction[j]) / moved.dot(foot.direction[i]), expected, tolerance)
          << "along direction " << i << ", component " << j << " at " << foot.position.transpose();
    }
  }
  return true;
}

template <int d>
void check_frame(const BoundaryPoint<d>& foot) {
  EXPECT_NEAR(foot.normal.norm(), 1, 1e-12);
  for (int i = 0; i < d - 1; ++i) {
    EXPECT_NEAR(foot.direction[i].norm(), 1, 1e-12);
    EXPECT_NEAR(foot.direction[i].dot(foot.normal), 0, 1e-12);
    for (int j = 0; j < i; ++j) {
      EXPECT_NEAR(foot.direction[i].dot(foot.direction[j]), 0, 1e-12);
      EXPECT_GE(foot.curvature[j], foot.curvature[i]);
    }
  }
  if constexpr (d == 2) {  // the shape on the left of the tangent
    EXPECT_NEAR(foot.direction[0][0], -foot.normal[1], 1e-12);
    EXPECT_NEAR(foot.direction[0][1], foot.normal[0], 1e-12);
  }
}

template <int d>
void check_foot(const Shape<d>& shape, const RealPoint<d>& query, const BoundaryPoint<d>& foot, GridStep h,
                RandomStream& random) {
  SCOPED_TRACE(testing::Message() << "query " << query.transpose() << ", foot " << foot.position.transpose());
  const double size = shape.size();
  EXPECT_LE(foot.residual, 1e-12);
  EXPECT_LE(foot.distance, h.value / 2 * (1 + 1e-8));
  const RealPoint<d> difference = query - foot.position;
  EXPECT_NEAR(difference.norm(), foot.distance, 1e-13 * size);
  EXPECT_LE((difference - difference.dot(foot.normal) * foot.normal).norm(), 2e-12 * size);
  check_frame(foot);

  double sharpest = 1 / size;
  for (const double k : foot.curvature) sharpest = std::max(sharpest, std::abs(k));
  const double offset = std::min(1e-6 * size, 1e-3 / sharpest);
  EXPECT_FALSE(shape.contains(foot.position + offset * foot.normal));
  EXPECT_TRUE(shape.contains(foot.position - offset * foot.normal));

  // Nothing of the other side is nearer than the foot.
  if (foot.distance < 1e-6 * size) return;
  const bool inside = shape.contains(query);
  std::vector<RealPoint<d>> probes;
  for (int i = 0; i < 64; ++i) probes.push_back(query + 0.999 * foot.distance * random_direction<d>(random));
  EXPECT_EQ(shape.inside(probes), inside ? ~std::uint64_t{0} : 0) << "another boundary point is nearer";
}

TEST_P(CatalogueContract, TruthAtSurfelsIsTheGeometryOfTheClosestPoint) {
  with_shape([]<int d>(const Shape<d>& shape) {
    RandomStream random{6};
    for (const double steps : {7.0, d == 2 ? 300.0 : 60.0}) {
      const auto settings = random_settings<d>(feature(shape) / steps, std::uint64_t(steps));
      SCOPED_TRACE(testing::Message() << "h = " << settings.h.value);
      const auto surfels = thinned(make_scene(shape, settings).surfels, 1200);
      const Truth truth = truth_at_surfels(shape, settings, surfels, {});
      EXPECT_LE(truth.worst_residual, 1e-12);
      EXPECT_EQ(truth.far, 0);
      int smooth = 0, differentiated = 0;
      for (std::size_t i = 0; i < surfels.size(); ++i) {
        const RealPoint<d> query =
            settings.placement.to_shape(centre(surfels[i], settings.h.value), settings.h);
        const auto foot = shape.project(query, {settings.h.value / 2 * (1 + 1e-9)});
        ASSERT_EQ(foot.has_value(), truth.known[i] != 0);
        if (!foot) continue;
        ++smooth;
        check_foot(shape, query, *foot, settings.h, random);
        if (i % 3 == 0) differentiated += 3 * check_curvature_by_differences(shape, *foot);
        if (HasFailure()) return;  // one surfel says enough
      }
      EXPECT_EQ(truth.singular, std::int64_t(surfels.size()) - smooth);
      EXPECT_GT(smooth, 0.5 * double(surfels.size()));
      EXPECT_GT(differentiated, 0.7 * smooth) << "too few curvatures were checked";
    }
  });
}

/// Deterministic queries near the boundary, with their feet.
template <int d>
std::vector<std::pair<RealPoint<d>, BoundaryPoint<d>>> sample_feet(const Shape<d>& shape, double& within) {
  const auto settings = random_settings<d>(feature(shape) / 20, 7);
  within = settings.h.value / 2 * (1 + 1e-8);
  std::vector<std::pair<RealPoint<d>, BoundaryPoint<d>>> result;
  for (const Surfel<d>& surfel : thinned(make_scene(shape, settings).surfels, 200)) {
    const RealPoint<d> query = settings.placement.to_shape(centre(surfel, settings.h.value), settings.h);
    if (const auto foot = shape.project(query, {within})) result.emplace_back(query, *foot);
  }
  return result;
}

TEST_P(CatalogueContract, CurvatureScalesWithTheInverseOfTheLengths) {
  // The equation of these has lengths of its own: the parameters do not scale it.
  if (std::set<std::string>{"diabolo", "polynomial"}.contains(GetParam())) return;
  constexpr double s = 1.75;
  ShapeSpec scaled{GetParam(), {}};
  bool has_length = false;
  for (const Parameter& parameter : find_shape(GetParam()).parameters)
    if (parameter.unit == "length") {
      scaled.values[parameter.name] = s * std::get<double>(parameter.default_value);
      has_length |= parameter.name.size() > 2 || parameter.name[0] != 'c';
    }
  if (!has_length) return;
  with_shape([&]<int d>(const Shape<d>& shape) {
    const auto large = std::get<std::shared_ptr<const Shape<d>>>(make_shape(scaled));
    EXPECT_NEAR(large->size(), s * shape.size(), 1e-9 * large->size());
    double within;
    for (const auto& [query, foot] : sample_feet(shape, within)) {
      const auto moved = large->project(s * query, {s * within});
      ASSERT_TRUE(moved) << query.transpose();
      EXPECT_LE((moved->position - s * foot.position).norm(), 1e-9 * large->size());
      EXPECT_GE(moved->normal.dot(foot.normal), 1 - 1e-12);
      for (int i = 0; i < d - 1; ++i) {
        const double sharpest = std::max(std::abs(foot.curvature[0]), std::abs(foot.curvature[d - 2]));
        EXPECT_NEAR(s * moved->curvature[i], foot.curvature[i], 1e-6 * (sharpest + 1 / shape.size()));
      }
    }
  });
}

TEST_P(CatalogueContract, TheFootMovesWithTheCentre) {
  with_shape([&]<int d>(const Shape<d>& shape) {
    RealPoint<d> c;
    ShapeSpec spec{GetParam(), {}};
    for (int k = 0; k < d; ++k) {
      c[k] = shape.size() * (0.3 + 0.17 * k);
      spec.values[std::string("c") + "xyz"[k]] = c[k];
    }
    const auto moved_shape = std::get<std::shared_ptr<const Shape<d>>>(make_shape(spec));
    EXPECT_TRUE(moved_shape->bounds().center().isApprox(shape.bounds().center() + c, 1e-12));
    double within;
    for (const auto& [query, foot] : sample_feet(shape, within)) {
      const auto moved = moved_shape->project(query + c, {within});
      ASSERT_TRUE(moved) << query.transpose();
      EXPECT_LE((moved->position - c - foot.position).norm(), 1e-10 * shape.size());
      EXPECT_EQ(moved_shape->contains(query + c), shape.contains(query));
      for (int i = 0; i < d - 1; ++i) {
        const double sharpest = std::max(std::abs(foot.curvature[0]), std::abs(foot.curvature[d - 2]));
        EXPECT_NEAR(moved->curvature[i], foot.curvature[i], 1e-6 * (sharpest + 1 / shape.size()));
      }
    }
  });
}

TEST_P(CatalogueContract, CanonicalTextNamesTheSameShape) {
  ShapeSpec spec{GetParam(), {}};
  const std::string text = spec.canonical();
  EXPECT_EQ(ShapeSpec::parse(text).canonical(), text);
  EXPECT_EQ(ShapeSpec::parse(GetParam()).canonical(), text);
  spec.values["cx"] = 1.0 / 3.0;  // needs all 17 digits
  const ShapeSpec again = ShapeSpec::parse(spec.canonical());
  EXPECT_EQ(std::get<double>(again.values.at("cx")), 1.0 / 3.0);
  EXPECT_EQ(again.canonical(), spec.canonical());
}

TEST(Catalogue, NamesAreUniqueAndEveryLineIsDocumented) {
  std::set<std::string> names;
  for (const ShapeEntry& entry : shape_catalogue()) {
    EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
    EXPECT_FALSE(entry.summary.empty()) << entry.name;
    std::set<std::string> parameters;
    for (const Parameter& parameter : entry.parameters) {
      EXPECT_TRUE(parameters.insert(parameter.name).second) << entry.name << " " << parameter.name;
      EXPECT_FALSE(parameter.meaning.empty()) << entry.name << " " << parameter.name;
      EXPECT_TRUE((std::set<std::string>{"length", "radian", "1", "text"}.contains(parameter.unit)))
          << entry.name << " " << parameter.name << " " << parameter.unit;
    }
  }
}

TEST(Catalogue, AShapeOfTheOtherDimensionIsAnError) {
  EXPECT_THROW(make_shape<3>("disk"), InputError);
  EXPECT_THROW(make_shape<2>("sphere"), InputError);
}

/// Sum over the surfels of value * h^(d-1) |n . e_axis|: the integral of `value` over the boundary, to O(h).
template <int d>
double integral(const Shape<d>& shape, const std::string& quantity, double h, std::uint64_t seed,
                double* largest = nullptr) {
  const auto settings = random_settings<d>(h, seed);
  const auto surfels = make_scene(shape, settings).surfels;
  std::vector<std::string> quantities{quantity, "normal_x", "normal_y"};
  if (d == 3) quantities.push_back("normal_z");
  const Truth truth = truth_at_surfels(shape, settings, surfels, quantities);
  double sum = 0;
  for (std::size_t i = 0; i < surfels.size(); ++i) {
    if (largest) *largest = std::max(*largest, std::abs(truth.columns[0][i]));
    sum += truth.columns[0][i] * std::abs(truth.columns[std::size_t(1 + surfels[i].axis)][i]);
  }
  return sum * std::pow(h, d - 1);
}

class TotalCurvature : public testing::TestWithParam<std::string> {};

TEST_P(TotalCurvature, OfAClosedCurveIsOneTurn) {
  const auto shape = make_shape<2>(GetParam());
  for (const double steps : {200.0, 800.0}) {
    const double h = shape->size() / steps;
    double sharpest = 0;
    const double sum = integral(*shape, "kappa", h, 8, &sharpest);
    EXPECT_NEAR(sum, 2 * pi, 0.5 * h * sharpest) << steps;
  }
}
INSTANTIATE_TEST_SUITE_P(Curves, TotalCurvature,
                         testing::Values("disk", "ellipse", "flower", "accflower", "lpball"), test_name);

struct Topology {
  std::string shape;
  int euler_characteristic;
};
void PrintTo(const Topology& topology, std::ostream* out) {
  *out << topology.shape << ", Euler characteristic " << topology.euler_characteristic;
}

class GaussBonnet : public testing::TestWithParam<Topology> {};

TEST_P(GaussBonnet, TotalGaussianCurvatureIsTopological) {
  const auto shape = make_shape<3>(GetParam().shape);
  for (const double steps : {20.0, 60.0})
    EXPECT_NEAR(integral(*shape, "gaussian", shape->size() / steps, 9) / (2 * pi),
                GetParam().euler_characteristic, 2 / steps)
        << steps;
}
INSTANTIATE_TEST_SUITE_P(Surfaces, GaussBonnet,
                         testing::Values(Topology{"sphere", 2}, Topology{"ellipsoid", 2},
                                         Topology{"goursat", 2}, Topology{"rounded-cube", 2},
                                         Topology{"star", 2}, Topology{"torus", 0}),
                         [](const auto& topology) {
                           return test_name({topology.param.shape, topology.index});
                         });

class SingularShape : public testing::TestWithParam<std::string> {};

TEST_P(SingularShape, CountsSurfelsWhoseClosestPointIsSingular) {
  std::visit(
      []<int d>(const std::shared_ptr<const Shape<d>>& shape) {
        std::int64_t singular = 0;
        for (const std::uint64_t seed : {10, 11, 12, 13, 14, 15}) {
          const auto settings = random_settings<d>(shape->size() / 25, seed);
          const auto surfels = make_scene(*shape, settings).surfels;
          const Truth truth = truth_at_surfels(*shape, settings, surfels, {"normal_x"});
          singular += truth.singular;
          EXPECT_LT(truth.singular, std::int64_t(surfels.size()) / 2);
          EXPECT_EQ(std::count(truth.known.begin(), truth.known.end(), 0), truth.singular);
          for (std::size_t i = 0; i < surfels.size(); ++i) {
            if (truth.known[i]) continue;
            EXPECT_EQ(truth.columns[0][i], 0);
            const RealPoint<d> query =
                settings.placement.to_shape(centre(surfels[i], settings.h.value), settings.h);
            EXPECT_THROW(shape->truth(query, {0.51 * settings.h.value}), InputError);
          }
        }
        EXPECT_GT(singular, 0);
      },
      make_shape(ShapeSpec{GetParam(), {}}));
}
INSTANTIATE_TEST_SUITE_P(Shapes, SingularShape,
                         testing::Values("square", "ngon", "cube", "l1ball", "cylinder"), test_name);

TEST(SingularPoints, HaveNoCurvature) {
  EXPECT_THROW(make_shape<2>("square:10")->truth({5.2, 5.3}, {1}), InputError);
  EXPECT_THROW(make_shape<2>("astroid:10")->truth({10.3, 0}, {1}), InputError);
  EXPECT_THROW(make_shape<2>("lemniscate:10")->truth({0, 0}, {1}), InputError);
  EXPECT_THROW(make_shape<3>("cube:10")->truth({5.2, 5.3, 0}, {1}), InputError);
  EXPECT_THROW(make_shape<3>("l1ball:10")->truth({0, 0, 10.5}, {1}), InputError);
  EXPECT_THROW(make_shape<3>("cylinder:5,10")->truth({0, 5.1, 5.1}, {1}), InputError);
  try {
    make_shape<2>("square:10")->truth({5.25, 5.5}, {1});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("(5.25, 5.5)"), std::string::npos) << error.what();
  }
}

TEST(Projection, ThatReachesTooFarIsAnError) {
  for (const std::string name : {"disk", "ellipse", "flower", "square"}) {
    const auto shape = make_shape<2>(name);
    EXPECT_THROW(shape->project({2 * shape->size(), 0.3}, {shape->size() / 100}), UncertifiedProjection)
        << name;
  }
}

}  // namespace
}  // namespace gridstep
