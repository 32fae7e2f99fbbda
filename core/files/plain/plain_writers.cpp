// SPDX-License-Identifier: GPL-3.0-or-later
// This file writes the formats of one mesh without materials: PLY, STL, OFF.
#include "core/files/color.h"
#include "core/files/flattened.h"
#include "core/files/formats.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <fmt/format.h>

namespace trivar {
namespace {

static_assert(std::endian::native == std::endian::little);

template <class T> void put(std::string& out, const T& value)
{
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    out.append(bytes, sizeof(T));
}

std::uint8_t to_byte(float value)
{
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255));
}

} // namespace

std::string write_ply(const Model& model)
{
    const glm::dvec3 origin = far_origin(model);
    const bool far = origin != glm::dvec3(0);
    const Mesh mesh = flattened(model, origin);
    std::size_t longest = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        longest = std::max<std::size_t>(longest, mesh.face_begin[f + 1] - mesh.face_begin[f]);
    std::string out = "ply\nformat binary_little_endian 1.0\ncomment Trivar\n";
    out += fmt::format("element vertex {}\n", mesh.vertex_count());
    for (const char* name : {"x", "y", "z"})
        out += fmt::format("property {} {}\n", far ? "double" : "float", name);
    for (const char* name : {"nx", "ny", "nz"}) out += fmt::format("property float {}\n", name);
    if (!mesh.uvs.empty()) out += "property float s\nproperty float t\n";
    if (!mesh.colors.empty())
        for (const char* name : {"red", "green", "blue", "alpha"})
            out += fmt::format("property uchar {}\n", name);
    out += fmt::format("element face {}\nproperty list {} uint vertex_indices\nend_header\n",
                       mesh.face_count(), longest < 256 ? "uchar" : "uint");
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        if (far)
            put(out, origin + glm::dvec3(mesh.positions[v]));
        else
            put(out, mesh.positions[v]);
        put(out, mesh.normals[v]);
        if (!mesh.uvs.empty()) put(out, mesh.uvs[0][v]);
        if (!mesh.colors.empty()) {
            const glm::vec3 display =
                srgb_from_linear(glm::clamp(glm::vec3(mesh.colors[v]), 0.0f, 1.0f));
            for (int i = 0; i < 3; ++i) put(out, to_byte(display[i]));
            put(out, to_byte(mesh.colors[v].w));
        }
    }
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const std::uint32_t begin = mesh.face_begin[f], end = mesh.face_begin[f + 1];
        if (longest < 256)
            put(out, static_cast<std::uint8_t>(end - begin));
        else
            put(out, end - begin);
        for (std::uint32_t c = begin; c < end; ++c) put(out, mesh.corners[c]);
    }
    return out;
}

std::string write_stl(const Model& model)
{
    const Mesh mesh = flattened(model);
    const std::vector<glm::uvec3> all = triangles(mesh);
    std::string out = "binary STL written by Trivar";
    out.resize(80, ' ');
    put(out, static_cast<std::uint32_t>(all.size()));
    for (const glm::uvec3& t : all) {
        const glm::vec3 a = mesh.positions[t.x], b = mesh.positions[t.y], c = mesh.positions[t.z];
        const glm::dvec3 normal =
            glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
        const double length = glm::length(normal);
        put(out, length > 0 ? glm::vec3(normal / length) : glm::vec3(0));
        for (const glm::vec3& p : {a, b, c}) put(out, p);
        put(out, std::uint16_t{0});
    }
    return out;
}

std::string write_off(const Model& model)
{
    const glm::dvec3 origin = far_origin(model);
    const Mesh mesh = flattened(model, origin);
    // Without normals and the like nothing tells two vertices at one place apart.
    const std::vector<std::uint32_t> points = points_by_position(mesh.positions);
    std::vector<glm::vec3> places;
    for (std::size_t v = 0; v < points.size(); ++v)
        if (points[v] == places.size()) places.push_back(mesh.positions[v]);
    fmt::memory_buffer out;
    const auto to = std::back_inserter(out);
    fmt::format_to(to, "OFF\n{} {} 0\n", places.size(), mesh.face_count());
    for (const glm::vec3& p : places) {
        add_place(out, p, origin);
        out.push_back('\n');
    }
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const std::uint32_t begin = mesh.face_begin[f], end = mesh.face_begin[f + 1];
        fmt::format_to(to, "{}", end - begin);
        for (std::uint32_t c = begin; c < end; ++c)
            fmt::format_to(to, " {}", points[mesh.corners[c]]);
        fmt::format_to(to, "\n");
    }
    return fmt::to_string(out);
}

} // namespace trivar
