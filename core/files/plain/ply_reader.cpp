// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/files/color.h"
#include "core/files/file_lines.h"
#include "core/files/file_sentences.h"
#include "core/files/formats.h"
#include "core/files/plain/ply_header.h"
#include "core/files/plain/ply_values.h"
#include "core/files/plain_text.h"
#include "core/mesh/split_vertices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <optional>
#include <set>
#include <utility>

namespace trivar {
namespace {

// The vertex of a corner whose number is below 0; no vertex has this number.
constexpr std::uint32_t no_vertex = ~0u;

bool is_corners(const PlyProperty& property)
{
    return property.list && (property.name == "vertex_indices" || property.name == "vertex_index");
}

class PlyReader {
public:
    PlyReader(const FileText& file, const Progress& progress)
        : file_(file),
          progress_(progress),
          header_(read_ply_header(file.bytes, file.name)),
          values_(file.bytes.substr(header_.size), header_.format, file.name)
    {
    }

    Model read()
    {
        std::set<std::string> seen;
        for (const PlyElement& element : header_.elements) {
            if (element.properties.empty()) continue;
            values_.check_count(element);
            if (element.name == "vertex" || element.name == "face" || element.name == "tristrips" ||
                element.name == "edge") {
                if (element.count > 0 && !seen.insert(element.name).second)
                    refuse(fmt::format("the element {} comes twice", element.name));
            }
            if (element.name == "vertex")
                read_vertices(element);
            else if (element.name == "face")
                read_faces(element);
            else if (element.name == "tristrips")
                read_strips(element);
            else if (element.name == "edge")
                read_edges(element);
            else
                skip(element);
        }
        if (!corner_uvs_.empty()) corner_uvs_.resize(mesh_.corners.size(), glm::vec2(0));
        const Curves curves = lines_.curves(mesh_.positions, mesh_.colors);
        leave_out_faces(curves.line_count() > 0);
        // Vertices that only edges use are not reported as damage.
        if (curves.line_count() > 0 && corner_uvs_.empty())
            mesh_ = without_loose_vertices(std::move(mesh_));
        if (!corner_uvs_.empty()) {
            mesh_.uvs.clear(); // those by corner are meant
            mesh_.uvs = {split_vertices(mesh_, corner_uvs_, glm::vec2(0))};
        }
        // The format marks a seam only by two vertices at one place.
        mesh_.points = points_by_position(mesh_.positions);
        say_what_was_left_out();
        // Vertex colours are used unchanged.
        std::vector<Material> materials{mesh_.colors.empty() ? unpainted() : Material()};
        Model model = single_mesh_model("", std::move(mesh_), std::move(materials));
        model.notices = std::move(notices_);
        if (curves.line_count() == 0) return model;
        model.curves = {make_ref(curves)};
        model.nodes.front().curves = 0;
        return model;
    }

private:
    void skip(const PlyElement& element)
    {
        for (std::size_t i = 0; i < element.count; ++i) {
            values_.begin(element, i);
            for (const PlyProperty& property : element.properties) values_.skip(property);
        }
    }

    // Returns the destination of a vertex property: x y z, normal, colour, u v.
    static std::optional<std::size_t> slot(const std::string& name)
    {
        static const std::pair<std::string_view, std::size_t> slots[] = {
            {"x", 0},          {"y", 1},   {"z", 2},     {"nx", 3},   {"ny", 4},
            {"nz", 5},         {"red", 6}, {"green", 7}, {"blue", 8}, {"alpha", 9},
            {"u", 10},         {"v", 11},  {"s", 10},    {"t", 11},   {"texture_u", 10},
            {"texture_v", 11}, {"r", 6},   {"g", 7},     {"b", 8},    {"a", 9}};
        for (const auto& [known, at] : slots)
            if (known == name) return at;
        return {};
    }

    void read_vertices(const PlyElement& element)
    {
        bool have[12]{};
        double scale[12]{};
        std::vector<std::optional<std::size_t>> slots;
        for (const PlyProperty& property : element.properties) {
            slots.push_back(property.list ? std::nullopt : slot(property.name));
            if (!slots.back()) continue;
            have[*slots.back()] = true;
            scale[*slots.back()] = property.type == PlyType::u8    ? 1 / 255.0
                                   : property.type == PlyType::u16 ? 1 / 65535.0
                                                                   : 1;
        }
        if (!have[0] || !have[1] || !have[2]) refuse("the vertices have no x, y and z");
        const bool normals = have[3] && have[4] && have[5], colors = have[6] && have[7] && have[8];
        const bool uvs = have[10] && have[11];
        if (uvs && mesh_.uvs.empty()) mesh_.uvs.emplace_back();
        for (std::size_t i = 0; i < element.count; ++i) {
            if (i % (1 << 16) == 0)
                report(progress_, 0.3 * double(i) / double(element.count), "Reading vertices");
            values_.begin(element, i);
            double v[12]{};
            v[9] = 1 / (have[9] ? scale[9] : 1);
            for (std::size_t p = 0; p < slots.size(); ++p) {
                const PlyProperty& property = element.properties[p];
                if (slots[p])
                    v[*slots[p]] = finite_value(property, *slots[p] < 3);
                else
                    values_.skip(property);
            }
            mesh_.positions.emplace_back(glm::dvec3(v[0], v[1], v[2]) - file_.origin);
            if (normals) mesh_.normals.emplace_back(v[3], v[4], v[5]);
            if (colors) mesh_.colors.push_back(color(v, scale));
            if (uvs) mesh_.uvs[0].emplace_back(v[10], v[11]);
        }
    }

