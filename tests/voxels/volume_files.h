// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/voxels/voxel_grid.h"

#include <string>
#include <string_view>
#include <vector>

namespace trivar::testing {

// A grid of 5 x 4 x 3 samples that are all different, oblique, with spacings of 0.7, 0.8 and 1.25
// mm: what the tests write in every format.
VoxelGrid small_volume();

// The samples of small_volume() as another type, in either order of bytes.
template <class T> std::string packed(const VoxelGrid& grid, bool big_endian = false);
extern template std::string packed<std::uint8_t>(const VoxelGrid&, bool);
extern template std::string packed<std::int16_t>(const VoxelGrid&, bool);
extern template std::string packed<std::int32_t>(const VoxelGrid&, bool);
extern template std::string packed<float>(const VoxelGrid&, bool);
extern template std::string packed<double>(const VoxelGrid&, bool);

std::string gzipped(std::string_view bytes);
std::string zlib_packed(std::string_view bytes);
std::string bzip2_packed(std::string_view bytes);
std::string in_base64(std::string_view bytes);
std::string in_words(const VoxelGrid& grid); // samples, separated by blanks

// A VTI file with the samples of small_volume() as 16-bit whole numbers.
enum class VtiKind { ascii, binary, binary_packed, raw, raw_packed, base64_packed };
std::string vti_file(VtiKind kind);

// A legacy VTK file with them.
std::string vtk_file(bool binary);

// A MetaImage with them, attached; packed by zlib or not.
std::string meta_file(bool packed_by_zlib);

// Small sound files of every format that is one file, by names that end as theirs do.
struct NamedBytes {
    std::string name, bytes;
};
std::vector<NamedBytes> sound_volumes();

} // namespace trivar::testing
