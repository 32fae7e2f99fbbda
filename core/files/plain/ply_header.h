// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace trivar {

enum class PlyType { i8, u8, i16, u16, i32, u32, f32, f64 };
std::size_t size_of(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type;
    bool list = false;
    PlyType count_type = PlyType::u8; // of a list's length
};

struct PlyElement {
    std::string name;
    std::size_t count;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    enum class Format { ascii, little_endian, big_endian } format;
    std::vector<PlyElement> elements;
    std::vector<std::string> pictures; // that comments name, as MeshLab does
    std::size_t size;                  // bytes up to the data
};

// Throws Rejected, with `name` in the sentence.
PlyHeader read_ply_header(std::string_view bytes, const std::string& name);

} // namespace trivar
