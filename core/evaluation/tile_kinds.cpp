// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluation/tile_kinds.h"

#include <algorithm>

namespace trivar {
namespace {

glm::dmat4 turned(const Object& object)
{
    return glm::dmat4(glm::dmat3(object.transform.matrix()));
}

} // namespace

std::vector<TileKind> tile_kinds(const Stage& layer, const StepInput& input)
{
    const Tiling& tiling = *input.object.tiles;
    std::vector<TileKind> kinds{{.turned = turned(input.object), .weight = tiling.weight}};
    auto materials = static_cast<std::uint32_t>(layer.shape->materials->size());
    int meshes = 0;
    const auto count_meshes = [&](const std::vector<Part>& parts) {
        int next = meshes;
        for (const Part& part : parts) next = std::max(next, meshes + part.key.mesh + 1);
        meshes = next;
    };
    count_meshes(layer.own_parts);
    for (const MixedTile& each : tiling.others) {
        const auto found = input.done.find(each.object);
        if (found == input.done.end()) continue;
        const Object& other = object(input.document, each.object);
        if (other.tiles || found->second->parts.empty()) continue;
        kinds.push_back({found->second, turned(other), each.weight, materials, meshes});
        materials += static_cast<std::uint32_t>(found->second->materials->size());
        count_meshes(kinds.back().parts(layer));
    }
    return kinds;
}

Ref<std::vector<Material>> materials_of_others(const std::vector<TileKind>& kinds)
{
    if (kinds.size() < 2) return nullptr;
    std::vector<Material> all;
    for (const TileKind& kind : kinds)
        if (kind.other)
            all.insert(all.end(), kind.other->materials->begin(), kind.other->materials->end());
    return make_ref(std::move(all));
}

TileCell tile_cell(const std::vector<Part>& parts, const glm::dmat4& turned)
{
    Box box;
    for (const Part& part : parts) box.add(bounding_box(*part.rest, turned * part.to_world));
    const glm::dvec3 size = box.size(), middle = box.center();
    const double side = std::max({size.x, size.y, 1e-6 * size.z, 1e-9});
    return {{middle.x, middle.y, box.empty() ? 0 : box.lo.z}, side, size.z};
}

} // namespace trivar
