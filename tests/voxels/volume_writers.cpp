// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/voxels/volume_writers.h"

#include "core/base/rejected.h"
#include "core/base/text.h"

#include <bit>
#include <cstring>
#include <fmt/format.h>
#include <limits>

namespace trivar {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr double millimetres_a_metre = 1000;

std::string_view bytes_of(const VoxelGrid::Samples& samples)
{
    return std::visit(
        [](const auto& all) {
            return std::string_view(reinterpret_cast<const char*>(all.data()),
                                    all.size() * sizeof(all[0]));
        },
        samples);
}

VoxelGrid::Samples values_of(const VoxelGrid& grid)
{
    return std::visit(
        [&](const auto& all) -> VoxelGrid::Samples {
            std::vector<float> values(all.size());
            for (std::size_t i = 0; i < all.size(); ++i)
                values[i] = static_cast<float>(grid.value(static_cast<double>(all[i])));
            return values;
        },
        grid.samples);
}

std::string vector_in_mm(const glm::dvec4& v)
{
    const auto mm = [&](int k) { return shortest(v[k] * millimetres_a_metre); };
    return fmt::format("({},{},{})", mm(0), mm(1), mm(2));
}

template <class T> void put(std::string& bytes, std::size_t at, T value)
{
    std::memcpy(bytes.data() + at, &value, sizeof(T));
}

} // namespace

std::string write_nrrd(const VoxelGrid& grid)
{
    constexpr const char* types[] = {"uint8", "int8", "uint16", "int16", "float"};
    const bool scaled = grid.slope != 1 || grid.intercept != 0;
    const VoxelGrid::Samples values = scaled ? values_of(grid) : VoxelGrid::Samples();
    const VoxelGrid::Samples& samples = scaled ? values : grid.samples;
    const glm::dmat4& m = grid.to_metres;
    std::string out = fmt::format(
        "NRRD0004\ntype: {}\ndimension: 3\nspace: left-posterior-superior\nsizes: {} {} {}\n"
        "space directions: {} {} {}\nkinds: domain domain domain\nendian: little\n"
        "encoding: raw\nspace units: \"mm\" \"mm\" \"mm\"\nspace origin: {}\n\n",
        types[samples.index()], grid.size.x, grid.size.y, grid.size.z, vector_in_mm(m[0]),
        vector_in_mm(m[1]), vector_in_mm(m[2]), vector_in_mm(m[3]));
    out += bytes_of(samples);
    return out;
}

std::string write_nifti(const VoxelGrid& grid)
{
    constexpr int head_bytes = 352, largest = std::numeric_limits<std::int16_t>::max();
    constexpr std::int16_t types[] = {2, 256, 512, 4, 16}, bits[] = {8, 8, 16, 16, 32};
    std::string out(head_bytes, '\0');
    put(out, 0, std::int32_t{348});
    put(out, 40, std::int16_t{3});
    for (int k = 0; k < 3; ++k) {
        if (grid.size[k] > largest)
            throw Rejected(fmt::format("{} samples along an axis are too many for NIfTI-1, which "
                                       "has up to {}; write NRRD",
                                       grid.size[k], largest));
        const auto axis = static_cast<std::size_t>(k);
        put(out, 42 + 2 * axis, static_cast<std::int16_t>(grid.size[k]));
        put(out, 80 + 4 * axis,
            static_cast<float>(glm::length(glm::dvec3(grid.to_metres[k])) * millimetres_a_metre));
        for (int column = 0; column < 4; ++column) { // LPS to RAS
            const double value = grid.to_metres[column][k] * millimetres_a_metre;
            put(out, 280 + 16 * axis + 4 * static_cast<std::size_t>(column),
                static_cast<float>(k < 2 ? -value : value));
        }
    }
    put(out, 70, types[grid.samples.index()]);
    put(out, 72, bits[grid.samples.index()]);
    put(out, 108, static_cast<float>(head_bytes));
    put(out, 112, static_cast<float>(grid.slope));
    put(out, 116, static_cast<float>(grid.intercept));
    out[123] = 2;                   // millimetres
    put(out, 254, std::int16_t{1}); // the matrix is that of the scanner
    std::memcpy(out.data() + 344, "n+1", 4);
    out += bytes_of(grid.samples);
    return out;
}

} // namespace trivar
