// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/files/formats.h"
#include "core/files/text_scan.h"

#include <cstring>
#include <fmt/format.h>

namespace trivar {
namespace {

constexpr std::size_t header_bytes = 84, triangle_bytes = 50;

std::vector<glm::vec3> read_binary(const FileText& file, std::uint32_t count)
{
    std::vector<glm::vec3> corners(std::size_t{3} * count);
    for (std::size_t t = 0; t < count; ++t) {
        float values[9];
        // The stored normal comes first; it follows from the corners and is often wrong.
        std::memcpy(values, file.bytes.data() + header_bytes + t * triangle_bytes + 12,
                    sizeof values);
        for (std::size_t c = 0; c < 3; ++c) {
            const glm::vec3 p(values[3 * c], values[3 * c + 1], values[3 * c + 2]);
            if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
                throw Rejected(fmt::format("{}: triangle {} has a coordinate that is no finite "
                                           "number",
                                           file.name, t));
            corners[3 * t + c] = p;
        }
    }
    return corners;
}

std::vector<glm::vec3> read_text(const FileText& file)
{
    std::vector<glm::vec3> corners;
    TextScan scan(file.bytes);
    int line = 0;
    std::size_t in_facet = 0;
    while (!scan.done()) {
        ++line;
        const std::string_view keyword = scan.word();
        if (keyword == "facet") in_facet = 0;
        if (keyword == "endfacet" && in_facet != 3)
            throw Rejected(
                fmt::format("{}: line {}: a facet has {} corners", file.name, line, in_facet));
        if (keyword == "vertex") {
            glm::vec3 p;
            for (int i = 0; i < 3; ++i) {
                const auto value = scan.number();
                if (!value)
                    throw Rejected(fmt::format("{}: line {}: coordinate {} is missing or is no "
                                               "finite number",
                                               file.name, line, i + 1));
                p[i] = static_cast<float>(*value);
            }
            if (++in_facet > 3)
                throw Rejected(
                    fmt::format("{}: line {}: a facet has more than 3 corners", file.name, line));
            corners.push_back(p);
        }
        scan.line();
    }
    if (corners.size() % 3 != 0)
        throw Rejected(fmt::format("{}: the last facet is cut off", file.name));
    return corners;
}

} // namespace

Model read_stl(const FileText& file, const Progress& progress)
{
    report(progress, 0, "Reading");
    std::uint32_t count = 0;
    if (file.bytes.size() >= header_bytes) std::memcpy(&count, file.bytes.data() + 80, 4);
    const std::size_t expected = header_bytes + triangle_bytes * std::size_t{count};
    // Binary files may begin with "solid" too: the size decides.
    const bool exact = file.bytes.size() >= header_bytes && file.bytes.size() == expected;
    TextScan scan(file.bytes);
    const bool text = !exact && scan.word() == "solid";
    if (!exact && !text && (file.bytes.size() < header_bytes || file.bytes.size() < expected))
        throw Rejected(
            fmt::format("{}: neither text that begins with 'solid' nor the {} bytes that "
                        "{} triangles take",
                        file.name, expected, count));
    const std::vector<glm::vec3> corners = text ? read_text(file) : read_binary(file, count);

    report(progress, 0.6, "Joining vertices");
    const std::vector<std::uint32_t> points = points_by_position(corners);
    Mesh mesh;
    for (std::size_t c = 0; c < corners.size(); ++c)
        if (points[c] == mesh.positions.size()) mesh.positions.push_back(corners[c]);
    mesh.corners = points;
    for (std::size_t c = 3; c <= corners.size(); c += 3)
        mesh.face_begin.push_back(static_cast<std::uint32_t>(c));
    return single_mesh_model("", std::move(mesh));
}

} // namespace trivar
