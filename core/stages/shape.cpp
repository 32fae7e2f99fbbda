// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stages/shape.h"

#include "core/mesh/subdivide.h"

#include <fmt/format.h>
#include <map>

namespace trivar {
namespace {

// Measures each mesh once, also if several nodes have it.
void measure(Shape& shape)
{
    std::map<Ref<Mesh>, Ref<Extent>> known;
    for (Shape::NodeMesh& hung : shape.meshes) {
        Ref<Extent>& extent = known[hung.rest];
        if (!extent) extent = std::make_shared<const Extent>(hung.rest);
        hung.extent = extent;
    }
}

// Measures curves once, also if several nodes have them.
void hang_curves(Shape& shape, const Model& model)
{
    std::vector<Box> bounds;
    for (const Ref<Curves>& curves : model.curves) bounds.push_back(bounding_box(*curves->points));
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        if (model.nodes[i].curves < 0) continue;
        const auto which = static_cast<std::size_t>(model.nodes[i].curves);
        shape.curves.push_back({.curves = model.curves[which],
                                .node = static_cast<int>(i),
                                .slot = static_cast<int>(shape.curves.size()),
                                .bounds = bounds[which]});
    }
}

// Removes meshes and curves whose coordinates are too large, and sets the bounds of the others.
void leave_out_what_is_too_large(Shape& shape)
{
    if (std::erase_if(shape.curves, [](const Shape::NodeCurves& hung) {
            return !within_reach(hung.bounds, hung.to_model);
        }) > 0)
        say_lacking(shape,
                    fmt::format("curves are left out: their coordinates are {}", too_large_words));
    const std::size_t all = shape.meshes.size();
    const std::size_t gone = std::erase_if(shape.meshes, [](Shape::NodeMesh& hung) {
        const std::optional<Box> box = hung.extent->posed(hung.posed ? &hung.posed->pose : nullptr);
        if (box) hung.bounds = *box;
        return !box || !within_reach(*box, hung.to_model);
    });
    if (gone == 0) return;
    say_lacking(shape,
                gone == all
                    ? fmt::format("its coordinates are {}", too_large_words)
                    : fmt::format("{} of its {} meshes are left out: their coordinates are {}",
                                  gone, all, too_large_words));
}

} // namespace

void say_lacking(Shape& shape, const std::string& why)
{
    shape.notices.push_back(why);
    shape.lacks.push_back(why);
}

Shape shape_of(Ref<Model> from)
{
    Shape shape;
    const Model& model = *from;
    for (std::size_t i = 0; i < model.nodes.size(); ++i)
        if (const int mesh = model.nodes[i].mesh; mesh >= 0)
            shape.meshes.push_back({.rest = model.meshes[static_cast<std::size_t>(mesh)],
                                    .node = static_cast<int>(i)});
    hang_curves(shape, model);
    measure(shape);
    shape.materials =
        make_ref(model.materials.empty() ? std::vector<Material>(1) : model.materials);
    shape.model = std::move(from);
    stand(shape, nullptr, 0);
    return shape;
}

void stand(Shape& shape, const Clip* clip, double time_s)
{
    stand(shape, stance_at(*shape.model, clip, time_s));
}

void stand(Shape& shape, const Stance& stance)
{
    const Model& model = *shape.model;
    for (Shape::NodeMesh& hung : shape.meshes) {
        hung.to_model = mesh_to_model(model, hung.node, stance);
        const bool bends = !hung.rest->influences.empty() || !hung.rest->morph_targets.empty();
        Pose pose = bends ? pose_of(model, hung.node, stance) : Pose{};
        hung.posed = pose.empty() ? nullptr : posed_later(hung.rest, std::move(pose));
    }
    for (Shape::NodeCurves& hung : shape.curves)
        hung.to_model = stance.to_model[static_cast<std::size_t>(hung.node)];
    leave_out_what_is_too_large(shape);
}

// Subdivides each mesh once, also if several nodes have it.
void subdivide(Shape& shape, int levels, const Progress& progress)
{
    std::map<Ref<Mesh>, Ref<Mesh>> done;
    bool bends = false;
    for (Shape::NodeMesh& hung : shape.meshes) {
        bends |= hung.posed != nullptr || !hung.rest->morph_targets.empty();
        const auto [entry, fresh] = done.try_emplace(hung.mesh());
        hung.cage = hung.mesh();
        if (fresh) entry->second = make_ref(subdivide(*hung.cage, levels, progress));
        hung.rest = entry->second;
        hung.posed = nullptr;
    }
    measure(shape);
    leave_out_what_is_too_large(shape);
    if (bends)
        shape.notices.emplace_back(
            "a subdivided model stays in its rest pose: skins and morph targets do not move it");
}

} // namespace trivar
