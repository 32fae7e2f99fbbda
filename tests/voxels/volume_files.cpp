// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/voxels/volume_files.h"

#include "tests/voxels/volume_writers.h"

#include <algorithm>
#include <bzlib.h>
#include <cstring>
#include <fmt/format.h>
#include <zlib.h>

namespace trivar::testing {
namespace {

template <class T> std::string as_bytes(T value)
{
    return {reinterpret_cast<const char*>(&value), sizeof(T)};
}

std::string deflated(std::string_view bytes, int window)
{
    z_stream stream{};
    deflateInit2(&stream, 9, Z_DEFLATED, window, 8, Z_DEFAULT_STRATEGY);
    std::string out(bytes.size() + 1000, '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = static_cast<uInt>(out.size());
    deflate(&stream, Z_FINISH);
    out.resize(stream.total_out);
    deflateEnd(&stream);
    return out;
}

} // namespace

VoxelGrid small_volume()
{
    VoxelGrid grid;
    grid.size = {5, 4, 3};
    std::vector<std::int16_t> samples;
    for (int i = 0; i < 60; ++i) samples.push_back(static_cast<std::int16_t>(i * 37 % 64));
    grid.samples = samples;
    const double c = std::cos(0.3), s = std::sin(0.3);
    grid.to_metres = {{0.0007, 0, 0, 0},
                      {0, 0.0008 * c, 0.0008 * s, 0},
                      {0, -0.00125 * s, 0.00125 * c, 0},
                      {0.01, -0.02, 0.03, 1}};
    return grid;
}

template <class T> std::string packed(const VoxelGrid& grid, bool big_endian)
{
    std::string out;
    for (const std::int16_t sample : std::get<std::vector<std::int16_t>>(grid.samples)) {
        std::string bytes = as_bytes(static_cast<T>(sample));
        if (big_endian) std::ranges::reverse(bytes);
        out += bytes;
    }
    return out;
}
template std::string packed<std::uint8_t>(const VoxelGrid&, bool);
template std::string packed<std::int16_t>(const VoxelGrid&, bool);
template std::string packed<std::int32_t>(const VoxelGrid&, bool);
template std::string packed<float>(const VoxelGrid&, bool);
template std::string packed<double>(const VoxelGrid&, bool);

std::string gzipped(std::string_view bytes)
{
    return deflated(bytes, 15 + 16);
}

std::string zlib_packed(std::string_view bytes)
{
    return deflated(bytes, 15);
}

std::string bzip2_packed(std::string_view bytes)
{
    std::string out(bytes.size() + 1000, '\0');
    auto size = static_cast<unsigned>(out.size());
    BZ2_bzBuffToBuffCompress(out.data(), &size, const_cast<char*>(bytes.data()),
                             static_cast<unsigned>(bytes.size()), 9, 0, 0);
    out.resize(size);
    return out;
}

std::string in_base64(std::string_view bytes)
{
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        for (std::size_t k = 0; k < 3; ++k)
            bits = bits << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            out += k <= count ? digits[bits >> (18 - 6 * k) & 63] : '=';
    }
    return out;
}

std::string in_words(const VoxelGrid& grid)
{
    std::string out;
    for (const std::int16_t sample : std::get<std::vector<std::int16_t>>(grid.samples))
        out += std::to_string(sample) + (out.size() % 50 > 40 ? "\n" : " ");
    return out;
}

std::string vti_file(VtiKind kind)
{
    const VoxelGrid grid = small_volume();
    const std::string data = packed<std::int16_t>(grid);
    const bool blocks = kind == VtiKind::binary_packed || kind == VtiKind::raw_packed ||
                        kind == VtiKind::base64_packed;
    // Blocks of 50 bytes, the last one of 20.
    std::string counts = as_bytes(std::uint32_t{3}) + as_bytes(std::uint32_t{50}) +
                         as_bytes(std::uint32_t{20}),
                body;
    for (std::size_t at = 0; at < data.size(); at += 50) {
        const std::string block = zlib_packed(std::string_view(data).substr(at, 50));
        counts += as_bytes(static_cast<std::uint32_t>(block.size()));
        body += block;
    }
    if (!blocks) {
        counts = as_bytes(static_cast<std::uint32_t>(data.size()));
        body = data;
    }
    const bool base64 =
        kind == VtiKind::binary || kind == VtiKind::binary_packed || kind == VtiKind::base64_packed;
    std::string all = counts + body;
    if (base64) all = blocks ? in_base64(counts) + in_base64(body) : in_base64(all);
    if (kind == VtiKind::ascii) all = in_words(grid);
    const bool appended =
        kind == VtiKind::raw || kind == VtiKind::raw_packed || kind == VtiKind::base64_packed;
    return fmt::format(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"0.1\" "
        "byte_order=\"LittleEndian\"{}>\n<ImageData WholeExtent=\"0 4 0 3 0 2\" Origin=\"10 -20 "
        "30\" Spacing=\"0.7 0.8 1.25\">\n<Piece Extent=\"0 4 0 3 0 2\">\n<PointData "
        "Scalars=\"density\">\n<DataArray type=\"Int16\" Name=\"density\" format=\"{}\"{}>\n{}"
        "</DataArray>\n</PointData>\n</Piece>\n</ImageData>\n{}</VTKFile>\n",
        blocks ? " compressor=\"vtkZLibDataCompressor\"" : "",
        appended                 ? "appended"
        : kind == VtiKind::ascii ? "ascii"
                                 : "binary",
        appended ? " offset=\"0\"" : "", appended ? "" : all + "\n",
        appended ? fmt::format("<AppendedData encoding=\"{}\">\n_{}\n</AppendedData>\n",
                               base64 ? "base64" : "raw", all)
                 : "");
}

std::string vtk_file(bool binary)
{
    const VoxelGrid grid = small_volume();
    return fmt::format("# vtk DataFile Version 3.0\nsmall\n{}\nDATASET STRUCTURED_POINTS\n"
                       "DIMENSIONS 5 4 3\nSPACING 0.7 0.8 1.25\nORIGIN 10 -20 30\nPOINT_DATA 60\n"
                       "SCALARS density short 1\nLOOKUP_TABLE default\n{}\n",
                       binary ? "BINARY" : "ASCII",
                       binary ? packed<std::int16_t>(grid, true) : in_words(grid));
}

std::string meta_file(bool packed_by_zlib)
{
    const std::string data = packed<std::int16_t>(small_volume());
    return fmt::format(
        "ObjectType = Image\nNDims = 3\nBinaryData = True\n"
        "BinaryDataByteOrderMSB = False\nCompressedData = {}\nOffset = 10 -20 30\n"
        "TransformMatrix = 1 0 0 0 0.6 0.8 0 -0.8 0.6\nElementSpacing = 0.7 0.8 "
        "1.25\nDimSize = 5 4 3\nElementType = MET_SHORT\nElementDataFile = LOCAL\n{}",
        packed_by_zlib ? "True" : "False", packed_by_zlib ? zlib_packed(data) : data);
}

std::vector<NamedBytes> sound_volumes()
{
    const VoxelGrid grid = small_volume();
    const std::string data = packed<std::int16_t>(grid);
    const auto nrrd = [](const std::string& encoding, const std::string& bytes) {
        return "NRRD0004\ntype: short\ndimension: 3\nspace: left-posterior-superior\nsizes: 5 4 3\n"
               "space directions: (0.7,0,0) (0,0.8,0) (0,0,1.25)\nkinds: domain domain domain\n"
               "endian: little\nspace origin: (10,-20,30)\nencoding: " +
               encoding + "\n\n" + bytes;
    };
    return {{"raw.nrrd", write_nrrd(grid)},
            {"gzip.nrrd", nrrd("gzip", gzipped(data))},
            {"bzip2.nrrd", nrrd("bzip2", bzip2_packed(data))},
            {"ascii.nrrd", nrrd("ascii", in_words(grid))},
            {"plain.nii", write_nifti(grid)},
            {"packed.nii.gz", gzipped(write_nifti(grid))},
            {"raw.mha", meta_file(false)},
            {"packed.mha", meta_file(true)},
            {"ascii.vtk", vtk_file(false)},
            {"binary.vtk", vtk_file(true)},
            {"ascii.vti", vti_file(VtiKind::ascii)},
            {"binary.vti", vti_file(VtiKind::binary)},
            {"binary_packed.vti", vti_file(VtiKind::binary_packed)},
            {"raw.vti", vti_file(VtiKind::raw)},
            {"raw_packed.vti", vti_file(VtiKind::raw_packed)},
            {"base64_packed.vti", vti_file(VtiKind::base64_packed)}};
}

} // namespace trivar::testing
