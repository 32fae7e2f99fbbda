// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drawing/hand_edits.h"

#include "core/base/rejected.h"
#include "core/drawing/line_list.h"

#include <algorithm>
#include <charconv>
#include <cmath>
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
            out_.by_line[id].deleted = true; // until it is found
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
            const bool off = at.off || value_of(at.node, "display") == "none" ||
                             value_of(at.node, "visibility") == "hidden";
            if (at.node.name() == std::string_view("path") && !off) found(at.node);
            for (const pugi::xml_node& child : at.node.children()) open.push_back({child, off});
        }
    }
    void found(const pugi::xml_node& path)
    {
        const std::string id = without_number(path.attribute("id").as_string());
        const auto listed = listed_.find(id);
        if (listed == listed_.end()) {
            ++out_.added;
            return;
        }
        HandEdits::Edit& edit = out_.by_line[id];
        if (!edit.deleted) return; // a second path of it
        edit.deleted = false;
        const std::string stroke = value_of(path, "stroke"), fill = value_of(path, "fill");
        const bool stroked = !stroke.empty() && stroke != "none";
        if (stroked)
            if (const auto width = length_of(value_of(path, "stroke-width"));
                width && std::abs(*width - listed->second.width) > same_width &&
                listed->second.width > 0)
                edit.widening = *width / listed->second.width;
        const std::string color = stroked ? stroke : fill;
        if (color != listed->second.color) edit.color = color_of(color);
    }

    const std::map<std::string, ListedLine>& listed_;
    HandEdits out_;
};

} // namespace

LineIds HandEdits::ids_of(const std::string& layer_name) const
{
    const auto found = lines.find(layer_id({layer_name, {}}));
    return found == lines.end() ? LineIds() : LineIds(found->second);
}

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

void apply(const HandEdits& edits, DrawingSheet& drawing)
{
    for (DrawingLayer& layer : drawing.layers) {
        const auto edit_of = [&](const InkedLine& line) -> const HandEdits::Edit* {
            const auto found = edits.by_line.find(line_id(layer, line));
            return found == edits.by_line.end() ? nullptr : &found->second;
        };
        std::erase_if(layer.lines, [&](const InkedLine& line) {
            const HandEdits::Edit* edit = edit_of(line);
            return edit && edit->deleted;
        });
        for (InkedLine& line : layer.lines)
            if (const HandEdits::Edit* edit = edit_of(line))
                for (InkedLine::Point& p : line.points) {
                    p.width *= edit->widening;
                    p.color = edit->color.value_or(p.color);
                }
    }
}

} // namespace trivar
