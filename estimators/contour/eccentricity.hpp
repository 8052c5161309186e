#pragma once

namespace gridstep {

/// Weight of a maximal segment or arc for a point at the fraction e of its length: 64 e^3 (1 - e)^3, twice
/// continuously differentiable, 0 at the ends and 1 in the middle [Lachaud, Vialard & de Vieilleville, IVC 2007].
inline double eccentricity_weight(double e) {
  const double u = 4 * e * (1 - e);
  return u * u * u;
}

}  // namespace gridstep
