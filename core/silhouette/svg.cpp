// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/silhouette/svg.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <map>

namespace trivar {
namespace {

using Points = std::span<const InkedLine::Point>;

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

std::string id_of(std::string_view name)
{
    std::string out;
    for (const char c : name)
        out +=
            (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '.'
                ? c
                : '-';
    return out.empty() ? "level" : out;
}

std::string hex(const glm::vec3& color)
{
    const glm::ivec3 c(glm::round(glm::clamp(color, 0.0f, 1.0f) * 255.0f));
    return fmt::format("#{:02x}{:02x}{:02x}", c.r, c.g, c.b);
}

std::string number(double value) // with at most one digit after the point
{
    std::string out = fmt::format("{:.1f}", value);
    if (out.ends_with(".0")) out.resize(out.size() - 2);
    return out == "-0" ? "0" : out;
}

void add_place(std::string& out, const glm::dvec2& p)
{
    if (!out.empty() && out.back() != 'M' && out.back() != 'L') out += ' ';
    out += number(p.x);
    out += ' ';
    out += number(p.y);
}

// Both sides of a line, there and back.
std::string outline(Points points)
{
    std::string there = "M", back;
    std::vector<glm::dvec2> other;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::dvec2 along = glm::dvec2(points[std::min(i + 1, points.size() - 1)].at) -
                                 glm::dvec2(points[i > 0 ? i - 1 : 0].at);
        const double norm = glm::length(along);
        if (norm == 0) continue;
        const glm::dvec2 side =
            glm::dvec2(-along.y, along.x) * (0.5 * double{points[i].width} / norm);
        add_place(there, glm::dvec2(points[i].at) + side);
        other.push_back(glm::dvec2(points[i].at) - side);
    }
    for (auto p = other.rbegin(); p != other.rend(); ++p) add_place(there, *p);
    return there + "Z";
}

std::string middle_line(Points points)
{
    std::string out = "M";
    for (const InkedLine::Point& p : points) add_place(out, glm::dvec2(p.at));
    return out;
}

// The pieces of a line that are of one colour, as far as a screen shows it; each begins with the
// last point of the one before.
std::vector<Points> pieces_of_one_color(const InkedLine& line)
{
    constexpr float shades = 32;
    const auto shade = [](const glm::vec3& c) { return glm::ivec3(glm::round(c * shades)); };
    std::vector<Points> out;
    const Points all(line.points);
    std::size_t begin = 0;
    for (std::size_t i = 1; i < all.size(); ++i)
        if (shade(all[i].color) != shade(all[begin].color)) {
            out.push_back(all.subspan(begin, i - begin + 1));
            begin = i;
        }
    if (begin + 1 < all.size()) out.push_back(all.subspan(begin));
    return out;
}

void add_line(std::string& out, const InkedLine& line, const std::string& id)
{
    std::size_t piece = 0;
    for (const Points points : pieces_of_one_color(line)) {
        const std::string name = piece == 0 ? id : fmt::format("{}-{}", id, piece + 1);
        ++piece;
        const std::string color = hex(points.front().color);
        const std::string fade =
            line.opacity < 1 ? fmt::format(" opacity=\"{:.2f}\"", line.opacity) : "";
        if (line.is_even() || line.dashed)
            fmt::format_to(std::back_inserter(out),
                           "<path id=\"{}\" stroke=\"{}\" stroke-width=\"{:.2f}\"{}{} d=\"{}\"/>\n",
                           name, color, points[points.size() / 2].width,
                           line.dashed ? " stroke-dasharray=\"4 4\"" : "", fade,
                           middle_line(points));
        else
            fmt::format_to(std::back_inserter(out),
                           "<path id=\"{}\" fill=\"{}\" stroke=\"none\"{} d=\"{}\"/>\n", name,
                           color, fade, outline(points));
    }
}

} // namespace

std::string svg_of(std::span<const DrawingLayer> layers, const glm::dvec2& size,
                   const std::optional<glm::vec3>& paper)
{
    std::string out = fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" "
                                  "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" "
                                  "width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n",
                                  number(size.x), number(size.y));
    if (paper)
        fmt::format_to(std::back_inserter(out),
                       "<rect width=\"100%\" height=\"100%\" fill=\"{}\"/>\n", hex(*paper));
    std::map<std::string, int> used; // ids, since a level may have two lines of one edge
    for (const DrawingLayer& layer : layers) {
        const std::string name = id_of(layer.name);
        fmt::format_to(std::back_inserter(out),
                       "<g id=\"{0}\" inkscape:groupmode=\"layer\" inkscape:label=\"{1}\" "
                       "fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n",
                       name, escaped(layer.name));
        for (const bool hidden : {true, false}) {
            if (std::ranges::none_of(layer.lines,
                                     [&](const InkedLine& l) { return l.hidden == hidden; }))
                continue;
            fmt::format_to(std::back_inserter(out), "<g id=\"{}-{}\">\n", name,
                           hidden ? "hidden" : "seen");
            for (const InkedLine& line : layer.lines) {
                if (line.hidden != hidden || line.points.size() < 2) continue;
                std::string id = fmt::format("{}-{}{:x}", name, hidden ? "h" : "s", line.edge);
                if (const int n = used[id]++; n > 0) id += fmt::format(".{}", n + 1);
                add_line(out, line, id);
            }
            out += "</g>\n";
        }
        out += "</g>\n";
    }
    return out + "</svg>\n";
}

} // namespace trivar
