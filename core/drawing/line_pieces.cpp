// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drawing/line_pieces.h"

#include <algorithm>

namespace trivar {

std::vector<LinePiece> pieces_of(const InkedLine& line)
{
    constexpr float shades = 32;
    const auto shade = [](const glm::vec3& c) { return glm::ivec3(glm::round(c * shades)); };
    std::vector<LinePiece> out;
    const std::span<const InkedLine::Point> all(line.points);
    std::size_t begin = 0;
    double along = 0, begun = 0;
    for (std::size_t i = 1; i < all.size(); ++i) {
        along += glm::distance(glm::dvec2(all[i - 1].at), glm::dvec2(all[i].at));
        if (shade(all[i].color) != shade(all[begin].color)) {
            out.push_back({all.subspan(begin, i - begin + 1), all[begin].color, begun});
            begin = i;
            begun = along;
        }
    }
    if (begin + 1 < all.size()) out.push_back({all.subspan(begin), all[begin].color, begun});
    return out;
}

bool is_one_stroke(const InkedLine& line)
{
    return line.is_even() || line.dashed;
}

float width_of(const InkedLine& line)
{
    return line.points.empty() ? 0 : line.points[line.points.size() / 2].width;
}

double dash_of(const InkedLine& line)
{
    constexpr double shortest = 4, widths = 3; // shorter ones would be dots
    return line.dashed ? std::max(shortest, widths * double{width_of(line)}) : 0;
}

std::vector<glm::dvec2> outline_of(std::span<const InkedLine::Point> points)
{
    std::vector<glm::dvec2> out, back;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::dvec2 along = glm::dvec2(points[std::min(i + 1, points.size() - 1)].at) -
                                 glm::dvec2(points[i > 0 ? i - 1 : 0].at);
        const double norm = glm::length(along);
        if (norm == 0) continue;
        const glm::dvec2 side =
            glm::dvec2(-along.y, along.x) * (0.5 * double{points[i].width} / norm);
        out.push_back(glm::dvec2(points[i].at) + side);
        back.push_back(glm::dvec2(points[i].at) - side);
    }
    out.insert(out.end(), back.rbegin(), back.rend());
    return out;
}

} // namespace trivar
