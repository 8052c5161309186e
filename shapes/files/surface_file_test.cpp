#include "shapes/files/surface_file.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <limits>
#include <set>

#include "shapes/digital/boundary.hpp"
#include "shapes/files/volume_file.hpp"

namespace gridstep {
namespace {

DigitalSet<3> set_of(const std::vector<LatticePoint<3>>& points) {
  DigitalSet<3> set({LatticePoint<3>{0, 0, 0}, LatticePoint<3>{7, 7, 7}});
  for (const LatticePoint<3>& z : points) set.set(z, true);
  return set;
}

TEST(QuadMesh, SquaresAreWhereTheSurfelsAre) {
  const auto surfels = boundary(set_of({{1, 1, 1}, {2, 1, 1}, {2, 2, 1}, {4, 4, 4}}));
  const GridStep h{0.5};
  const QuadMesh mesh = quad_mesh(surfels, h);
  EXPECT_EQ(std::set(mesh.vertices.begin(), mesh.vertices.end()).size(), mesh.vertices.size());
  ASSERT_EQ(mesh.quads.size(), surfels.size());
  for (std::size_t i = 0; i < surfels.size(); ++i) {
    RealPoint<3> p[4];
    for (std::size_t k = 0; k < 4; ++k) {
      const auto& vertex = mesh.vertices[std::size_t(mesh.quads[i][k])];
      p[k] = {vertex[0], vertex[1], vertex[2]};
    }
    EXPECT_EQ((p[0] + p[1] + p[2] + p[3]) / 4, centre(surfels[i], h.value));
    // Both triangles have the outward normal, and the area of half a square.
    EXPECT_EQ((p[1] - p[0]).cross(p[2] - p[0]), h.value * h.value * surfels[i].normal());
    EXPECT_EQ((p[2] - p[0]).cross(p[3] - p[0]), h.value * h.value * surfels[i].normal());
  }
}

TEST(QuadMesh, ASphereHasEulerCharacteristicTwo) {
  DigitalSet<3> ball({LatticePoint<3>{-6, -6, -6}, LatticePoint<3>{6, 6, 6}});
  for_each_point(LatticeBox<3>{{-5, -5, -5}, {5, 5, 5}}, [&](const LatticePoint<3>& z) {
    if (z.squaredNorm() <= 25) ball.set(z, true);
  });
  const QuadMesh mesh = quad_mesh(boundary(ball), GridStep{1});
  std::set<std::pair<int, int>> edges;
  for (const auto& quad : mesh.quads)
    for (std::size_t k = 0; k < 4; ++k) edges.insert(std::minmax(quad[k], quad[(k + 1) % 4]));
  EXPECT_EQ(std::int64_t(mesh.vertices.size()) - std::int64_t(edges.size()) + std::int64_t(mesh.quads.size()),
            2);
}

TEST(SurfaceFile, TablesAreWrittenAsTheyAre) {
  SurfelTable table{2, {}, {}};
  table.keys.push_back({"k", SurfelColumn::Type::integer, [](std::size_t i) { return double(i) - 1; }});
  table.values.push_back({"v", SurfelColumn::Type::real, [](std::size_t i) {
                            return i == 0 ? 0.1 : std::numeric_limits<double>::quiet_NaN();
                          }});
  std::string csv, npy;
  write_csv(table, [&](std::string_view bytes) { csv += bytes; });
  write_npy(table, [&](std::string_view bytes) { npy += bytes; });
  EXPECT_EQ(csv, "k,v\n-1,0.1\n0,\n");
  EXPECT_EQ(npy.size() % 64, 2 * (4 + 8));
  EXPECT_TRUE(npy.starts_with("\x93NUMPY\x02"));
}

std::string failure(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(FormatTables, ExtensionsAreFoundInCapitalsToo) {
  EXPECT_EQ(surface_format("a/b.PLY", 3).extension, ".ply");
  EXPECT_EQ(readable_volume_format("brain.nii.gz").extension, ".nii.gz");
  EXPECT_EQ(readable_volume_format("x.longvol").extension, ".longvol");
  EXPECT_EQ(failure([] { surface_format("a.stl", 3); }),
            "a.stl: its extension must be one of .csv, .npy, .ply, .vtp, .obj");
  EXPECT_EQ(failure([] { surface_format("a.ply", 2); }), "a.ply: its extension must be one of .csv, .npy");
  EXPECT_EQ(failure([] { readable_volume_format("a.vti"); }),
            "a.vti: its extension must be one of .vol, .longvol, .pgm3d, .raw, .nrrd, .nii, .nii.gz");
  EXPECT_EQ(failure([] { writable_volume_format("a.nii"); }),
            "a.nii: its extension must be one of .vol, .longvol, .pgm3d, .raw, .nrrd, .vti");
}

TEST(FormatTables, VoxelTypesByName) {
  EXPECT_EQ(parse_voxel_type("int16").first, VoxelType::int16);
  EXPECT_EQ(parse_voxel_type("float64-be").second, std::endian::big);
  EXPECT_EQ(failure([] { parse_voxel_type("short"); }).find("unknown type 'short'; known: uint8, int8"), 0u);
}

}  // namespace
}  // namespace gridstep
