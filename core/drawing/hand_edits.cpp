// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drawing/hand_edits.h"

#include "core/base/rejected.h"
#include "core/drawing/drawn_svg.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>

namespace trivar {
namespace {

constexpr float same_width = 0.011f; // pixels; a list tells widths to a hundredth

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

std::optional<glm::vec3> hex_color_of(std::string_view digits)
{
    unsigned value = 0;
    const auto [at, trouble] =
        std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
    if (trouble != std::errc() || at != digits.data() + digits.size()) return std::nullopt;
    if (digits.size() == 3) return glm::vec3(value >> 8, value >> 4 & 0xF, value & 0xF) / 15.0f;
    if (digits.size() != 6) return std::nullopt;
    return glm::vec3(value >> 16, value >> 8 & 0xFF, value & 0xFF) / 255.0f;
}

// A colour as programs write it: #f00, #ff0000, rgb(255,0,0) or by one of the names of HTML 4.
std::optional<glm::vec3> color_of(const std::string& text)
{
    constexpr std::pair<std::string_view, std::string_view> named[] = {
        {"black", "000000"},  {"silver", "c0c0c0"}, {"gray", "808080"},   {"white", "ffffff"},
        {"maroon", "800000"}, {"red", "ff0000"},    {"purple", "800080"}, {"fuchsia", "ff00ff"},
        {"green", "008000"},  {"lime", "00ff00"},   {"olive", "808000"},  {"yellow", "ffff00"},
        {"navy", "000080"},   {"blue", "0000ff"},   {"teal", "008080"},   {"aqua", "00ffff"},
        {"cyan", "00ffff"},   {"magenta", "ff00ff"}};
    if (text.starts_with('#')) return hex_color_of(std::string_view(text).substr(1));
    for (const auto& [name, digits] : named)
        if (text == name) return hex_color_of(digits);
    int r = 0, g = 0, b = 0, end = 0;
    if (std::sscanf(text.c_str(), "rgb(%d ,%d ,%d )%n", &r, &g, &b, &end) != 3 ||
        static_cast<std::size_t>(end) != text.size() || std::min({r, g, b}) < 0 ||
        std::max({r, g, b}) > 255)
        return std::nullopt;
    return glm::vec3(r, g, b) / 255.0f;
}

class EditReader {
public:
    EditReader(std::string_view svg, const DrawnSvg& drawn) : svg_(svg), drawn_(drawn) {}
    HandEdits operator()()
    {
        for (const auto& [id, line] : drawn_.listed) {
            out_.by_line[id] = {.deleted = true, .layer = line.layer, .listed = line.text};
            out_.lines[line.layer].push_back(line.record);
        }
        for (const auto& [own, i] : drawn_.paths)
            if (!drawn_.off[i]) found(own, i);
        std::erase_if(out_.by_line, [](const auto& one) {
            const HandEdits::Edit& e = one.second;
            return !e.deleted && e.widening == 1 && !e.color;
        });
        out_.svg = svg_;
        out_.added = drawn_.own;
        return std::move(out_);
    }

private:
    void found(const std::string& own, std::size_t i)
    {
        const std::string id = without_number(own);
        const auto listed = drawn_.listed.find(id);
        if (listed == drawn_.listed.end()) return; // the list is lost
        HandEdits::Edit& edit = out_.by_line[id];
        edit.deleted = false;
        if (own != id) return; // the first path of a line counts
        const ListedLine& line = listed->second;
        const std::string stroke = look(i, "stroke"), fill = look(i, "fill");
        const bool stroked = !stroke.empty() && stroke != "none";
        if (const float width = width_in(i, stroked, line);
            line.width > 0 && std::abs(width - line.width) > same_width)
            edit.widening = width / line.width;
        const auto color = color_of(stroked && !line.outline ? stroke : fill);
        if (color && hex_color(*color) != line.color) edit.color = color;
    }
    std::string look(std::size_t i, std::string_view property) const
    {
        const SvgElement& e = drawn_.elements[i];
        return look_of(svg_.substr(e.begin, e.tag_end - e.begin), property, drawn_.classes);
    }
    // The width that a line has where a hand gave it a stroke.
    float width_in(std::size_t i, bool stroked, const ListedLine& line) const
    {
        const std::string told = look(i, "stroke-width");
        const std::optional<float> width = told.empty() ? 1 : length_of(told);
        if (!stroked || !width) return line.widened;
        return line.outline ? line.widened + *width : *width;
    }

    std::string_view svg_;
    const DrawnSvg& drawn_;
    HandEdits out_;
};

} // namespace

std::optional<HandEdits> hand_edits_of(std::string_view svg)
{
    const std::optional<DrawnSvg> drawn = drawn_svg(svg);
    if (!drawn) return std::nullopt;
    return EditReader(svg, *drawn)();
}

HandEdits read_hand_edits(std::string_view svg)
{
    if (std::optional<HandEdits> edits = hand_edits_of(svg)) return std::move(*edits);
    throw Rejected("it has no list of lines: it was not drawn here, or lost its <desc>");
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
        out += ", " + counted(edits.added, "element", "elements") + " of the hand's own kept";
    return out;
}

AppliedEdits apply(const HandEdits& edits, DrawingSheet& drawing)
{
    drawing.list = line_list(drawing, edits);
    drawing.earlier = edits.svg;
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
