// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drawing/svg_parts.h"

#include "core/drawing/line_list.h"
#include "core/drawing/line_pieces.h"

#include <cmath>
#include <fmt/format.h>
#include <map>

namespace trivar {
namespace {

void add_place(std::string& out, const glm::dvec2& p)
{
    if (!out.empty() && out.back() != 'M') out += ' ';
    out += short_number(p.x);
    out += ' ';
    out += short_number(p.y);
}

std::string path_of(const InkedLine& line, const LinePiece& piece)
{
    std::string out = "M";
    if (is_one_stroke(line)) {
        for (const InkedLine::Point& p : piece.points) add_place(out, glm::dvec2(p.at));
        return out;
    }
    for (const glm::dvec2& p : outline_of(piece.points)) add_place(out, p);
    return out + "Z";
}

SvgAttributes attributes_of(const InkedLine& line, const LinePiece& piece, std::string id)
{
    SvgAttributes out{{"id", std::move(id)}};
    const std::string color = hex_color(piece.color);
    if (is_one_stroke(line)) {
        out.emplace_back("stroke", color);
        out.emplace_back("stroke-width", fmt::format("{:.2f}", width_of(line)));
        if (const double dash = dash_of(line); dash > 0) {
            out.emplace_back("stroke-dasharray", fmt::format("{0:.2f} {0:.2f}", dash));
            if (piece.along > 0)
                out.emplace_back("stroke-dashoffset",
                                 fmt::format("{:.2f}", std::fmod(piece.along, 2 * dash)));
            out.emplace_back("stroke-linecap", "butt");
        }
    } else {
        out.emplace_back("fill", color);
        out.emplace_back("stroke", "none");
    }
    if (line.opacity < 1) out.emplace_back("opacity", fmt::format("{:.2f}", line.opacity));
    out.emplace_back("d", path_of(line, piece));
    return out;
}

SvgLayer layer_of(const DrawingLayer& layer, const std::string& id,
                  std::map<std::string, int>& count)
{
    SvgLayer out{id,
                 {{"id", id},
                  {"inkscape:groupmode", "layer"},
                  {"inkscape:label", svg_escaped(layer.name)},
                  {"fill", "none"},
                  {"stroke-linecap", "round"},
                  {"stroke-linejoin", "round"}},
                 {{{id + "_hidden"}, {id + "_seen"}}}};
    for (const InkedLine& line : layer.lines) {
        SvgGroup& group = out.groups[line.hidden ? 0 : 1];
        group.is_needed = true;
        if (line.points.size() < 2) continue;
        const std::string own = line_id(id, line);
        for (const LinePiece& piece : pieces_of(line)) {
            const int n = ++count[own];
            group.paths.push_back(
                attributes_of(line, piece, n == 1 ? own : fmt::format("{}_{}", own, n)));
        }
    }
    return out;
}

} // namespace

SvgParts svg_parts(const DrawingSheet& drawing)
{
    SvgParts out;
    const std::string width = short_number(drawing.size.x), height = short_number(drawing.size.y);
    out.size = {{"width", width}, {"height", height}, {"viewBox", "0 0 " + width + ' ' + height}};
    out.list = drawing.list.empty() ? line_list(drawing) : drawing.list;
    if (drawing.paper) out.paper = hex_color(*drawing.paper);
    std::map<std::string, int> count; // of the paths of each line
    const std::vector<std::string> ids = layer_ids(drawing.layers);
    for (std::size_t i = 0; i < ids.size(); ++i)
        out.layers.push_back(layer_of(drawing.layers[i], ids[i], count));
    return out;
}

std::string svg_escaped(std::string_view text)
{
    std::string out;
    for (const char c : text) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (c == '"')
            out += "&quot;";
        else if (static_cast<unsigned char>(c) >= 0x20)
            out += c;
    }
    return out;
}

std::string text_of(const SvgAttributes& attributes)
{
    std::string out;
    for (const auto& [name, value] : attributes)
        out.append(" ").append(name).append("=\"").append(value).append("\"");
    return out;
}

std::string paper_text(const std::string& color, const std::string& prefix)
{
    return fmt::format("<{}rect id=\"{}\" width=\"100%\" height=\"100%\" fill=\"{}\"/>\n", prefix,
                       paper_id, color);
}

std::string path_text(const SvgAttributes& path, const std::string& prefix)
{
    return "<" + prefix + "path" + text_of(path) + "/>\n";
}

std::string text_of(const SvgGroup& group, const std::string& prefix)
{
    if (!group.is_needed) return {};
    std::string out = fmt::format("<{}g id=\"{}\">\n", prefix, group.id);
    for (const SvgAttributes& path : group.paths) out += path_text(path, prefix);
    return out + "</" + prefix + "g>\n";
}

std::string text_of(const SvgLayer& layer, const std::string& prefix)
{
    return fmt::format("<{0}g{1}>\n{2}{3}</{0}g>\n", prefix, text_of(layer.attributes),
                       text_of(layer.groups[0], prefix), text_of(layer.groups[1], prefix));
}

} // namespace trivar
