#include "shapes/base/quadratic_bound.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "shapes/base/random.hpp"

namespace gridstep {
namespace {

double symmetric(RandomStream& random) {
  return 2 * random.uniform() - 1;
}

/// Of any scale, the box far from the origin and the centre of the bound far from the box: terms cancel.
template <int d>
struct BoundAndBox {
  QuadraticBound<d> bound;
  RealBox<d> box;

  explicit BoundAndBox(RandomStream& random) {
    const double scale = std::exp2(60 * symmetric(random)), far = std::exp2(30 * random.uniform());
    RealPoint<d> lo;
    for (int k = 0; k < d; ++k) {
      lo[k] = scale * far * symmetric(random);
      bound.centre[k] = scale * far * symmetric(random);
      bound.slope[k] = symmetric(random);
      for (int j = 0; j <= k; ++j) bound.bend(j, k) = bound.bend(k, j) = symmetric(random) / (scale * far);
    }
    box = RealBox<d>(lo, lo);
    for (int k = 0; k < d; ++k) box.max()[k] += scale * random.uniform();
    bound.value = 0;
    bound.value = -bound(box.center());
  }

  /// Q(p), without the rounding of doubles.
  long double exact(const RealPoint<d>& p) const {
    const auto x = (p.template cast<long double>() - bound.centre.template cast<long double>()).eval();
    return bound.value +
           x.dot(bound.slope.template cast<long double>() + bound.bend.template cast<long double>() * x);
  }
};

/// The least and the greatest value at the corners, which is that over the box where the function is affine.
template <int d>
std::pair<long double, long double> range_at_corners(const BoundAndBox<d>& one, const RealBox<d>& box) {
  long double least = std::numeric_limits<long double>::infinity(), greatest = -least;
  for (int i = 0; i < (1 << d); ++i) {
    const long double value = one.exact(box.corner(typename RealBox<d>::CornerType(i)));
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
  return {least, greatest};
}

/// Parts of a box as BoundOfParts counts them, cut as exactly as doubles can.
template <int d>
RealBox<d> part_of(const RealBox<d>& box, int part) {
  RealBox<d> result = box;
  for (int k = 0; k < d; ++k) ((part >> k) & 1 ? result.min() : result.max())[k] = box.center()[k];
  return result;
}

/// Errors such that the truth is a rounding away from what would decide a box or a part of it: of affine functions, and
/// of others where the corners are the extremes.
template <int d>
void never_decide_wrongly() {
  RandomStream random{21};
  int wrong = 0, decided = 0, wrong_of_parts = 0, decided_of_parts = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    BoundAndBox<d> one(random);
    if (trial % 2 == 0) one.bound.bend.setZero();
    const RealPoint<d> quarter = one.box.sizes() / 4;
    for (int i = 0; i < (1 << d); ++i) {
      const RealBox<d> part = part_of<d>(one.box, i);
      for (const auto& [box, own] : {std::pair(one.box, false), std::pair(part, true)}) {
        // Values as far above (below) zero as the error allows, but for the last bits.
        BoundAndBox<d> at_edge = one;
        const auto [least, greatest] = range_at_corners(one, box);
        const auto size = double(greatest - least);
        const bool above = random.below(2) == 0;
        const double shift = double(above ? size - least : -size - greatest);
        at_edge.bound.value += shift;
        const auto [low, high] = range_at_corners(at_edge, box);
        const long double distance = above ? low : -high;
        for (const double off : {1 + 1e-15, 1 - 1e-6}) {
          at_edge.bound.error = double(distance * off);
          const Side side = own ? BoundOfParts<d>(at_edge.bound, one.box.center(), quarter, quarter).side(i)
                                : at_edge.bound.side(box);
          (own ? decided_of_parts : decided) += side != Side::crossing;
          if (off > 1) (own ? wrong_of_parts : wrong) += side != Side::crossing;
          if (off < 1 && side != Side::crossing) {
            EXPECT_EQ(side, above ? Side::outside : Side::inside);
          }
        }
      }
    }
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(wrong_of_parts, 0);
  EXPECT_GT(decided, 20000) << "bounds of no use";
  EXPECT_GT(decided_of_parts, 20000) << "bounds of no use";
}

TEST(QuadraticBound, NeverDecidesWithinItsError) {
  never_decide_wrongly<2>();
  never_decide_wrongly<3>();
}

/// What is said of a box holds at its points, however the function bends.
template <int d>
void hold_inside() {
  RandomStream random{22};
  int decided = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    BoundAndBox<d> one(random);
    const auto [least, greatest] = range_at_corners(one, one.box);
    one.bound.value += 2 * symmetric(random) * double(greatest - least);
    one.bound.error = 0;
    const RealPoint<d> quarter = one.box.sizes() / 4;
    const BoundOfParts<d> of_parts(one.bound, one.box.center(), quarter, quarter);
    const Side whole = one.bound.side(one.box);
    for (int sample = 0; sample < 30; ++sample) {
      RealPoint<d> p;
      int part = 0;
      for (int k = 0; k < d; ++k) {
        const double at = random.uniform();
        p[k] = one.box.min()[k] + at * one.box.sizes()[k];
        part |= (p[k] > one.box.center()[k]) << k;
      }
      for (const Side side : {whole, of_parts.side(part)}) {
        if (side == Side::crossing) continue;
        ++decided;
        EXPECT_EQ(one.exact(p) > 0, side == Side::outside);
      }
    }
  }
  EXPECT_GT(decided, 100000) << "bounds of no use";
}

TEST(QuadraticBound, HoldsAtEveryPointOfABoxAndOfItsParts) {
  hold_inside<2>();
  hold_inside<3>();
}

TEST(QuadraticBound, KnowsTheSlopesInTheMiddleOfParts) {
  RandomStream random{23};
  for (int trial = 0; trial < 1000; ++trial) {
    const BoundAndBox<3> one(random);
    const RealPoint<3> quarter = one.box.sizes() / 4;
    const BoundOfParts<3> of_parts(one.bound, one.box.center(), quarter, quarter);
    for (int i = 0; i < 8; ++i) {
      const double slope = one.bound.gradient(part_of<3>(one.box, i).center()).cwiseAbs().maxCoeff();
      EXPECT_NEAR(of_parts.slope(i), slope, 1e-6 * (1 + slope));
    }
  }
}

/// Half-spaces whose planes are a few units of the last place beyond the farthest corner of a box, or before it.
TEST(BoundOfIntersection, SaysInsideOnlyWhereEveryComputedPointIs) {
  RandomStream random{24};
  int wrong = 0, inside = 0;
  for (int trial = 0; trial < 200000; ++trial) {
    const RealPoint<3> normal =
        RealPoint<3>(symmetric(random), symmetric(random), symmetric(random)).normalized();
    const double scale = std::exp2(60 * symmetric(random)), width = scale * std::exp2(-50 * random.uniform());
    RealPoint<3> lo, hi, farthest;
    for (int k = 0; k < 3; ++k) {
      lo[k] = scale * symmetric(random);
      hi[k] = lo[k] + width * random.uniform();
      farthest[k] = normal[k] > 0 ? hi[k] : lo[k];
    }
    double height = 0;
    for (int k = 0; k < 3; ++k) height += normal[k] * farthest[k];
    const double offset = height + std::exp2(-56 + 18 * random.uniform()) * scale * symmetric(random);
    const RealBox<3> box(lo, hi);
    BoundOfIntersection<3> bound(box);
    bound.add_half_space(normal, offset);
    if (bound.bound().side(box) != Side::inside) continue;
    ++inside;
    wrong += height > offset;
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(inside, 1000) << "bounds of no use";
}

}  // namespace
}  // namespace gridstep
