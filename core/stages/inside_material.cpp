// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stages/inside_material.h"

#include <algorithm>

namespace trivar {

InsideMaterial inside_material(const Stage& stage, Filling filling)
{
    InsideMaterial out{stage.mixed_materials, 0};
    if (filling == Filling::none) return out;
    std::vector<Material> all;
    if (stage.mixed_materials) all = *stage.mixed_materials;
    out.number = static_cast<std::uint32_t>(stage.shape->materials->size() + all.size());
    Material inside;
    inside.name = "inside";
    inside.filling = filling;
    all.push_back(inside);
    out.beside = make_ref(std::move(all));
    return out;
}

Material material_of(const Surfacing& surfacing)
{
    Material plain;
    plain.base_color = surfacing.base_color;
    plain.metallic = surfacing.metallic;
    plain.roughness = surfacing.roughness;
    plain.filling = surfacing.filling;
    plain.emissive = surfacing.glow * glm::vec3(surfacing.base_color);
    if (surfacing.base_color.a < 1) plain.alpha = Material::Alpha::blend;
    return plain;
}

bool is_filled(const Stage& stage, Filling inside, const std::optional<Surfacing>& surfacing)
{
    return inside != Filling::none || (surfacing && surfacing->filling != Filling::none) ||
           std::ranges::any_of(*stage.shape->materials,
                               [](const Material& m) { return m.filling != Filling::none; });
}

} // namespace trivar
