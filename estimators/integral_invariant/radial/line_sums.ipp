// Sums of weights over one mixed brick. Included once for each instruction set, within a namespace of its own.

/// The weights of a line of eight points, and sums of them: 32 bits hold what 64 lines of weights up to 2^20 add up to,
/// since no running sum counts weights more than 36^2 times, nor 288 times before its lanes are multiplied by 0 to 7, nor 64
/// times before they are by 0 to 21.
using Line [[gnu::vector_size(32)]] = std::int32_t;

/// By reference: how a vector is returned depends on the instruction set.
GRIDSTEP_INLINE void add_masked(const std::int32_t* weights, const Line& lanes, Line& sum) {
  Line line;
  __builtin_memcpy(&line, weights, sizeof line);
  sum += line & lanes;
}

/// For each byte, the lanes of its bits.
struct alignas(32) LaneMasks {
  std::int32_t of[256][8];

  constexpr LaneMasks() : of{} {
    for (int byte = 0; byte < 256; ++byte)
      for (int lane = 0; lane < 8; ++lane) of[byte][lane] = (byte >> lane & 1) ? -1 : 0;
  }
};
constexpr LaneMasks kLaneMasks;

using Half [[gnu::vector_size(16)]] = std::int32_t;
using Wide [[gnu::vector_size(32)]] = std::int64_t;

/// Sum over the lanes of a_i, of i a_i, of i (i - 1) / 2 a_i.
GRIDSTEP_INLINE std::int64_t lane_sum(const Line& line) {
  Half half[2];
  __builtin_memcpy(half, &line, sizeof line);
  const Wide wide = __builtin_convertvector(half[0], Wide) + __builtin_convertvector(half[1], Wide);
  return (wide[0] + wide[1]) + (wide[2] + wide[3]);
}
GRIDSTEP_INLINE std::int64_t place_sum(const Line& line) {
  return lane_sum(line * Line{0, 1, 2, 3, 4, 5, 6, 7});
}
GRIDSTEP_INLINE std::int64_t pair_sum(const Line& line) {
  return lane_sum(line * Line{0, 0, 1, 3, 6, 10, 15, 21});
}

void add_brick(const WeightTables& tables, const LatticePoint<3>& offset, const std::uint64_t* words,
               RadialSum& sum) {
  // Running sums along z of running sums along y; the digits are how often y and z were summed.
  Line g00{}, w00{}, w10{}, w01{}, u00{}, u10{}, u20{}, u01{}, u11{}, u02{};
  const std::ptrdiff_t side = tables.side(), line_stride = 3 * side;
  const std::int32_t* plane = tables.begin(offset) + 7 * line_stride * (1 + side);
  for (int z = 7; z >= 0; --z, plane -= line_stride * side) {
    if (std::uint64_t bytes = words[z]; bytes != 0) {
      Line g0{}, w0{}, w1{}, u0{}, u1{}, u2{};
      const std::int32_t* at = plane;
      for (int y = 7; y >= 0; --y, at -= line_stride, bytes <<= 8) {
        Line lanes;
        __builtin_memcpy(&lanes, kLaneMasks.of[bytes >> 56], sizeof lanes);
        add_masked(at, lanes, g0);
        add_masked(at + side, lanes, w0);
        add_masked(at + 2 * side, lanes, u0);
        w1 += w0;
        u1 += u0;
        u2 += u1;
      }
      g00 += g0;
      w00 += w0;
      w10 += w1;
      u00 += u0;
      u10 += u1;
      u20 += u2;
    }
    w01 += w00;
    u01 += u00;
    u11 += u10;
    u02 += u01;
  }

  // Sums of a, y a, z a, ... over the brick; x, y, z are places in it.
  const std::int64_t w = lane_sum(w00), wx = place_sum(w00), wy = lane_sum(w10) - w, wz = lane_sum(w01) - w;
  const std::int64_t u = lane_sum(u00), ux = place_sum(u00), uxx = 2 * pair_sum(u00) + ux;
  const std::int64_t u1 = lane_sum(u10), u2 = lane_sum(u01), uy = u1 - u, uz = u2 - u;
  const std::int64_t uxy = place_sum(u10) - ux, uxz = place_sum(u01) - ux, uyz = lane_sum(u11) - u1 - u2 + u;
  const std::int64_t uyy = 2 * lane_sum(u20) - 3 * u1 + u, uzz = 2 * lane_sum(u02) - 3 * u2 + u;
  // The coordinates from the centre are a + 2 x, b + 2 y, c + 2 z.
  const auto coordinate = [&](int axis) {
    return 2 * std::int64_t{offset[axis]} - (axis == tables.half_axis());
  };
  const std::int64_t a = coordinate(0), b = coordinate(1), c = coordinate(2);
  sum.trace += lane_sum(g00);
  sum.edge += w;
  sum.edge_first[0] += a * w + 2 * wx;
  sum.edge_first[1] += b * w + 2 * wy;
  sum.edge_first[2] += c * w + 2 * wz;
  sum.tensor_second[0] += a * a * u + 4 * (a * ux + uxx);
  sum.tensor_second[1] += a * b * u + 2 * (a * uy + b * ux) + 4 * uxy;
  sum.tensor_second[2] += a * c * u + 2 * (a * uz + c * ux) + 4 * uxz;
  sum.tensor_second[3] += b * b * u + 4 * (b * uy + uyy);
  sum.tensor_second[4] += b * c * u + 2 * (b * uz + c * uy) + 4 * uyz;
  sum.tensor_second[5] += c * c * u + 4 * (c * uz + uzz);
}
