// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/finite.h"
#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/files/file_sentences.h"
#include "core/files/formats.h"
#include "core/files/plain_text.h"
#include "core/files/text_scan.h"

#include <algorithm>
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
        // The stored normal comes first. It is skipped: it follows from the corners and is often
        // wrong.
        std::memcpy(values, file.bytes.data() + header_bytes + t * triangle_bytes + 12,
                    sizeof values);
        for (std::size_t c = 0; c < 3; ++c) {
            const glm::dvec3 p(values[3 * c], values[3 * c + 1], values[3 * c + 2]);
            if (!finite(p))
                throw Rejected(fmt::format(
                    "{}: triangle {} of {}, counted from 0: a coordinate is not a finite number",
                    file.name, t, with_commas(count)));
            corners[3 * t + c] = glm::vec3(p - file.origin);
        }
    }
    return corners;
}

// Compares a keyword, which may be in small letters or in capitals.
bool is_keyword(std::string_view word, std::string_view keyword)
{
    const auto same = [](char a, char b) {
        return a == b || (a >= 'A' && a <= 'Z' && a + 32 == b);
    };
    return std::ranges::equal(word, keyword, same);
}

// Says whether the file is text. Binary files may begin with "solid" too, but the size after
// their header has a byte 0.
bool is_text(std::string_view bytes)
{
    TextScan scan(without_mark(bytes));
    while (!scan.done() && (is_blank(*scan.at) || *scan.at == '\n')) ++scan.at;
    return is_keyword(scan.word(), "solid") &&
           bytes.substr(0, header_bytes).find('\0') == bytes.npos;
}

std::vector<glm::vec3> read_text(const FileText& file)
{
    const PlainText plain(file.bytes, file.name);
    std::vector<glm::vec3> corners;
    TextScan scan(plain.view());
    int line = 0;
    const auto fail = [&](const std::string& what) {
        throw Rejected(fmt::format("{}: line {}: {}", file.name, line, what));
    };
    std::size_t in_facet = 0;
    while (!scan.done()) {
        ++line;
        const std::string_view keyword = scan.word();
        if (is_keyword(keyword, "facet")) in_facet = 0;
        if (is_keyword(keyword, "endfacet") && in_facet != 3)
            fail(fmt::format("a facet has {} corners instead of 3", in_facet));
        if (is_keyword(keyword, "vertex")) {
            glm::dvec3 p;
            for (int i = 0; i < 3; ++i) {
                const auto value = scan.number();
                if (!value)
                    fail(fmt::format("the {} of a vertex {}", "xyz"[i], not_a_number(scan)));
                p[i] = *value;
            }
            if (++in_facet > 3) fail("a facet has more than 3 corners");
            corners.emplace_back(p - file.origin);
        }
        scan.line();
    }
    if (corners.size() % 3 != 0) fail("the file ends in a facet");
    return corners;
}

} // namespace

Model read_stl(const FileText& file, const Progress& progress)
{
    report(progress, 0, "Reading");
    std::uint32_t count = 0;
    if (file.bytes.size() >= header_bytes) std::memcpy(&count, file.bytes.data() + 80, 4);
    const std::size_t expected = header_bytes + triangle_bytes * std::size_t{count};
    const bool exact = file.bytes.size() >= header_bytes && file.bytes.size() == expected;
    const bool text = !exact && is_text(file.bytes);
    if (!exact && !text) refuse_wide_text(file.bytes, file.name);
    if (!exact && !text && (file.bytes.size() < header_bytes || file.bytes.size() < expected))
        throw Rejected(fmt::format(
            "{}: this is not an STL file, or it is cut off: it does not begin with 'solid', and a "
            "binary file needs more than its {} bytes: {}",
            file.name, with_commas(file.bytes.size()),
            file.bytes.size() < header_bytes
                ? fmt::format("{} for its header", header_bytes)
                : fmt::format("{} for the {} triangles that it declares", with_commas(expected),
                              with_commas(count))));
    const std::vector<glm::vec3> corners = text ? read_text(file) : read_binary(file, count);

    report(progress, 0.6, "Joining vertices");
    std::vector<std::uint32_t> points = points_by_position(corners);
    Mesh mesh;
    for (std::size_t c = 0; c < corners.size(); ++c)
        if (points[c] == mesh.positions.size()) mesh.positions.push_back(corners[c]);
    mesh.corners = std::move(points);
    mesh.face_begin.reserve(corners.size() / 3 + 1);
    for (std::size_t c = 3; c <= corners.size(); c += 3)
        mesh.face_begin.push_back(static_cast<std::uint32_t>(c));
    Model model = single_mesh_model("", std::move(mesh), {unpainted()});
    if (!text && !exact)
        model.notices.push_back(
            fmt::format("{}: {} left out", file.name,
                        counted(file.bytes.size() - expected, "byte behind its last triangle was",
                                "bytes behind its last triangle were")));
    return model;
}

} // namespace trivar
