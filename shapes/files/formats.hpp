#pragma once

#include <array>
#include <bit>

#include "shapes/files/grey_volume.hpp"

// One reader and one writer a format of volumes; volume_file.hpp finds them by extension. Readers throw InputError
// in one line that names the file and what is wrong with it, and allocate no more than a small multiple of what the
// file holds. Writers throw InputError where the format cannot hold the values.
namespace gridstep {

/// .vol: values from 0 to 255, no spacing. @see libvol.hpp
GreyVolume read_vol(ByteReader& file);
void write_vol(const GreyVolume& volume, const Sink& sink);

/// .longvol: unsigned integers of 64 bits, no spacing. @see libvol.hpp
GreyVolume read_longvol(ByteReader& file);
void write_longvol(const GreyVolume& volume, const Sink& sink);

/// .pgm3d: PGM with three sides. P2 or P2-3D has decimals; P5, P5-3D, or P3D has bytes (two above a maximum of 255,
/// the higher first).
GreyVolume read_pgm3d(ByteReader& file);
void write_pgm3d(const GreyVolume& volume, const Sink& sink);

/// What a .raw file does not say.
struct RawLayout {
  std::array<std::int64_t, 3> sides;
  VoxelType type = VoxelType::uint8;
  std::endian order = std::endian::little;
};

/// .raw: the values and nothing else; its length has to be that of the layout.
GreyVolume read_raw(ByteReader& file, const RawLayout& layout);
/// Little endian.
void write_raw(const GreyVolume& volume, const Sink& sink);

/// .nrrd with its data inside, raw or gzip, of dimension 3; the spacing from "spacings" or "space directions".
GreyVolume read_nrrd(ByteReader& file);
void write_nrrd(const GreyVolume& volume, const Sink& sink);

/// .nii of NIfTI-1, in one file, and .nii.gz. Where the header scales the values, they become doubles.
GreyVolume read_nifti(ByteReader& file);

/// .vti: VTK's ImageData, the voxels as points.
void write_vti(const GreyVolume& volume, const Sink& sink);

}  // namespace gridstep
