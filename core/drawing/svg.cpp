// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drawing/svg.h"

#include "core/drawing/line_list.h"
#include "core/drawing/line_pieces.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <map>

namespace trivar {
namespace {

std::string escaped(std::string_view text)
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

std::string number(double value) // with at most one digit after the point
{
    std::string out = fmt::format("{:.1f}", value);
    if (out.ends_with(".0")) out.resize(out.size() - 2);
    return out == "-0" ? "0" : out;
}

void add_place(std::string& out, const glm::dvec2& p)
{
    if (!out.empty() && out.back() != 'M') out += ' ';
    out += number(p.x);
    out += ' ';
    out += number(p.y);
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

// SvgWriter numbers the paths that one line has.
class SvgWriter {
public:
    std::string operator()(const DrawingSheet& drawing)
    {
        fmt::format_to(std::back_inserter(out_),
                       "<svg xmlns=\"http://www.w3.org/2000/svg\" "
                       "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" "
                       "width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n",
                       number(drawing.size.x), number(drawing.size.y));
        fmt::format_to(std::back_inserter(out_), "<desc id=\"{}\">{}</desc>\n", line_list_id,
                       drawing.list.empty() ? line_list(drawing) : drawing.list);
        if (drawing.paper)
            fmt::format_to(std::back_inserter(out_),
                           "<rect width=\"100%\" height=\"100%\" fill=\"{}\"/>\n",
                           hex_color(*drawing.paper));
        const std::vector<std::string> ids = layer_ids(drawing.layers);
        for (std::size_t i = 0; i < ids.size(); ++i) add_layer(drawing.layers[i], ids[i]);
        return std::move(out_) + "</svg>\n";
    }

private:
    void add_layer(const DrawingLayer& layer, const std::string& id)
    {
        fmt::format_to(std::back_inserter(out_),
                       "<g id=\"{0}\" inkscape:groupmode=\"layer\" inkscape:label=\"{1}\" "
                       "fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n",
                       id, escaped(layer.name));
        for (const bool hidden : {true, false}) {
            if (std::ranges::none_of(layer.lines,
                                     [&](const InkedLine& l) { return l.hidden == hidden; }))
                continue;
            fmt::format_to(std::back_inserter(out_), "<g id=\"{}_{}\">\n", id,
                           hidden ? "hidden" : "seen");
            for (const InkedLine& line : layer.lines)
                if (line.hidden == hidden && line.points.size() >= 2)
                    add_line(line, line_id(id, line));
            out_ += "</g>\n";
        }
        out_ += "</g>\n";
    }
    void add_line(const InkedLine& line, const std::string& id)
    {
        for (const LinePiece& piece : pieces_of(line)) {
            const int n = ++count_[id];
            const std::string name = n == 1 ? id : fmt::format("{}_{}", id, n);
            const std::string color = hex_color(piece.color);
            const std::string fade =
                line.opacity < 1 ? fmt::format(" opacity=\"{:.2f}\"", line.opacity) : "";
            const std::string path = path_of(line, piece);
            if (is_one_stroke(line))
                fmt::format_to(
                    std::back_inserter(out_),
                    "<path id=\"{}\" stroke=\"{}\" stroke-width=\"{:.2f}\"{}{} d=\"{}\"/>\n", name,
                    color, width_of(line), line.dashed ? " stroke-dasharray=\"4 4\"" : "", fade,
                    path);
            else
                fmt::format_to(std::back_inserter(out_),
                               "<path id=\"{}\" fill=\"{}\" stroke=\"none\"{} d=\"{}\"/>\n", name,
                               color, fade, path);
        }
    }
    std::string out_;
    std::map<std::string, int> count_; // of the paths of each line
};

} // namespace

std::string svg_of(const DrawingSheet& drawing)
{
    return SvgWriter()(drawing);
}

} // namespace trivar
