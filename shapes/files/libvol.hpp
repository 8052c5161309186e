#pragma once

#include <string_view>

#include "shapes/files/grey_volume.hpp"

namespace gridstep {

/// What .vol and .longvol have in common: lines "Key: value" up to a line with a dot, then the voxels. Version 2 has
/// them as they are, version 3 in a zlib stream; files without a version, the oldest, repeat the sides as three ints
/// before them. Any key may occur; of those that are not X, Y, Z, Version and Int-Endian, none changes the voxels.
/// Center-X, -Y, -Z, where a file has them, are not followed: the first voxel is the point 0.
/// @throws InputError naming the file and what is wrong with it.
GreyVolume read_libvol(ByteReader& file, VoxelType type);

/// Version 2. @param prefix of the keys of voxels: "Voxel" or "Lvoxel"
void write_libvol(const GreyVolume& volume, VoxelType type, std::string_view prefix, const Sink& sink);

}  // namespace gridstep
