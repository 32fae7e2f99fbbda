// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/wavefront/obj_blocks.h"

#include "core/files/file_sentences.h"
#include "core/files/text_scan.h"

#include <fmt/format.h>
#include <limits>
#include <optional>
#include <utility>

namespace trivar {
namespace {

bool is_face(std::string_view keyword)
{
    return keyword == "f" || keyword == "fo";
}

class BlockReader {
public:
    BlockReader(std::string_view text, const glm::dvec3& origin) : scan_(text), origin_(origin) {}

    ObjBlock read()
    {
        while (!scan_.done() && !block_.error.at) {
            line_ = scan_.at;
            read_line();
            scan_.line();
        }
        block_.counts = {block_.v.size(), block_.vt.size(), block_.vn.size()};
        return std::move(block_);
    }

private:
    void read_line()
    {
        const std::string_view keyword = scan_.word();
        if (keyword.empty() || keyword[0] == '#') return;
        if (keyword == "v") return read_position();
        if (keyword == "vt") return read_texture_coordinate();
        if (keyword == "vn") return read_normal();
        if (is_face(keyword)) return read_face();
        using Kind = ObjEvent::Kind;
        if (keyword == "usemtl") return add_event(Kind::material);
        if (keyword == "g") return add_event(Kind::group);
        if (keyword == "o") return add_event(Kind::object);
        if (keyword == "mtllib") return add_event(Kind::library);
        if (keyword == "t") return add_event(Kind::tag);
        if (keyword == "s") return add_event(Kind::smoothing);
        if (keyword == "l") return read_line_element();
        if (keyword == "p") ++block_.points;
        if (keyword == "curv" || keyword == "curv2" || keyword == "surf") ++block_.free_forms;
        // All other keywords set display attributes or belong to free-form geometry.
    }

    void fail(std::string what) { block_.error = {line_, std::move(what)}; }

    // Reads up to `most` numbers and returns how many there were.
    template <class T> int numbers(T& to, int most)
    {
        for (int i = 0; i < most; ++i) {
            const auto value = scan_.number();
            if (!value) return i;
            to[i] = static_cast<typename T::value_type>(*value);
        }
        return most;
    }

    void read_position()
    {
        glm::dvec3 p;
        if (const int read = numbers(p, 3); read < 3)
            return fail(fmt::format("the {} of a vertex {}", "xyz"[read], not_a_number(scan_)));
        // Three more numbers are a colour; a single one is a weight, which is ignored for points.
        glm::vec3 color;
        const bool colored = numbers(color, 3) == 3;
        if (colored || !block_.colors.empty()) {
            block_.colors.resize(block_.v.size(), glm::vec3(1));
            block_.colors.push_back(colored ? glm::clamp(color, 0.0f, 1.0f) : glm::vec3(1));
        }
        block_.v.emplace_back(p - origin_);
    }

    // Keeps an invalid element, so that later ones keep their numbers, but no face may use it.
    template <class T> void leave_out(T& element, const char* name)
    {
        element.x = std::numeric_limits<float>::quiet_NaN();
        if (block_.bad_lines++ == 0)
            block_.first_bad = {line_, fmt::format("a number of {} {}", name, not_a_number(scan_))};
    }

    void read_normal()
    {
        glm::vec3 n(0);
        if (numbers(n, 3) < 3) leave_out(n, "vn");
        block_.vn.push_back(n);
    }

    void read_texture_coordinate()
    {
        glm::vec2 uv(0);
        const int read = numbers(uv, 2);
        scan_.skip_blanks();
        const bool ended = scan_.done() || *scan_.at == '\n' || *scan_.at == '#';
        if (read == 0 || (read == 1 && !ended)) leave_out(uv, "vt");
        block_.vt.push_back(uv);
    }

    // Reads an index as in the file, from 1 or relative to the end; none if it is not a number.
    std::optional<std::int32_t> index(std::size_t count)
    {
        const auto written = scan_.integer();
        if (!written || *written > 0) return written ? std::optional(*written - 1) : std::nullopt;
        if (*written == 0) return ObjCorner::absent;
        return ObjCorner::relative + static_cast<std::int32_t>(count) + *written;
    }

    bool slash()
    {
        if (scan_.done() || *scan_.at != '/') return false;
        ++scan_.at;
        return true;
    }
    bool at_index() const
    {
        return !scan_.done() &&
               (*scan_.at == '-' || *scan_.at == '+' || (*scan_.at >= '0' && *scan_.at <= '9'));
    }

    // Reads v, v/vt, v//vn or v/vt/vn up to the next blank.
    std::optional<ObjCorner> corner()
    {
        std::optional<std::int32_t> v = index(block_.v.size()), vt = ObjCorner::none, vn = vt;
        if (v && slash()) {
            if (at_index()) vt = index(block_.vt.size());
            if (vt && slash() && at_index()) vn = index(block_.vn.size());
        }
        const bool ended = scan_.done() || is_blank(*scan_.at) || *scan_.at == '\n';
        if (!v || !vt || !vn || !ended) return {};
        return ObjCorner{*v, *vt, *vn};
    }

    void read_face()
    {
        for (scan_.skip_blanks();; scan_.skip_blanks()) {
            if (scan_.done() || *scan_.at == '\n' || *scan_.at == '#') break;
            TextScan word = scan_;
            const auto read = corner();
            if (!read)
                return fail(fmt::format("a face has '{}' where a corner such as 7, 7/8, 7//9 or "
                                        "7/8/9 should be",
                                        shown(word.word())));
            if (read->v == ObjCorner::absent)
                return fail("a face names vertex 0, but vertices are counted from 1");
            block_.corners.push_back(*read);
        }
        block_.face_end.push_back(static_cast<std::uint32_t>(block_.corners.size()));
    }

    // Reads a line of v or v/vt, whose vt is ignored. An invalid vertex is treated like a missing
    // one.
    void read_line_element()
    {
        for (scan_.skip_blanks();; scan_.skip_blanks()) {
            if (scan_.done() || *scan_.at == '\n' || *scan_.at == '#') break;
            TextScan word = scan_;
            const auto read = corner();
            block_.line_vertices.push_back(read ? read->v : ObjCorner::absent);
            if (read) continue;
            word.word();
            scan_ = word;
        }
        block_.line_end.push_back(static_cast<std::uint32_t>(block_.line_vertices.size()));
    }

    void add_event(ObjEvent::Kind kind)
    {
        const auto face = static_cast<std::uint32_t>(block_.face_end.size());
        const auto line = static_cast<std::uint32_t>(block_.line_end.size());
        block_.events.push_back({kind, face, line, scan_.rest()});
    }

    TextScan scan_;
    glm::dvec3 origin_;
    const char* line_ = nullptr;
    ObjBlock block_;
};

} // namespace

ObjBlock read_obj_block(std::string_view text, const glm::dvec3& origin)
{
    return BlockReader(text, origin).read();
}

namespace {

template <class Is> const char* line_that(std::string_view text, std::size_t number, const Is& is)
{
    TextScan scan(text);
    for (;; scan.line()) {
        const char* line = scan.at;
        if (scan.done() || (is(scan.word()) && number-- == 0)) return line;
    }
}

} // namespace

const char* line_of_face(std::string_view text, std::size_t face)
{
    return line_that(text, face, is_face);
}

const char* line_of_line(std::string_view text, std::size_t line)
{
    return line_that(text, line, [](std::string_view keyword) { return keyword == "l"; });
}

} // namespace trivar
