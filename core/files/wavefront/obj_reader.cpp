// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/files/color.h"
#include "core/files/file_sentences.h"
#include "core/files/formats.h"
#include "core/files/plain_text.h"
#include "core/files/wavefront/obj_blocks.h"
#include "core/files/wavefront/obj_lines.h"
#include "core/files/wavefront/obj_statements.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

constexpr std::size_t block_bytes = 1 << 20;

// Splits the text into blocks of whole lines of about block_bytes each.
std::vector<std::string_view> split(std::string_view text)
{
    std::vector<std::string_view> parts;
    while (!text.empty()) {
        std::size_t end = text.size();
        if (end > block_bytes) {
            const std::size_t line_end = text.find('\n', block_bytes);
            if (line_end != text.npos) end = line_end + 1;
        }
        parts.push_back(text.substr(0, end));
        text.remove_prefix(end);
    }
    return parts;
}

std::vector<ObjBlock> read_blocks(const std::vector<std::string_view>& parts,
                                  const PlainText& plain, const FileText& file,
                                  const Progress& progress)
{
    std::vector<ObjBlock> blocks(parts.size());
    const std::size_t batch = 16;
    for (std::size_t first = 0; first < parts.size(); first += batch) {
        report(progress, 0.7 * double(first) / double(parts.size()), "Reading");
        const std::size_t count = std::min(batch, parts.size() - first);
        parallel_blocks(count, 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                blocks[first + i] = read_obj_block(parts[first + i], file.origin);
        });
        for (std::size_t i = first; i < first + count; ++i)
            if (const ObjBlock::Trouble& error = blocks[i].error; error.at)
                throw Rejected(
                    fmt::format("{}: line {}: {}", file.name, plain.line_of(error.at), error.what));
    }
    return blocks;
}

template <class T>
std::vector<T> joined(std::vector<ObjBlock>& blocks, std::vector<T> ObjBlock::*member)
{
    std::size_t size = 0;
    for (const ObjBlock& block : blocks) size += (block.*member).size();
    std::vector<T> all;
    all.reserve(size);
    for (ObjBlock& block : blocks) {
        all.insert(all.end(), (block.*member).begin(), (block.*member).end());
        (block.*member) = {};
    }
    return all;
}

void fill_attributes(Mesh& mesh, const ObjVertices& vertices, const std::vector<glm::vec3>& v,
                     const std::vector<glm::vec3>& colors, const std::vector<glm::vec2>& vt,
                     const std::vector<glm::vec3>& vn)
{
    const std::size_t count = vertices.of.size();
    const auto any = [&](std::int32_t ObjCorner::*index) {
        return std::any_of(vertices.of.begin(), vertices.of.end(),
                           [&](const ObjCorner& c) { return c.*index >= 0; });
    };
    mesh.positions.resize(count);
    mesh.points.resize(count);
    if (any(&ObjCorner::vt)) mesh.uvs.emplace_back(count, glm::vec2(0));
    // (0, 0, 0) means that the file gives no normal here.
    if (any(&ObjCorner::vn)) mesh.normals.assign(count, glm::vec3(0));
    if (!colors.empty()) mesh.colors.resize(count);
    std::uint32_t point = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const ObjCorner& c = vertices.of[i];
        const auto at = static_cast<std::size_t>(c.v);
        if (i > 0 && vertices.of[i - 1].v != c.v) ++point;
        mesh.points[i] = point;
        mesh.positions[i] = v[at];
        if (c.vt >= 0) mesh.uvs[0][i] = vt[static_cast<std::size_t>(c.vt)];
        if (c.vn >= 0) mesh.normals[i] = vn[static_cast<std::size_t>(c.vn)];
        if (!colors.empty()) mesh.colors[i] = glm::vec4(linear_from_srgb(colors[at]), 1);
    }
}

std::vector<glm::vec4> linear_colors(const std::vector<glm::vec3>& colors)
{
    std::vector<glm::vec4> out;
    for (const glm::vec3& color : colors) out.emplace_back(linear_from_srgb(color), 1);
    return out;
}

// ObjNotices counts the statements and parts of faces that were left out.
class ObjNotices {
public:
    ObjNotices(const std::vector<ObjBlock>& blocks, const std::vector<std::string_view>& parts,
               const PlainText& plain, const FileText& file)
        : blocks_(blocks),
          parts_(parts),
          plain_(plain),
          file_(file)
    {
    }

