// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluation/shapes.h"

#include "core/base/rejected.h"
#include "core/mesh/primitives.h"
#include "core/mesh/subdivide.h"

#include <algorithm>

namespace trivar {
namespace {

Model model_of(const Mesh& mesh)
{
    return single_mesh_model("", mesh);
}
Model primitive(const GroupShape&)
{
    return {};
}
Model primitive(const LatticeShape&)
{
    return {};
}
Model primitive(const ImportedFile&)
{
    return {};
}
Model primitive(const PlaneShape& s)
{
    return model_of(plane_mesh(s.size, s.segments));
}
Model primitive(const BoxShape& s)
{
    return model_of(box_mesh(s.size, s.segments));
}
Model primitive(const SphereShape& s)
{
    return model_of(sphere_mesh(s.radius, s.segments, s.rings));
}
Model primitive(const CylinderShape& s)
{
    return model_of(cylinder_mesh(s.radius, s.height, s.segments, s.stacks));
}
Model primitive(const TorusShape& s)
{
    return model_of(torus_mesh(s.radius, s.tube, s.segments));
}
Model primitive(const MoebiusShape& s)
{
    Model model = model_of(moebius_mesh(s.radius, s.width, s.segments));
    for (Material& material : model.materials) material.double_sided = true;
    return model;
}
Model primitive(const TeapotShape& s)
{
    return model_of(teapot_mesh(s.height, s.resolution));
}

Model primitive(const TextShape&)
{
    return {};
}

// The model, what there is to say of it in its notices.
Model letters(const TextShape& text, const AssetStore& assets)
{
    const FoundFont found = font_of(text, assets);
    TextBody body = text_body(text, found.font);
    Model model = single_mesh_model("", std::move(body.mesh));
    model.notices = found.notices;
    // That it is another file goes without saying where another font stands in.
    for (std::string& notice : body.notices)
        if (found.notices.empty() || notice.find("that was meant") == notice.npos)
            model.notices.push_back(std::move(notice));
    return model;
}

Shape shape_of(Ref<Model> from)
{
    Shape shape;
    const Model& model = *from;
    for (std::size_t i = 0; i < model.nodes.size(); ++i)
        if (const int mesh = model.nodes[i].mesh; mesh >= 0)
            shape.meshes.push_back({.rest = model.meshes[static_cast<std::size_t>(mesh)],
                                    .node = static_cast<int>(i)});
    shape.materials =
        make_ref(model.materials.empty() ? std::vector<Material>(1) : model.materials);
    shape.model = std::move(from);
    stand(shape, nullptr, 0);
    return shape;
}

// Meshes that hang on several nodes are subdivided once.
void subdivide_all(Shape& shape, int levels, const Progress& progress)
{
    std::map<Ref<Mesh>, Ref<Mesh>> done;
    bool bends = false;
    for (Shape::Hung& hung : shape.meshes) {
        bends |= hung.posed != nullptr || !hung.rest->morph_targets.empty();
        const auto [entry, fresh] = done.try_emplace(hung.mesh());
        if (fresh) entry->second = make_ref(subdivide(*hung.mesh(), levels, progress));
        hung.rest = entry->second;
        hung.posed = nullptr;
    }
    if (bends)
        shape.notices.emplace_back(
            "what is subdivided stands as it came: skins and morph targets do not move it");
}

} // namespace

FoundFont font_of(const TextShape& text, const AssetStore& assets)
{
    return find_font(is_font_path(text.font) ? assets.resolve(text.font) : text.font);
}

void stand(Shape& shape, const Clip* clip, double time_s)
{
    stand(shape, stance_at(*shape.model, clip, time_s));
}

void stand(Shape& shape, const Stance& stance)
{
    const Model& model = *shape.model;
    for (Shape::Hung& hung : shape.meshes) {
        hung.to_model = mesh_to_model(model, hung.node, stance);
        const bool bends = !hung.rest->influences.empty() || !hung.rest->morph_targets.empty();
        Pose pose = bends ? pose_of(model, hung.node, stance) : Pose{};
        hung.posed = pose.empty() ? nullptr : posed_later(hung.rest, std::move(pose));
    }
}

Ref<Shape> Shapes::operator()(const Source& source, Timings& timings, const Progress& progress)
{
    const auto found = std::ranges::find(known_, source, &std::pair<Source, Ref<Shape>>::first);
    if (found != known_.end()) return found->second;
    Shape shape;
    bool missing = false;
    try {
        if (const auto* file = std::get_if<ImportedFile>(&source)) {
            const AssetStore::Loaded loaded =
                timed(timings, "import", [&] { return assets_->load(*file, progress); });
            missing = !loaded.model;
            shape = shape_of(loaded.model ? loaded.model : make_ref(Model{}));
            shape.notices = loaded.notices;
            if (file->subdivisions > 0)
                timed(timings, "subdivide",
                      [&] { subdivide_all(shape, file->subdivisions, progress); });
        } else if (const auto* text = std::get_if<TextShape>(&source)) {
            shape = shape_of(
                make_ref(timed(timings, "letters", [&] { return letters(*text, *assets_); })));
            shape.notices = shape.model->notices;
        } else
            shape = shape_of(timed(timings, "import", [&] {
                return make_ref(std::visit([](const auto& s) { return primitive(s); }, source));
            }));
    } catch (const Rejected& error) {
        if (!shape.materials) shape = shape_of(make_ref(Model{}));
        shape.notices.emplace_back(error.what());
    }
    Ref<Shape> result = make_ref(std::move(shape));
    if (!missing) known_.emplace_back(source, result);
    return result;
}

void Shapes::forget_unused()
{
    std::erase_if(known_, [](const auto& known) { return known.second.use_count() == 1; });
}

} // namespace trivar
