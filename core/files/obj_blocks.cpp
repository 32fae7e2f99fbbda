// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/obj_blocks.h"

#include "core/files/text_scan.h"

#include <algorithm>
#include <fmt/format.h>
#include <optional>

namespace trivar {
namespace {

class BlockReader {
public:
    explicit BlockReader(std::string_view text) : scan_(text) {}

    ObjBlock read()
    {
        while (!scan_.done() && block_.error.empty()) {
            const char* line = scan_.at;
            read_line();
            if (!block_.error.empty()) block_.error_at = line;
            scan_.line();
        }
        return std::move(block_);
    }

private:
    void read_line()
    {
        const std::string_view keyword = scan_.word();
        if (keyword.empty() || keyword[0] == '#') return;
        if (keyword == "v") return read_position();
        if (keyword == "vt") return read_texture_coordinate();
        if (keyword == "vn") {
            if (const auto n = vector(3)) block_.vn.push_back(*n);
            return;
        }
        if (keyword == "f" || keyword == "fo") return read_face();
        using Kind = ObjEvent::Kind;
        if (keyword == "usemtl") return add_event(Kind::material);
        if (keyword == "g") return add_event(Kind::group);
        if (keyword == "o") return add_event(Kind::object);
        if (keyword == "mtllib") return add_event(Kind::library);
        if (keyword == "t") return add_event(Kind::tag);
        if (keyword == "l" || keyword == "p") ++block_.lines_and_points;
        if (keyword == "curv" || keyword == "curv2" || keyword == "surf") ++block_.free_forms;
        // Everything else sets display attributes or belongs to free forms.
    }

    std::optional<glm::vec3> vector(int needed)
    {
        glm::vec3 result(0);
        for (int i = 0; i < needed; ++i) {
            const auto value = scan_.number();
            if (!value) {
                block_.error =
                    fmt::format("number {} of {} is missing or is no finite number", i + 1, needed);
                return {};
            }
            result[i] = static_cast<float>(*value);
        }
        return result;
    }

    void read_position()
    {
        const auto p = vector(3);
        if (!p) return;
        // Three more numbers are a colour; a single one is a weight, which plain points ignore.
        glm::vec3 color(1);
        int count = 0;
        while (count < 3) {
            const auto value = scan_.number();
            if (!value) break;
            color[count++] = static_cast<float>(*value);
        }
        if (count == 3 || !block_.colors.empty()) {
            block_.colors.resize(block_.v.size(), glm::vec3(1));
            block_.colors.push_back(count == 3 ? glm::clamp(color, 0.0f, 1.0f) : glm::vec3(1));
        }
        block_.v.push_back(*p);
    }

    void read_texture_coordinate()
    {
        const auto u = vector(1);
        if (!u) return;
        const auto v = scan_.number();
        block_.vt.emplace_back(u->x, v ? static_cast<float>(*v) : 0.0f);
    }

    // 1-based or relative to the end, as the file has it; -1 for none after an error.
    std::int32_t index(std::size_t count)
    {
        const auto written = scan_.integer();
        if (!written) {
            block_.error = "a face has something that is no index";
            return -1;
        }
        if (*written > 0) return *written - 1;
        if (*written == 0) {
            block_.error = "a face has the index 0, they count from 1";
            return -1;
        }
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

    void read_face()
    {
        for (scan_.skip_blanks(); block_.error.empty(); scan_.skip_blanks()) {
            if (scan_.done() || *scan_.at == '\n' || *scan_.at == '#') break;
            ObjCorner corner{index(block_.v.size()), -1, -1};
            if (slash()) {
                if (at_index()) corner.vt = index(block_.vt.size());
                if (slash() && at_index()) corner.vn = index(block_.vn.size());
            }
            if (block_.error.empty() && !scan_.done() && !is_blank(*scan_.at) && *scan_.at != '\n')
                block_.error = "a face has something that is no index";
            block_.corners.push_back(corner);
        }
        block_.face_end.push_back(static_cast<std::uint32_t>(block_.corners.size()));
    }

    void add_event(ObjEvent::Kind kind)
    {
        scan_.skip_blanks();
        const char* begin = scan_.at;
        const char* end = std::find(begin, scan_.end, '\n');
        scan_.at = end;
        while (end != begin && is_blank(end[-1])) --end;
        block_.events.push_back({kind, static_cast<std::uint32_t>(block_.face_end.size()),
                                 std::string_view(begin, static_cast<std::size_t>(end - begin))});
    }

    TextScan scan_;
    ObjBlock block_;
};

} // namespace

ObjBlock read_obj_block(std::string_view text)
{
    return BlockReader(text).read();
}

} // namespace trivar
