// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluation/pattern_colors.h"

#include "core/mesh/filling_colors.h"

#include <algorithm>

namespace trivar {
namespace {

bool has_patterns(const EvaluatedObject& object)
{
    return object.materials && std::ranges::any_of(*object.materials, [](const Material& m) {
               return m.filling != Filling::none;
           });
}

Ref<Mesh> with_colors(const Mesh& mesh, std::vector<glm::vec4> colors)
{
    Mesh out = mesh;
    out.colors = std::move(colors);
    return make_ref(std::move(out));
}

Lazy<Ref<Mesh>> with_colors_of(const Lazy<Ref<Mesh>>& mesh, const Ref<Mesh>& colored)
{
    return Lazy<Ref<Mesh>>([mesh, colored] { return with_colors(**mesh, colored->colors); });
}

// Returns the mesh that a pattern follows: the part before it was deformed or split.
const Ref<Mesh>& pattern_space(const Part& part)
{
    const bool split = part.before_split && !part.bent && !part.posed &&
                       part.before_split->vertex_count() == part.rest->vertex_count();
    return split ? part.before_split : part.rest.ref();
}

} // namespace

void PatternColors::color(Part& part, const Ref<std::vector<Material>>& materials)
{
    const Ref<Mesh> at_rest = pattern_space(part);
    Ref<Mesh>& known = meshes_[{part.rest.ref(), at_rest, materials}];
    if (!known) {
        const Box box = part.drawn_from_tiles() ? part.tiles->box : bounding_box(*at_rest);
        std::vector<glm::vec4> colors = filling_colors(*part.rest, *at_rest, box, *materials);
        known = colors.empty() ? part.rest.ref() : with_colors(*part.rest, std::move(colors));
    }
    if (known == part.rest.ref()) return;
    part.rest = known;
    part.tiles = nullptr;
    if (part.posed) {
        Ref<PosedMesh>& posed = posed_[{part.posed, known}];
        if (!posed)
            posed = make_ref(
                PosedMesh{known, part.posed->pose, with_colors_of(part.posed->mesh, known)});
        part.posed = posed;
    }
    if (part.bent) {
        Ref<Deformation>& bent = bent_[{part.bent, known}];
        if (!bent) {
            Deformation made = *part.bent;
            made.mesh = with_colors_of(made.mesh, known);
            bent = make_ref(std::move(made));
        }
        part.bent = bent;
    }
}

Ref<EvaluatedObject> PatternColors::colored(const EvaluatedObject& object)
{
    EvaluatedObject out = object;
    for (Part& part : out.parts) color(part, object.materials);
    Ref<std::vector<Material>>& known = materials_[object.materials];
    if (!known) {
        std::vector<Material> plain;
        for (const Material& material : *object.materials)
            plain.push_back(without_filling(material));
        known = make_ref(std::move(plain));
    }
    out.materials = known;
    return make_ref(std::move(out));
}

Evaluation PatternColors::operator()(Evaluation evaluated)
{
    for (auto& [id, object] : evaluated.objects) {
        if (!has_patterns(*object)) continue;
        Ref<EvaluatedObject>& known = objects_[object];
        if (!known) known = colored(*object);
        object = known;
    }
    return evaluated;
}

} // namespace trivar
