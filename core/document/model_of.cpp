// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/evaluate.h"

namespace trivar {
namespace {

Ref<Mesh> with_materials_from(const Ref<Mesh>& mesh, std::uint32_t first)
{
    if (first == 0) return mesh;
    Mesh moved = *mesh;
    moved.face_material.resize(moved.face_count(), 0);
    for (std::uint32_t& material : moved.face_material) material += first;
    return make_ref(std::move(moved));
}

} // namespace

Model model_of(const Evaluated& evaluated, const Document& document)
{
    Model model;
    std::map<Ref<std::vector<Material>>, std::uint32_t> first_of;
    for (const auto& [id, ref] : evaluated.objects) {
        const auto [first, fresh] = first_of.try_emplace(
            ref->materials, static_cast<std::uint32_t>(model.materials.size()));
        if (fresh)
            model.materials.insert(model.materials.end(), ref->materials->begin(),
                                   ref->materials->end());
        for (const Part& part : ref->parts) {
            model.nodes.push_back({.name = object(document, id).name,
                                   .to_parent = part.to_world,
                                   .mesh = static_cast<int>(model.meshes.size())});
            model.meshes.push_back(with_materials_from(part.mesh, first->second));
        }
    }
    if (model.materials.empty()) model.materials.emplace_back();
    return model;
}

} // namespace trivar
