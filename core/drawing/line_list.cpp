// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drawing/line_list.h"

#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <optional>
#include <set>
#include <sstream>

namespace trivar {
namespace {

constexpr float list_step = 4;              // voxels between points that are listed
constexpr std::size_t most_listed = 100000; // points of a list that is read
constexpr int farthest_listed = 1 << 20;    // voxels

std::string point_list(const InkedLine& line)
{
    std::string out;
    glm::ivec3 last(0);
    bool first = true;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        const glm::ivec3 p(glm::round(line.points[i].p));
        const glm::vec3 d(p - last);
        const bool ends = i + 1 == line.points.size();
        if (!first && (glm::length(d) < list_step && (!ends || p == last))) continue;
        fmt::format_to(std::back_inserter(out), " {} {} {}", p.x - last.x, p.y - last.y,
                       p.z - last.z);
        last = p;
        first = false;
    }
    return out;
}

// The points on the way between those that are listed, about one per voxel.
std::vector<glm::vec3> filled(const std::vector<glm::ivec3>& listed)
{
    std::vector<glm::vec3> out;
    for (std::size_t i = 0; i < listed.size(); ++i) {
        const glm::vec3 p(listed[i]);
        if (i > 0) {
            const glm::vec3 from(listed[i - 1]);
            const float length = glm::distance(from, p);
            const int steps = static_cast<int>(std::min(64.0f, std::ceil(length)));
            for (int k = 1; k < steps; ++k)
                out.push_back(glm::mix(from, p, static_cast<float>(k) / static_cast<float>(steps)));
        }
        out.push_back(p);
    }
    return out;
}

// The parts of line_id(): the layer, and whether it is hidden with the line's own id.
std::optional<ListedLine> parts_of(const std::string& id)
{
    const std::size_t dash = id.rfind('-');
    if (dash == id.npos || dash + 2 > id.size()) return std::nullopt;
    const char kind = id[dash + 1];
    if (kind != 's' && kind != 'h') return std::nullopt;
    ListedLine out;
    out.layer = id.substr(0, dash);
    out.record.hidden = kind == 'h';
    const char *begin = id.data() + dash + 2, *end = id.data() + id.size();
    const auto [at, trouble] = std::from_chars(begin, end, out.record.id, 16);
    if (trouble != std::errc() || at != end) return std::nullopt;
    return out;
}

} // namespace

std::string layer_id(const DrawingLayer& layer)
{
    std::string out;
    for (const char c : layer.name)
        out +=
            (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '.'
                ? c
                : '-';
    return out.empty() ? "level" : out;
}

std::string hex_color(const glm::vec3& color)
{
    const glm::ivec3 c(glm::round(glm::clamp(color, 0.0f, 1.0f) * 255.0f));
    return fmt::format("#{:02x}{:02x}{:02x}", c.r, c.g, c.b);
}

float width_of(const InkedLine& line)
{
    return line.points.empty() ? 0 : line.points[line.points.size() / 2].width;
}

std::string line_id(const DrawingLayer& layer, const InkedLine& line)
{
    return fmt::format("{}-{}{:x}", layer_id(layer), line.hidden ? "h" : "s", line.id);
}

std::string line_list(const DrawingSheet& drawing)
{
    std::string out;
    std::set<std::string> listed;
    for (const DrawingLayer& layer : drawing.layers)
        for (const InkedLine& line : layer.lines) {
            if (line.points.size() < 2) continue;
            const std::string id = line_id(layer, line);
            if (!listed.insert(id).second) continue;
            fmt::format_to(std::back_inserter(out), "\n{} {:.2f} {}{}", id, width_of(line),
                           hex_color(line.points.front().color), point_list(line));
        }
    return out + "\n";
}

std::map<std::string, ListedLine> listed_lines(std::string_view text)
{
    std::map<std::string, ListedLine> out;
    std::istringstream lines{std::string(text)};
    std::size_t total = 0;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string id, color;
        double width = 0;
        if (!(words >> id >> width >> color)) continue;
        std::optional<ListedLine> listed = parts_of(id);
        if (!listed || !(width >= 0) || !(width < 1e6)) continue;
        listed->width = static_cast<float>(width);
        listed->color = color;
        std::vector<glm::ivec3> points;
        glm::ivec3 at(0), d;
        while (words >> d.x >> d.y >> d.z && ++total <= most_listed) {
            const glm::dvec3 next = glm::dvec3(at) + glm::dvec3(d);
            if (glm::any(glm::greaterThan(glm::abs(next), glm::dvec3(farthest_listed)))) break;
            points.push_back(at = glm::ivec3(next));
        }
        listed->record.points = filled(points);
        out.emplace(id, std::move(*listed));
    }
    return out;
}

} // namespace trivar
