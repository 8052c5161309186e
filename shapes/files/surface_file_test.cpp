#include "shapes/files/surface_file.hpp"
#include "shapes/files/testing_volumes.hpp"

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

TEST(QuadMesh, GivesItsSurfelsBack) {
  const auto surfels = boundary(set_of({{1, 1, 1}, {2, 1, 1}, {2, 2, 1}, {4, 4, 4}, {5, 5, 5}}));
  for (const double h : {1.0, 0.1, 1.0 / 3}) EXPECT_EQ(surfels_of(quad_mesh(surfels, {h}), {h}), surfels);
}

TEST(QuadMesh, OfOtherSquaresIsRefused) {
  const QuadMesh mesh = quad_mesh(boundary(set_of({{1, 1, 1}})), {0.5});
  const auto of_changed = [&](auto change) {
    QuadMesh changed = mesh;
    change(changed);
    return failure([&] { surfels_of(changed, {0.5}); });
  };
  EXPECT_EQ(of_changed([](QuadMesh&) {}), "");
  const std::string second = "face 1 is no surfel at h = 0.5";
  EXPECT_EQ(of_changed([](QuadMesh& m) { std::swap(m.quads[1][0], m.quads[1][1]); }), second) << "crossed";
  EXPECT_EQ(of_changed([](QuadMesh& m) { m.quads[1] = {0, 0, 0, 0}; }), second);
  for (const double x : {0.3, 1e300, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_EQ(of_changed([&](QuadMesh& m) {
                m.vertices.push_back({x, 0.25, 0.25});
                m.quads[1][0] = std::int32_t(m.vertices.size() - 1);
              }),
              second)
        << x;
  EXPECT_EQ(failure([&] { surfels_of(mesh, {0.25}); }), "face 0 is no surfel at h = 0.25");
}

TEST(Ply, IsReadAsItWasWritten) {
  const auto surfels = boundary(set_of({{1, 1, 1}, {2, 1, 1}}));
  const QuadMesh mesh = quad_mesh(surfels, {0.1});
  SurfelTable table{surfels.size(), {}, {}};
  table.values.push_back(
      {"component", SurfelColumn::Type::integer, [](std::size_t i) { return double(i % 2); }});
  table.values.push_back(
      {"mean", SurfelColumn::Type::real, [](std::size_t i) { return -1e-30 / double(i + 3); }});
  std::string text;
  write_ply(table, mesh, [&](std::string_view bytes) { text += bytes; });
  ByteReader file("a.ply", text);
  const PlySurface read = read_ply(file);
  EXPECT_EQ(read.mesh.vertices, mesh.vertices);
  EXPECT_EQ(read.mesh.quads, mesh.quads);
  EXPECT_EQ(read.titles, (std::vector<std::string>{"component", "mean"}));
  for (std::size_t c = 0; c < 2; ++c)
    for (std::size_t i = 0; i < surfels.size(); ++i) EXPECT_EQ(read.columns[c][i], table.values[c].value(i));
}

TEST(Ply, NamesWhatIsWrong) {
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty double x\nproperty double y\nproperty double z\n"
      "element face 1\nproperty list uchar int vertex_indices\nproperty double mean\nend_header\n";
  const auto of = [](const std::string& text) {
    return failure([&] {
      ByteReader file("a.ply", text);
      read_ply(file);
    });
  };
  const auto with = [&](const std::string& old, const std::string& now) {
    std::string text = header + "0 0 0\n4 0 0 0 0 0.5\n";
    return text.replace(text.find(old), old.size(), now);
  };
  EXPECT_EQ(of(with("ply", "ply")), "");
  EXPECT_EQ(of(""), "a.ply: line 1: truncated");
  EXPECT_EQ(of(with("ascii", "binary")),
            "a.ply: line 2: 'format binary 1....' where 'format ascii 1.0' is expected");
  EXPECT_EQ(of(with("vertex 1", "vertex -1")),
            "a.ply: line 3: 'element vertex -...' where 'element vertex COUNT' is expected");
  EXPECT_EQ(of(with("face 1", "face 2147483647")), "a.ply: truncated: its header says more");
  EXPECT_EQ(of(with("double mean", "list mean")), "a.ply: line 9: no property of a face that is a number");
  EXPECT_EQ(of(with("0 0 0\n4", "0 0\n4")), "a.ply: line 11: '' is no number that may stand here");
  EXPECT_EQ(of(with("4 0", "3 0")), "a.ply: line 12: not a square");
  EXPECT_EQ(of(with("4 0", "4 1")), "a.ply: line 12: there is no vertex 1");
  EXPECT_EQ(of(with("0.5", "0.5 1")), "a.ply: line 12: more than its header says");
  EXPECT_EQ(of(with("0.5", "half")), "a.ply: line 12: 'half' is no number that may stand here");
  EXPECT_EQ(of(with("0.5\n", "0.5\n1\n")), "a.ply: line 12: more than its header says");
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
