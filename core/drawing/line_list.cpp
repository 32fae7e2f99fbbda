// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drawing/line_list.h"

#include "core/base/utf8.h"
#include "core/drawing/line_pieces.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
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

// Whether a letter may be in an id of XML (its NameChar). Dashes, colons and underscores, which
// may, part the words of ids here.
bool stays_in_ids(char32_t c)
{
    constexpr std::pair<char32_t, char32_t> ranges[] = {
        {'.', '.'},       {'0', '9'},         {'A', 'Z'},       {'a', 'z'},       {0xB7, 0xB7},
        {0xC0, 0xD6},     {0xD8, 0xF6},       {0xF8, 0x37D},    {0x37F, 0x1FFF},  {0x200C, 0x200D},
        {0x203F, 0x2040}, {0x2070, 0x218F},   {0x2C00, 0x2FEF}, {0x3001, 0xD7FF}, {0xF900, 0xFDCF},
        {0xFDF0, 0xFFFD}, {0x10000, 0xEFFFF},
    };
    return std::ranges::any_of(ranges,
                               [&](const auto& r) { return c >= r.first && c <= r.second; });
}

// The width of a line in a list; see line_list().
std::string width_words(const InkedLine& line, float widening)
{
    const float width = width_of(line);
    return is_one_stroke(line) ? fmt::format("{:.2f}", width)
                               : fmt::format("{:.2f}/{:.2f}", width, width * widening);
}

// Reads such a width, or nothing.
struct ListedWidth {
    float width, widened;
    bool outline;
};
std::optional<ListedWidth> width_in(const std::string& words)
{
    std::istringstream text(words);
    double width = 0, widened = 0;
    char slash = 0;
    text >> width;
    if (!text || !(width >= 0) || !(width < 1e6)) return std::nullopt;
    const bool outline = static_cast<bool>(text >> slash);
    if (outline && (slash != '/' || !(text >> widened) || !(widened >= 0) || !(widened < 1e6)))
        return std::nullopt;
    return ListedWidth{static_cast<float>(width), static_cast<float>(outline ? widened : width),
                       outline};
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

std::string layer_id(std::string_view name)
{
    std::string out;
    while (!name.empty()) {
        const Utf8Letter letter = first_letter(name);
        const std::size_t bytes = std::max<std::size_t>(1, letter.bytes);
        if (letter.bytes > 0 && stays_in_ids(letter.number))
            out += name.substr(0, bytes);
        else
            out += '-';
        name.remove_prefix(bytes);
    }
    return out.empty() ? "level" : out;
}

std::vector<std::string> names_apart(std::vector<std::string> names)
{
    std::set<std::string> taken{std::string(line_list_id), std::string(paper_id)};
    for (std::string& name : names) {
        const std::string own = name.empty() ? layer_id(name) : name;
        for (int n = 2; !taken.insert(layer_id(name)).second; ++n)
            name = fmt::format("{}.{}", own, n);
    }
    return names;
}

std::vector<std::string> layer_ids(std::span<const DrawingLayer> layers)
{
    std::vector<std::string> out;
    for (const DrawingLayer& layer : layers) out.push_back(layer.name);
    out = names_apart(std::move(out));
    for (std::string& name : out) name = layer_id(name);
    return out;
}

std::string short_number(double value)
{
    std::string out = fmt::format("{:.1f}", value);
    if (out.ends_with(".0")) out.resize(out.size() - 2);
    return out == "-0" ? "0" : out;
}

std::string hex_color(const glm::vec3& color)
{
    const glm::ivec3 c(glm::round(glm::clamp(color, 0.0f, 1.0f) * 255.0f));
    return fmt::format("#{:02x}{:02x}{:02x}", c.r, c.g, c.b);
}

std::string line_id(const std::string& layer_id, const InkedLine& line)
{
    return fmt::format("{}-{}{:x}", layer_id, line.hidden ? "h" : "s", line.id);
}

std::string line_list(const DrawingSheet& drawing, const HandEdits& edits)
{
    std::string out =
        fmt::format("\nsheet {} {} {}", short_number(drawing.size.x), short_number(drawing.size.y),
                    drawing.paper ? hex_color(*drawing.paper) : "none");
    std::set<std::string> listed;
    const std::vector<std::string> ids = layer_ids(drawing.layers);
    for (std::size_t i = 0; i < ids.size(); ++i)
        for (const InkedLine& line : drawing.layers[i].lines) {
            if (line.points.size() < 2) continue;
            const std::string id = line_id(ids[i], line);
            if (!listed.insert(id).second) continue;
            const auto edit = edits.by_line.find(id);
            const float widening = edit == edits.by_line.end() ? 1 : edit->second.widening;
            fmt::format_to(std::back_inserter(out), "\n{} {} {}{}", id, width_words(line, widening),
                           hex_color(line.points.front().color), point_list(line));
        }
    for (const auto& [id, edit] : edits.by_line)
        if (edit.deleted && !listed.contains(id)) out += "\n" + edit.listed;
    return out + "\n";
}

std::optional<std::string> layer_of_line(const std::string& id)
{
    const std::optional<ListedLine> line = parts_of(id);
    return line ? std::optional(line->layer) : std::nullopt;
}

std::optional<ListedSheet> listed_sheet(std::string_view text)
{
    std::istringstream words{std::string(text.substr(0, text.find('\n', text.find("sheet"))))};
    std::string first;
    ListedSheet out;
    if (!(words >> first >> out.width >> out.height >> out.paper) || first != "sheet")
        return std::nullopt;
    return out;
}

std::map<std::string, ListedLine> listed_lines(std::string_view text)
{
    std::map<std::string, ListedLine> out;
    std::istringstream lines{std::string(text)};
    std::size_t total = 0;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string id, width, color;
        if (!(words >> id >> width >> color)) continue;
        std::optional<ListedLine> listed = parts_of(id);
        const std::optional<ListedWidth> read = width_in(width);
        if (!listed || !read) continue;
        listed->width = read->width;
        listed->widened = read->widened;
        listed->outline = read->outline;
        listed->color = color;
        listed->text = line;
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