    // Reads a number. NaN and values that do not fit a float become 0 if the mesh does not need
    // them.
    double finite_value(const PlyProperty& property, bool needed)
    {
        const double value = values_.value(property.type);
        if (std::abs(value) <= std::numeric_limits<float>::max()) return value;
        if (needed)
            values_.fail(fmt::format("its {} is '{}', which is not a number from -3.4e38 to 3.4e38",
                                     shown(property.name), values_.last()));
        ++bad_values_;
        return 0;
    }

    // Converts a colour: integers are sRGB, as scanners write them; fractions are linear.
    static glm::vec4 color(const double* v, const double* scale)
    {
        glm::vec4 rgba(v[6] * scale[6], v[7] * scale[7], v[8] * scale[8],
                       scale[9] > 0 ? v[9] * scale[9] : 1);
        rgba = glm::clamp(rgba, 0.0f, 1.0f);
        if (scale[6] < 1) rgba = glm::vec4(linear_from_srgb(glm::vec3(rgba)), rgba.w);
        return rgba;
    }

    void check_corners(const PlyElement& element)
    {
        if (std::ranges::none_of(element.properties, is_corners))
            refuse(fmt::format("the element {} has no list named vertex_indices", element.name));
    }

    void read_faces(const PlyElement& element)
    {
        check_corners(element);
        std::vector<float> uvs;
        for (std::size_t f = 0; f < element.count; ++f) {
            if (f % (1 << 16) == 0)
                report(progress_, 0.3 + 0.6 * double(f) / double(element.count), "Reading faces");
            values_.begin(element, f);
            for (const PlyProperty& property : element.properties) {
                if (is_corners(property)) {
                    for (std::size_t left = values_.list_length(property); left > 0; --left)
                        mesh_.corners.push_back(vertex(property.type).value_or(no_vertex));
                } else if (property.list && property.name == "texcoord") {
                    uvs = read_corner_uvs(property);
                } else {
                    texture_numbers_ |= property.name == "texnumber";
                    values_.skip(property);
                }
            }
            mesh_.face_begin.push_back(static_cast<std::uint32_t>(mesh_.corners.size()));
            if (!uvs.empty()) add_corner_uvs(std::exchange(uvs, {}));
        }
    }

    // Reads the number of a vertex; none if it is below 0.
    std::optional<std::uint32_t> vertex(PlyType type)
    {
        const double index = values_.value(type);
        if (!(std::abs(index) <= 4294967295.0) || index != std::floor(index))
            values_.fail(
                fmt::format("it has '{}' in place of the number of a vertex", values_.last()));
        if (index < 0 || index == 4294967295.0) return {};
        return static_cast<std::uint32_t>(index);
    }

    // Reads the "wedges" of MeshLab: u and v for each corner of the face.
    std::vector<float> read_corner_uvs(const PlyProperty& property)
    {
        std::vector<float> uvs(values_.list_length(property));
        for (float& each : uvs) each = static_cast<float>(finite_value(property, false));
        return uvs;
    }

    // Adds the coordinates of the corners of the last face; missing ones are 0, 0.
    void add_corner_uvs(const std::vector<float>& uvs)
    {
        const std::size_t first = mesh_.face_begin[mesh_.face_count() - 1];
        corner_uvs_.resize(mesh_.corners.size(), glm::vec2(0));
        if (uvs.size() != 2 * (mesh_.corners.size() - first)) {
            ++bad_uv_lists_;
            return;
        }
        for (std::size_t i = 0; i < uvs.size(); i += 2)
            corner_uvs_[first + i / 2] = {uvs[i], uvs[i + 1]};
    }

    // Reads triangle strips: three consecutive vertices are a triangle, every second one reversed;
    // a number below 0 begins another strip. A repeated vertex turns the strip and gives no
    // triangle.
    void read_strips(const PlyElement& element)
    {
        check_corners(element);
        for (std::size_t s = 0; s < element.count; ++s) {
            values_.begin(element, s);
            for (const PlyProperty& property : element.properties) {
                if (!is_corners(property)) {
                    values_.skip(property);
                    continue;
                }
                std::uint32_t a = 0, b = 0;
                std::size_t run = 0;
                for (std::size_t left = values_.list_length(property); left > 0; --left) {
                    const auto c = vertex(property.type);
                    run = c ? run + 1 : 0;
                    if (run >= 3 && a != b && b != *c && *c != a)
                        add_face(mesh_, run % 2 == 1 ? std::array{a, b, *c} : std::array{b, a, *c});
                    a = b;
                    b = c.value_or(0);
                }
            }
        }
    }

