// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drawing/hand_edits.h"

#include "core/base/rejected.h"
#include "core/drawing/line_list.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <pugixml.hpp>

namespace trivar {
namespace {

constexpr float same_width = 0.011f; // pixels; a list tells widths to a hundredth

// An attribute of an element, or the property of its style of that name, which counts more.
std::string value_of(const pugi::xml_node& node, std::string_view name)
{
    const std::string_view style = node.attribute("style").as_string();
    for (std::size_t at = 0; at < style.size();) {
        const std::size_t end = std::min(style.find(';', at), style.size());
        std::string_view one = style.substr(at, end - at);
        at = end + 1;
        const std::size_t colon = one.find(':');
        if (colon == one.npos) continue;
        const auto trimmed = [](std::string_view s) {
            while (!s.empty() && s.front() <= ' ') s.remove_prefix(1);
            while (!s.empty() && s.back() <= ' ') s.remove_suffix(1);
            return s;
        };
        if (trimmed(one.substr(0, colon)) == name)
            return std::string(trimmed(one.substr(colon + 1)));
    }
    return node.attribute(std::string(name).c_str()).as_string();
}

std::optional<float> length_of(const std::string& text) // pixels
{
    double value = 0;
    const auto [at, trouble] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (trouble != std::errc() || !(value > 0) || !(value < 1e4)) return std::nullopt;
    const std::string_view unit(at, static_cast<std::size_t>(text.data() + text.size() - at));
    constexpr double dpi = 96;
    if (unit.empty() || unit == "px") return static_cast<float>(value);
    if (unit == "mm") return static_cast<float>(value * dpi / 25.4);
    if (unit == "pt") return static_cast<float>(value * dpi / 72);
    return std::nullopt;
}

std::optional<glm::vec3> color_of(const std::string& text)
{
    unsigned value = 0;
    if (text.size() != 7 || text[0] != '#') return std::nullopt;
    const auto [at, trouble] = std::from_chars(text.data() + 1, text.data() + 7, value, 16);
    if (trouble != std::errc() || at != text.data() + 7) return std::nullopt;
    return glm::vec3(value >> 16, value >> 8 & 0xFF, value & 0xFF) / 255.0f;
}

// An id without the number of the path, "bone-s1a_2": "bone-s1a".
std::string without_number(const std::string& id)
{
    const std::size_t at = id.rfind('_');
    const bool numbered = at != id.npos && at + 1 < id.size() &&
                          std::all_of(id.begin() + static_cast<std::ptrdiff_t>(at) + 1, id.end(),
                                      [](char c) { return c >= '0' && c <= '9'; });
    return numbered ? id.substr(0, at) : id;
}

class EditReader {
public:
    explicit EditReader(const std::map<std::string, ListedLine>& listed) : listed_(listed)
    {
        for (const auto& [id, line] : listed) {
            out_.by_line[id] = {.deleted = true, .layer = line.layer, .listed = line.text};
            out_.lines[line.layer].push_back(line.record);
        }
    }
    HandEdits operator()(const pugi::xml_node& svg)
    {
        look(svg);
        std::erase_if(out_.by_line, [](const auto& one) {
            const HandEdits::Edit& e = one.second;
            return !e.deleted && e.widening == 1 && !e.color;
        });
        return std::move(out_);
    }

private:
    void look(const pugi::xml_node& root)
    {
        struct Place {
            pugi::xml_node node;
            bool off;
        };
        std::vector<Place> open{{root, false}};
        while (!open.empty()) {
            const Place at = open.back();
            open.pop_back();
            if (at.node.name() == std::string_view("defs")) continue;
            const bool off = at.off || value_of(at.node, "display") == "none" ||
                             value_of(at.node, "visibility") == "hidden";
            if (at.node.name() == std::string_view("path") && !off) found(at.node);
            for (const pugi::xml_node& child : at.node.children()) open.push_back({child, off});
        }
    }
    void found(const pugi::xml_node& path)
    {
        const std::string own = path.attribute("id").as_string(), id = without_number(own);
        const auto listed = listed_.find(id);
        if (listed == listed_.end()) {
            ++out_.added;
            return;
        }
        HandEdits::Edit& edit = out_.by_line[id];
        edit.deleted = false;
        if (own != id) return; // the first path of a line counts
        const ListedLine& line = listed->second;
        const std::string stroke = value_of(path, "stroke"), fill = value_of(path, "fill");
        const bool stroked = !stroke.empty() && stroke != "none";
        if (const float width = width_in(path, stroked, line);
            line.width > 0 && std::abs(width - line.width) > same_width)
            edit.widening = width / line.width;
        const std::string color = stroked && !line.outline ? stroke : fill;
        if (color != line.color) edit.color = color_of(color);
    }
    // The width that a line has where a hand gave it a stroke.
    static float width_in(const pugi::xml_node& path, bool stroked, const ListedLine& line)
    {
        const std::string told = value_of(path, "stroke-width");
        const std::optional<float> width = told.empty() ? 1 : length_of(told);
        if (!stroked || !width) return line.widened;
        return line.outline ? line.widened + *width : *width;
    }

