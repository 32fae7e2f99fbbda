// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/files/file_sentences.h"
#include "core/files/formats.h"
#include "core/files/plain_text.h"
#include "core/files/text_scan.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

class OffReader {
public:
    OffReader(const FileText& file, const Progress& progress)
        : file_(file),
          progress_(progress),
          plain_(file.bytes, file.name),
          scan_(plain_.view())
    {
    }

    Model read()
    {
        read_header();
        const std::size_t vertices = count("number of vertices");
        const bool one_line = !at_line_end();
        const std::size_t faces = count("number of faces");
        // The number of edges is not needed, and some files omit it.
        if (!one_line || !at_line_end()) count("number of edges");
        // A number and a blank take two bytes, so more elements than this cannot be in the file.
        if (vertices * 6 + faces * 2 > file_.bytes.size() + 2)
            fail(fmt::format(
                "{} vertices and {} faces are declared, which is more than {} bytes can hold",
                with_commas(vertices), with_commas(faces), with_commas(file_.bytes.size())));
        read_vertices(vertices);
        for (std::size_t f = 0; f < faces; ++f) {
            if (f % (1 << 16) == 0)
                report(progress_, 0.3 + 0.6 * double(f) / double(faces), "Reading faces");
            read_face();
        }
        const std::string first = fmt::format("line {}", first_left_out_);
        if (left_out_ > 0 && mesh_.face_count() == 0)
            throw Rejected(file_.name + ": " + no_whole_face(first, vertices));
        // Seams and duplicate vertices look alike in this format; both are closed.
        mesh_.points = points_by_position(mesh_.positions);
        // Vertex colours are used unchanged.
        std::vector<Material> materials{mesh_.colors.empty() ? unpainted() : Material()};
        Model model = single_mesh_model("", std::move(mesh_), std::move(materials));
        if (left_out_ > 0)
            model.notices.push_back(file_.name + ": " + faces_left_out(left_out_, first, vertices));
        if (face_colors_)
            model.notices.push_back(file_.name + ": the colours of faces were left out");
        return model;
    }

private:
    void read_header()
    {
        skip();
        std::string_view keyword = scan_.word();
        if (keyword.starts_with("ST")) uvs_ = true, keyword.remove_prefix(2);
        if (keyword.starts_with("C")) colors_ = true, keyword.remove_prefix(1);
        if (keyword.starts_with("N")) normals_ = true, keyword.remove_prefix(1);
        if (keyword != "OFF") fail("the file must begin with OFF, COFF, NOFF, CNOFF or STOFF");
        scan_.skip_blanks();
        TextScan ahead = scan_;
        if (ahead.word() == "BINARY") fail("binary OFF cannot be read; save it as text");
        if (uvs_) mesh_.uvs.emplace_back();
    }

    void read_vertices(std::size_t vertices)
    {
        for (std::size_t v = 0; v < vertices; ++v) {
            if (v % (1 << 16) == 0)
                report(progress_, 0.3 * double(v) / double(vertices), "Reading vertices");
            mesh_.positions.emplace_back(vector<glm::dvec3>(v) - file_.origin);
            if (normals_) mesh_.normals.push_back(vector<glm::vec3>(v));
            if (colors_) mesh_.colors.push_back(color(v));
            if (uvs_) mesh_.uvs[0].push_back(vector<glm::vec2>(v));
        }
    }

    // Reads three or four numbers to the end of the line, from 0 to 1 or from 0 to 255.
    glm::vec4 color(std::size_t vertex)
    {
        glm::vec4 result(vector<glm::vec3>(vertex), 1);
        scan_.skip_blanks();
        if (!scan_.done() && *scan_.at != '\n' && *scan_.at != '#')
            if (const auto alpha = scan_.number()) result.w = static_cast<float>(*alpha);
        if (std::max({result.x, result.y, result.z}) > 1) result /= glm::vec4(255);
        return glm::clamp(result, 0.0f, 1.0f);
    }

    void read_face()
    {
        const std::size_t corners = count("number of corners of a face");
        if (corners * 2 > static_cast<std::size_t>(scan_.end - scan_.at) + 1)
            fail(fmt::format("a face with {} corners is declared, more than the rest of the file "
                             "can hold",
                             with_commas(corners)));
        const std::size_t first = mesh_.corners.size();
        bool whole = true;
        for (std::size_t c = 0; c < corners; ++c) {
            const std::size_t vertex = count("vertex of a face");
            whole &= vertex < mesh_.vertex_count();
            mesh_.corners.push_back(static_cast<std::uint32_t>(vertex));
        }
        if (whole)
            mesh_.face_begin.push_back(static_cast<std::uint32_t>(mesh_.corners.size()));
        else
            leave_out(first);
        const std::string_view rest = scan_.line();
        const std::size_t something = rest.find_first_not_of(" \t\r");
        face_colors_ |= something != rest.npos && rest[something] != '#';
    }

    void leave_out(std::size_t first_corner)
    {
        mesh_.corners.resize(first_corner);
        if (left_out_++ == 0) first_left_out_ = line();
    }

    bool at_line_end()
    {
        scan_.skip_blanks();
        return scan_.done() || *scan_.at == '\n' || *scan_.at == '#';
    }

    std::size_t count(const char* what)
    {
        skip();
        TextScan word = scan_;
        const auto value = scan_.integer();
        if (value && *value >= 0 && (at_line_end() || is_blank(scan_.at[-1])))
            return static_cast<std::size_t>(*value);
        const std::string_view there = word.word();
        if (there.empty()) fail(fmt::format("the {} is missing because the file ends here", what));
        fail(fmt::format("the {} is '{}' but must be a whole number from 0 to 999999999", what,
                         shown(there)));
    }

    template <class T> T vector(std::size_t vertex)
    {
        T result;
        for (int i = 0; i < T::length(); ++i) {
            skip();
            const auto value = scan_.number();
            if (!value) fail(fmt::format("a number of vertex {} {}", vertex, not_a_number(scan_)));
            result[i] = static_cast<typename T::value_type>(*value);
        }
        return result;
    }

    // Skips to the next word, over line ends and comments.
    void skip()
    {
        for (;;) {
            scan_.skip_blanks();
            if (scan_.done()) return;
            if (*scan_.at == '\n')
                ++scan_.at;
            else if (*scan_.at == '#')
                scan_.line();
            else
                return;
        }
    }

    std::size_t line() const { return plain_.line_of(scan_.at); }

    [[noreturn]] void fail(const std::string& what) const
    {
        throw Rejected(fmt::format("{}: line {}: {}", file_.name, line(), what));
    }

    const FileText& file_;
    const Progress& progress_;
    PlainText plain_;
    TextScan scan_;
    Mesh mesh_;
    std::size_t left_out_ = 0, first_left_out_ = 0; // faces, and the line of the first
    bool normals_ = false, colors_ = false, uvs_ = false, face_colors_ = false;
};

} // namespace

Model read_off(const FileText& file, const Progress& progress)
{
    return OffReader(file, progress).read();
}

} // namespace trivar
