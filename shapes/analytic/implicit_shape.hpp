#pragma once

#include "shapes/analytic/formula.hpp"
#include "shapes/analytic/jet.hpp"
#include "shapes/analytic/shape.hpp"
#include "shapes/base/taylor_model.hpp"

namespace gridstep {

/// Parts of a boundary that count as singular: those within a distance of some points.
template <int d>
struct LeftOut {
  std::vector<RealPoint<d>> points;
  double distance = 0;
};

/// The region {f <= 0} of a polynomial f, within a box.
///
/// Its boundary is singular where the gradient of f vanishes. Where the box cuts {f <= 0} (`cut`), the faces
/// of the box are boundary too: flat, with singular rims.
template <int d>
class ImplicitShape final : public Shape<d> {
 public:
  /// {f <= 0}, known to lie in the box, or cut by it.
  ImplicitShape(const RealPoint<d>& centre, Formula formula, const RealBox<d>& box, bool cut = false,
                LeftOut<d> left_out = {});

 protected:
  RealBox<d> local_bounds() const override { return box_; }
  QuadraticBound<d> local_bound(const RealBox<d>& box) const override;
  void local_bound_each(std::span<const RealBox<d>> boxes,
                        std::span<QuadraticBound<d>> bounds) const override;
  std::uint64_t local_inside(std::span<const RealPoint<d>> points) const override;
  std::optional<BoundaryPoint<d>> local_project(const RealPoint<d>& query, double within) const override;

 private:
  struct Foot {
    RealPoint<d> position;
    Jet2<d> f;  // there
    bool singular;
  };
  QuadraticBound<d> bound_by(const TaylorModel<d>& model, const RealBox<d>& box) const;
  Interval natural_range(const RealBox<d>& box) const;
  Side side_of_polynomial(const RealBox<d>& box) const;
  double value(const RealPoint<d>& p) const;
  template <class Jet = Jet2<d>>
  Jet jet(const RealPoint<d>& p) const;
  std::optional<Foot> newton(const RealPoint<d>& query, const RealPoint<d>& start, double within) const;
  std::optional<Foot> descend(const RealPoint<d>& query, const RealPoint<d>& start, double within) const;
  std::optional<RealPoint<d>> correct(RealPoint<d> p, double within) const;
  std::vector<RealPoint<d>> crossings(const RealPoint<d>& query, double within) const;
  bool proves_closest(const RealPoint<d>& query, const Foot& foot) const;
  double hessian_bound(const RealBox<d>& box) const;
  bool is_minimum(const RealPoint<d>& query, const Foot& foot) const;
  std::optional<Foot> search(const RealPoint<d>& query, double within) const;
  BoundaryPoint<d> boundary_point(const RealPoint<d>& query, const Foot& foot) const;
  std::optional<BoundaryPoint<d>> nearest_cut(const RealPoint<d>& query) const;
  bool is_singular(const Jet2<d>& f) const;
  bool is_left_out(const RealPoint<d>& p) const;

  Formula formula_;
  RealBox<d> box_;
  bool cut_;
  LeftOut<d> left_out_;
  double size_;
  RealBox<d> neighbourhood_;  // of the box, over which the norm of the Hessian is at most
  double greatest_hessian_;
  double rounding_;  // bound on the rounding errors of f over a neighbourhood of the box
};

/// A box around {f <= 0}, found by proving with intervals that f > 0 on a shell around it, then tightened.
/// Parts farther from the origin than twice the box are not looked for. `bound` > 0: the box [-bound,
/// bound]^d, whose border is proved to lie outside.
/// @throws InputError naming the formula where {f <= 0} is empty, or where it is unbounded or reaches the
/// border.
template <int d>
RealBox<d> bounds_of(const Formula& formula, double bound = 0);

extern template class ImplicitShape<2>;
extern template class ImplicitShape<3>;

}  // namespace gridstep