    const std::map<std::string, ListedLine>& listed_;
    HandEdits out_;
};

} // namespace

HandEdits read_hand_edits(std::string_view svg)
{
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer(svg.data(), svg.size());
    if (!parsed) throw Rejected(std::string("it is no .svg: ") + parsed.description());
    const pugi::xml_node root = document.document_element();
    const pugi::xml_node list = root.find_node([](const pugi::xml_node& node) {
        return node.attribute("id").as_string() == line_list_id;
    });
    if (!list) throw Rejected("it has no list of lines: it was not drawn here, or lost its <desc>");
    const std::map<std::string, ListedLine> listed = listed_lines(list.text().as_string());
    return EditReader(listed)(root);
}

LineIds& EditedLineIds::operator()(const std::string& layer_name)
{
    const auto found = known_.find(layer_name);
    if (found != known_.end()) return found->second;
    const auto lines = edits_->lines.find(layer_id(layer_name));
    return known_
        .emplace(layer_name, lines == edits_->lines.end() ? LineIds() : LineIds(lines->second))
        .first->second;
}

std::string words_of(const AppliedEdits& edits)
{
    const auto counted = [](std::size_t n, const char* one, const char* many) {
        return fmt::format("{} {}", n, n == 1 ? one : many);
    };
    std::string out = counted(edits.done, "edit by hand was", "edits by hand were") + " done again";
    if (edits.lost > 0)
        out += ", " + counted(edits.lost, "is of a line", "are of lines") + " not drawn here";
    if (!edits.other_layers.empty())
        out += fmt::format(" (no layer is called {})", fmt::join(edits.other_layers, ", "));
    if (edits.added > 0)
        out += ", " + counted(edits.added, "path", "paths") + " of the hand's own left out";
    return out;
}

AppliedEdits apply(const HandEdits& edits, DrawingSheet& drawing)
{
    drawing.list = line_list(drawing, edits);
    const std::vector<std::string> ids = layer_ids(drawing.layers);
    std::set<std::string> done;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        std::vector<InkedLine> kept;
        for (InkedLine& line : drawing.layers[i].lines) {
            if (const auto found = edits.by_line.find(line_id(ids[i], line));
                found != edits.by_line.end()) {
                done.insert(found->first);
                const HandEdits::Edit& edit = found->second;
                if (edit.deleted) continue;
                for (InkedLine::Point& p : line.points) {
                    p.width *= edit.widening;
                    p.color = edit.color.value_or(p.color);
                }
            }
            kept.push_back(std::move(line));
        }
        drawing.layers[i].lines = std::move(kept);
    }
    AppliedEdits out{done.size(), edits.by_line.size() - done.size(), edits.added};
    for (const auto& [id, edit] : edits.by_line)
        if (std::ranges::find(ids, edit.layer) == ids.end()) out.other_layers.insert(edit.layer);
    return out;
}

} // namespace trivar
