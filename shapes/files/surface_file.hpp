#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "shapes/files/grey_volume.hpp"
#include "shapes/files/quad_mesh.hpp"
#include "shapes/files/surfel_table.hpp"

namespace gridstep {

/// A header, and one line a surfel.
void write_csv(const SurfelTable& table, const Sink& sink);
/// NumPy's structured array, one record a surfel: numpy.load() gives it, with a field a column.
void write_npy(const SurfelTable& table, const Sink& sink);

// The mesh of the surface; its keys are the geometry. Columns x_x, x_y, x_z make one vector in VTP.

/// Text, with a property of each face for every value: few readers take those from binary files.
void write_ply(const SurfelTable& table, const QuadMesh& mesh, const Sink& sink);
/// A surface with the values of its faces.
struct PlySurface {
  QuadMesh mesh;
  std::vector<std::string> titles;
  std::vector<std::vector<double>> columns;  ///< columns[c][i] belongs to titles[c] and mesh.quads[i]
};
/// What write_ply() wrote: text, squares alone, nothing but numbers of each.
/// @throws InputError naming the file and the line that is not like that. No more memory is taken than a small
/// multiple of what the file holds.
PlySurface read_ply(ByteReader& file);
/// VTK's PolyData, with an array of cell data for every value or vector.
void write_vtp(const SurfelTable& table, const QuadMesh& mesh, const Sink& sink);
/// Text. The format has no values: the first real one is the texture coordinate of its square, vt VALUE 0.
void write_obj(const SurfelTable& table, const QuadMesh& mesh, const Sink& sink);

/// A line of the table of formats: with or without a mesh.
struct SurfaceFormat {
  std::string_view extension;
  void (*write_table)(const SurfelTable& table, const Sink& sink);
  void (*write_mesh)(const SurfelTable& table, const QuadMesh& mesh, const Sink& sink);
};

const std::vector<SurfaceFormat>& surface_formats();

/// By the extension of a path; contours (d = 2) have no mesh. @throws InputError listing the extensions.
const SurfaceFormat& surface_format(const std::string& path, int d);

}  // namespace gridstep
