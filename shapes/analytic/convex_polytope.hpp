#pragma once

#include <vector>

#include "shapes/analytic/shape.hpp"

namespace gridstep {

/// The intersection of half-spaces normal . x <= offset: flat faces of curvature 0, singular edges and
/// corners.
template <int d>
class ConvexPolytope final : public Shape<d> {
 public:
  struct Face {
    RealPoint<d> normal;  ///< unit, outwards
    double offset;
  };

  ConvexPolytope(const RealPoint<d>& centre, std::vector<Face> faces, const RealBox<d>& bounds)
      : Shape<d>(centre), faces_(std::move(faces)), bounds_(bounds) {}

 protected:
  RealBox<d> local_bounds() const override { return bounds_; }

  QuadraticBound<d> local_bound(const RealBox<d>& box) const override {
    BoundOfIntersection<d> bound(box);
    for (const Face& face : faces_) bound.add_half_space(face.normal, face.offset);
    return bound.bound();
  }

  std::uint64_t local_inside(std::span<const RealPoint<d>> points) const override {
    std::uint64_t result = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      bool inside = true;
      for (const Face& face : faces_) inside &= height(face, points[i]) <= face.offset;
      result |= std::uint64_t(inside) << i;
    }
    return result;
  }

  std::optional<BoundaryPoint<d>> local_project(const RealPoint<d>& query, double) const override {
    // Outside, only the faces that see the query can hold the closest point, and one does where its foot lies
    // in the polytope; inside, the closest face does.
    const double tolerance = 1e-12 * this->size();
    const bool is_outside = local_inside({&query, 1}) == 0;
    std::optional<BoundaryPoint<d>> nearest;
    for (const Face& face : faces_) {
      const double signed_distance = height(face, query) - face.offset;
      if (is_outside && signed_distance <= 0) continue;
      const RealPoint<d> foot = query - signed_distance * face.normal;
      bool interior = true;
      for (const Face& other : faces_)
        interior &= &other == &face || height(other, foot) < other.offset - tolerance;
      if (!interior || (nearest && nearest->distance <= std::abs(signed_distance))) continue;
      nearest = BoundaryPoint<d>{foot,
                                 face.normal,
                                 {},
                                 {},
                                 std::abs(signed_distance),
                                 std::abs(height(face, foot) - face.offset) / this->size()};
      if constexpr (d == 2)
        nearest->direction[0] = {-face.normal[1], face.normal[0]};
      else
        nearest->direction = {face.normal.unitOrthogonal(), face.normal.cross(face.normal.unitOrthogonal())};
    }
    return nearest;
  }

 private:
  static double height(const Face& face, const RealPoint<d>& p) {
    double sum = 0;
    for (int k = 0; k < d; ++k) sum += face.normal[k] * p[k];
    return sum;
  }

  std::vector<Face> faces_;
  RealBox<d> bounds_;
};

}  // namespace gridstep
