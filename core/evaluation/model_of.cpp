// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluation/evaluate.h"
#include "core/mesh/mesh_materials.h"

#include <algorithm>

namespace trivar {
namespace {

Ref<Mesh> with_materials_from(const Ref<Mesh>& mesh, std::uint32_t first)
{
    if (first == 0) return mesh;
    return make_ref(with_materials_from(Mesh(*mesh), first));
}

Ref<Curves> with_materials_from(const Ref<Curves>& curves, std::uint32_t first)
{
    if (first == 0) return curves;
    Curves moved = *curves;
    moved.material.resize(moved.line_count(), 0);
    for (std::uint32_t& material : moved.material) material += first;
    return make_ref(std::move(moved));
}

// Returns the node of a group, or of an object of several parts, and makes it and its parents when
// it is first needed. Its transform is the identity: parts are in world space, to the last bit.
int group_node(Model& model, std::map<Id, int>& nodes, const Document& document, Id group)
{
    if (group == 0) return -1;
    if (const auto found = nodes.find(group); found != nodes.end()) return found->second;
    const Object& each = object(document, group);
    const int parent = group_node(model, nodes, document, each.parent);
    model.nodes.push_back({.name = each.name, .parent = parent});
    return nodes[group] = static_cast<int>(model.nodes.size()) - 1;
}

} // namespace

Model model_of(const Evaluation& evaluated, const Document& document)
{
    Model model;
    std::map<Ref<std::vector<Material>>, std::uint32_t> first_of;
    std::map<std::pair<Ref<Mesh>, std::uint32_t>, Ref<Mesh>> moved; // copies share their mesh
    std::map<Id, int> groups;
    const auto parent_in_file = [&, &document = document](Id id, const EvaluatedObject& effects) {
        if (effects.parts.size() + effects.curves.size() > 1)
            return group_node(model, groups, document, id);
        return group_node(model, groups, document, object(document, id).parent);
    };
    for (const auto& [id, ref] : evaluated.objects) {
        const auto [first, fresh] = first_of.try_emplace(
            ref->materials, static_cast<std::uint32_t>(model.materials.size()));
        if (fresh)
            model.materials.insert(model.materials.end(), ref->materials->begin(),
                                   ref->materials->end());
        if (ref->parts.empty()) continue;
        const Object& source = object(document, id);
        const int parent = parent_in_file(id, *ref);
        for (const Part& part : ref->parts) {
            model.nodes.push_back({.name = name_of_part(*ref, source, part.key),
                                   .parent = parent,
                                   .to_parent = part.to_world,
                                   .mesh = static_cast<int>(model.meshes.size())});
            Ref<Mesh>& mesh = moved[{part.mesh(), first->second}];
            if (!mesh) mesh = with_materials_from(part.mesh(), first->second);
            model.meshes.push_back(mesh);
        }
    }
    for (const auto& [id, ref] : evaluated.objects)
        for (const CurvePart& part : ref->curves) {
            const Object& source = object(document, id);
            model.nodes.push_back({.name = source.name,
                                   .parent = parent_in_file(id, *ref),
                                   .to_parent = part.points.to_world,
                                   .curves = static_cast<int>(model.curves.size())});
            Curves there{part.points.mesh(), part.curves->begin, part.curves->material};
            model.curves.push_back(
                with_materials_from(make_ref(std::move(there)), first_of.at(ref->materials)));
        }
    if (model.materials.empty()) model.materials.emplace_back();
    return model;
}

std::string name_of_part(const EvaluatedObject& effects, const Object& object, const PartKey& key)
{
    const std::vector<Shape::NodeMesh>& meshes = effects.shape->meshes;
    const auto hung = std::ranges::find(meshes, key.mesh, &Shape::NodeMesh::slot);
    if (meshes.size() < 2 || hung == meshes.end()) return object.name;
    return object.name + " " +
           effects.shape->model->nodes[static_cast<std::size_t>(hung->node)].name;
}

} // namespace trivar