    std::vector<std::string> of(const ObjFaces& faces, const ObjLines& lines, std::size_t v_count)
    {
        if (faces.left_out.count > 0) {
            const std::string first = line(faces.left_out);
            if (faces.begin.size() == 1 && lines.lines.count() == 0)
                throw Rejected(file_.name + ": " + no_whole_face(first, v_count));
            say("{}", faces_left_out(faces.left_out.count, first, v_count));
        }
        if (faces.details.count > 0)
            say("{} a vt or vn that is not there and {} read without it (the first: {})",
                counted(faces.details.count, "corner of a face names", "corners of faces name"),
                faces.details.count == 1 ? "was" : "were", line(faces.details));
        tell_of_lines(lines);
        std::size_t bad = 0, points = 0, free_forms = 0;
        const ObjBlock::Trouble* first_bad = nullptr;
        for (const ObjBlock& block : blocks_) {
            if (bad == 0 && block.bad_lines > 0) first_bad = &block.first_bad;
            bad += block.bad_lines;
            points += block.points;
            free_forms += block.free_forms;
        }
        if (bad > 0)
            say("{} left out; on line {}, {}",
                counted(bad, "normal or texture coordinate was",
                        "normals and texture coordinates were"),
                plain_.line_of(first_bad->at), first_bad->what);
        if (points > 0)
            say("{} left out", counted(points, "point element was", "point elements were"));
        if (free_forms > 0)
            say("{} left out", counted(free_forms, "free-form curve or surface was",
                                       "free-form curves and surfaces were"));
        return std::move(notices_);
    }

private:
    void tell_of_lines(const ObjLines& lines)
    {
        const ObjAbsent& gone = lines.left_out;
        if (gone.count > 0)
            say("{} left out, for {} fewer than two vertices or one that is not there (the first: "
                "line {})",
                counted(gone.count, "line was", "lines were"),
                gone.count == 1 ? "it names" : "they name",
                plain_.line_of(line_of_line(parts_[gone.block], gone.face)));
        if (lines.lines.without_room() > 0)
            say("{}", lines_without_room(lines.lines.without_room()));
    }

    std::string line(const ObjAbsent& absent) const
    {
        return fmt::format("line {}",
                           plain_.line_of(line_of_face(parts_[absent.block], absent.face)));
    }

    template <class... T> void say(fmt::format_string<T...> what, T&&... values)
    {
        notices_.push_back(file_.name + ": " + fmt::format(what, std::forward<T>(values)...));
    }

    const std::vector<ObjBlock>& blocks_;
    const std::vector<std::string_view>& parts_;
    const PlainText& plain_;
    const FileText& file_;
    std::vector<std::string> notices_;
};

} // namespace

ObjModel read_obj(const FileText& file, const Progress& progress)
{
    PlainText plain(file.bytes, file.name);
    plain.join_lines();
    const std::vector<std::string_view> parts = split(plain.view());
    std::vector<ObjBlock> blocks = read_blocks(parts, plain, file, progress);

    report(progress, 0.7, "Joining vertices");
    if (std::ranges::any_of(blocks, [](const ObjBlock& b) { return !b.colors.empty(); }))
        for (ObjBlock& block : blocks) block.colors.resize(block.v.size(), glm::vec3(1));
    const auto v = joined(blocks, &ObjBlock::v), vn = joined(blocks, &ObjBlock::vn),
               colors = joined(blocks, &ObjBlock::colors);
    const auto vt = joined(blocks, &ObjBlock::vt);
    ObjFaces faces = faces_of(blocks, v.size(), vt, vn);
    const ObjLines lines = lines_of(blocks, v.size());

    if (faces.begin.size() == 1 && faces.left_out.count == 0 && lines.lines.count() == 0 &&
        lines.left_out.count == 0 && !v.empty())
        throw Rejected(points_alone(file.name));
    Model model;
    model.notices = ObjNotices(blocks, parts, plain, file).of(faces, lines, v.size());
    Mesh mesh;
    mesh.face_begin = std::move(faces.begin);
    ObjVertices vertices = unified(faces.corners, v.size());
    fill_attributes(mesh, vertices, v, colors, vt, vn);
    mesh.corners = std::move(vertices.corners);

    report(progress, 0.85, "Reading materials");
    ObjAttributes attributes =
        add_obj_statements(model, mesh, blocks, vertices.first_of, file, plain);
    model.meshes = {make_ref(std::move(mesh))};
    model.nodes = {Node{"", -1, glm::dmat4(1), 0}};
    if (lines.lines.count() == 0) return {std::move(model), std::move(attributes.smoothing)};
    Curves curves = lines.lines.curves(v, linear_colors(colors));
    curves.material = std::move(attributes.line_material);
    model.curves = {make_ref(std::move(curves))};
    model.nodes.front().curves = 0;
    return {std::move(model), std::move(attributes.smoothing)};
}

} // namespace trivar
