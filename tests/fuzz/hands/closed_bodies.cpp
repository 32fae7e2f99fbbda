// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/hands/closed_bodies.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace trivar::testing {

bool encloses(const Mesh& mesh)
{
    std::map<std::array<float, 3>, std::uint32_t> numbers; // 0 and -0 are equal there
    std::vector<std::uint32_t> number;
    for (const glm::vec3& p : mesh.positions)
        number.push_back(
            numbers.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(numbers.size()))
                .first->second);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> more_one_way;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const std::uint32_t begin = mesh.face_begin[f], end = mesh.face_begin[f + 1];
        for (std::uint32_t c = begin; c < end; ++c) {
            const std::uint32_t a = number[mesh.corners[c]];
            const std::uint32_t b = number[mesh.corners[c + 1 < end ? c + 1 : begin]];
            if (a != b) more_one_way[std::minmax(a, b)] += a < b ? 1 : -1;
        }
    }
    return std::ranges::all_of(more_one_way, [](const auto& edge) { return edge.second == 0; });
}

std::string open_part(const Object& object, const EvaluatedObject& shown)
{
    if (object.tiles || (object.cutting && !object.cutting->capped) ||
        (object.splitting && object.splitting->closing == SplitClosing::open))
        return {};
    const auto& meshes = shown.shape->meshes;
    if (meshes.empty() || !std::ranges::all_of(meshes, [](const Shape::NodeMesh& each) {
            return encloses(*each.rest);
        }))
        return {};
    for (std::size_t i = 0; i < shown.parts.size(); ++i)
        if (!encloses(*shown.parts[i].mesh()))
            return fmt::format("part {} of {} is open, and its shape is closed", i + 1,
                               object.name);
    return {};
}

} // namespace trivar::testing