    // Reads edges between vertex1 and vertex2, which may be defined later.
    void read_edges(const PlyElement& element)
    {
        std::size_t vertices = 0;
        for (const PlyElement& each : header_.elements)
            if (each.name == "vertex") vertices = std::max(vertices, each.count);
        for (std::size_t e = 0; e < element.count; ++e) {
            values_.begin(element, e);
            std::array<std::optional<std::uint32_t>, 2> ends;
            for (const PlyProperty& property : element.properties) {
                const bool first = property.name == "vertex1";
                if (property.list || (!first && property.name != "vertex2"))
                    values_.skip(property);
                else
                    ends[first ? 0 : 1] = vertex(property.type);
            }
            if (std::ranges::all_of(ends, [&](auto v) { return v && *v < vertices; }))
                lines_.add_edge(*ends[0], *ends[1]);
            else
                ++bad_edges_;
        }
    }

    // Leaves out the faces that name a missing vertex.
    void leave_out_faces(bool has_lines)
    {
        const auto there = [&](std::uint32_t v) { return v < mesh_.vertex_count(); };
        if (std::ranges::all_of(mesh_.corners, there)) return;
        std::vector<std::uint32_t> corners, begin{0};
        std::vector<glm::vec2> uvs;
        std::size_t first_gone = mesh_.face_count(), gone = 0;
        for (std::size_t f = 0; f < mesh_.face_count(); ++f) {
            const auto from = mesh_.corners.begin() + mesh_.face_begin[f],
                       to = mesh_.corners.begin() + mesh_.face_begin[f + 1];
            if (!std::all_of(from, to, there)) {
                if (gone++ == 0) first_gone = f;
                continue;
            }
            corners.insert(corners.end(), from, to);
            begin.push_back(static_cast<std::uint32_t>(corners.size()));
            if (!corner_uvs_.empty())
                uvs.insert(uvs.end(), corner_uvs_.begin() + mesh_.face_begin[f],
                           corner_uvs_.begin() + mesh_.face_begin[f + 1]);
        }
        const std::string first = fmt::format("face {}, counted from 0", first_gone);
        if (corners.empty() && !has_lines) refuse(no_whole_face(first, mesh_.vertex_count()));
        say(faces_left_out(gone, first, mesh_.vertex_count()));
        mesh_.corners = std::move(corners);
        mesh_.face_begin = std::move(begin);
        corner_uvs_ = std::move(uvs);
    }

    void say_what_was_left_out()
    {
        if (bad_values_ > 0)
            say(fmt::format("{} no number from -3.4e38 to 3.4e38 and became 0",
                            counted(bad_values_, "normal, colour or texture coordinate was",
                                    "normals, colours or texture coordinates were")));
        if (bad_uv_lists_ > 0)
            say(fmt::format(
                "{} left out; they should have two numbers for each corner of the face",
                counted(bad_uv_lists_, "list of texcoord was", "lists of texcoord were")));
        if (bad_edges_ > 0)
            say(fmt::format("{} a vertex that is not there and {} left out",
                            counted(bad_edges_, "edge names", "edges name"),
                            bad_edges_ == 1 ? "was" : "were"));
        if (lines_.without_room() > 0) say(lines_without_room(lines_.without_room()));
        NameList pictures;
        for (const std::string& name : header_.pictures) pictures.add(name);
        if (pictures.count() > 0)
            say(fmt::format("the header names {} left out: {}; OBJ and glTF bring their pictures",
                            counted(pictures.count(), "picture that was", "pictures that were"),
                            pictures.text()));
        else if (texture_numbers_)
            say("the numbers of its faces' pictures (texnumber) were left out; it names no "
                "picture");
    }

    void say(const std::string& what)
    {
        notices_.push_back(fmt::format("{}: {}", file_.name, what));
    }
    [[noreturn]] void refuse(const std::string& what) const
    {
        throw Rejected(fmt::format("{}: {}", file_.name, what));
    }

    const FileText& file_;
    const Progress& progress_;
    PlyHeader header_;
    PlyValues values_;
    Mesh mesh_;
    std::vector<glm::vec2> corner_uvs_; // #C, or empty: none
    std::vector<std::string> notices_;
    bool texture_numbers_ = false;
    FileLines lines_; // of the edges
    std::size_t bad_values_ = 0, bad_uv_lists_ = 0, bad_edges_ = 0;
};

} // namespace

Model read_ply(const FileText& file, const Progress& progress)
{
    refuse_wide_text(file.bytes, file.name);
    FileText unmarked = file;
    unmarked.bytes = without_mark(file.bytes);
    return PlyReader(unmarked, progress).read();
}

} // namespace trivar
