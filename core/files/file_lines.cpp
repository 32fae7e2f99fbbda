// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/file_lines.h"

#include "core/files/file_sentences.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace trivar {

bool FileLines::add(std::span<const std::uint32_t> line, std::uint32_t material)
{
    open_ = false;
    if (line.size() > most_points_ - vertices_.size()) {
        ++without_room_;
        return false;
    }
    vertices_.insert(vertices_.end(), line.begin(), line.end());
    begin_.push_back(static_cast<std::uint32_t>(vertices_.size()));
    material_.push_back(material);
    return true;
}

void FileLines::add_edge(std::uint32_t a, std::uint32_t b, std::uint32_t material)
{
    const bool goes_on = open_ && vertices_.back() == a && material_.back() == material &&
                         vertices_.size() < most_points_;
    if (goes_on) {
        vertices_.push_back(b);
        ++begin_.back();
    } else {
        open_ = add(std::array{a, b}, material);
    }
}

Curves FileLines::curves(const std::vector<glm::vec3>& positions,
                         const std::vector<glm::vec4>& colors) const
{
    Curves out;
    Mesh points;
    for (std::size_t l = 0; l < count(); ++l) {
        const auto first = vertices_.begin() + begin_[l], end = vertices_.begin() + begin_[l + 1];
        if (!std::all_of(first, end, [&](std::uint32_t v) { return v < positions.size(); }))
            continue;
        for (auto v = first; v != end; ++v) {
            points.positions.push_back(positions[*v]);
            if (!colors.empty()) points.colors.push_back(colors[*v]);
        }
        out.begin.push_back(static_cast<std::uint32_t>(points.vertex_count()));
        out.material.push_back(material_[l]);
    }
    out.points = make_ref(std::move(points));
    return out;
}

std::string lines_without_room(std::size_t count)
{
    return fmt::format("{} left out: the curves of a file have at most {} points",
                       counted(count, "line was", "lines were"), most_curve_points);
}

} // namespace trivar
