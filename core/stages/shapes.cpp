// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stages/shapes.h"

#include "core/base/rejected.h"
#include "core/mesh/height_sheet.h"
#include "core/mesh/primitives.h"

#include <algorithm>
#include <fmt/format.h>

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
Model primitive(const SimplexSheetShape& s)
{
    Model model = model_of(simplex_sheet(s));
    for (Material& material : model.materials) material.double_sided = true;
    return model;
}
Model primitive(const TetrahedraShape&)
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

Model primitive(const HeightShape&)
{
    return {};
}

Model primitive(const VoxelShape&)
{
    return {};
}

struct Letters {
    Model model; // with its notices
    std::vector<std::string> lacks;
};
Letters letters(const TextShape& text, const AssetStore& assets)
{
    const FoundFont found = font_of(text, assets);
    TextBody body = text_body(text, found.font);
    Letters out{single_mesh_model("", std::move(body.mesh)), {}};
    out.model.notices = found.notices;
    // A missing installed font is replaced by another one; a missing font file is not.
    if (is_font_path(text.font)) out.lacks = found.notices;
    // A font that replaces another one needs no notice that its file differs.
    for (std::string& notice : body.notices)
        if (found.notices.empty() || !notice.ends_with(other_font_words))
            out.model.notices.push_back(std::move(notice));
    return out;
}

} // namespace

HeightSheet sheet_of(const HeightShape& s)
{
    return {s.size, s.height, s.level, s.segments, s.repeats ? ImageEdge::repeat : ImageEdge::stay};
}

FoundFont font_of(const TextShape& text, const AssetStore& assets)
{
    return find_font(is_font_path(text.font) ? assets.resolve(text.font) : text.font);
}

Ref<Shape> Shapes::operator()(const Source& source, Timings& timings, const Progress& progress)
{
    const auto found = std::ranges::find(known_, source, &std::pair<Source, Ref<Shape>>::first);
    if (found != known_.end()) return found->second;
    Shape shape;
    bool missing = false;
    try {
        if (const auto* file = std::get_if<ImportedFile>(&source)) {
            const AssetStore::LoadedModel loaded =
                timed(timings, "import", [&] { return assets_->load(*file, progress); });
            missing = !loaded.model;
            shape = shape_of(loaded.model ? loaded.model : make_ref(Model{}));
            shape.notices.insert(shape.notices.begin(), loaded.notices.begin(),
                                 loaded.notices.end());
            if (missing) shape.lacks = loaded.notices;
            if (file->subdivisions > 0)
                timed(timings, "subdivide",
                      [&] { subdivide(shape, file->subdivisions, progress); });
        } else if (const auto* text = std::get_if<TextShape>(&source)) {
            Letters made = timed(timings, "letters", [&] { return letters(*text, *assets_); });
            shape = shape_of(make_ref(std::move(made.model)));
            shape.notices.insert(shape.notices.begin(), shape.model->notices.begin(),
                                 shape.model->notices.end());
            shape.lacks.insert(shape.lacks.begin(), made.lacks.begin(), made.lacks.end());
        } else if (const auto* heights = std::get_if<HeightShape>(&source)) {
            const AssetStore::LoadedImage loaded = timed(timings, "import", [&] {
                return assets_->load_image(heights->image, heights->image_hash);
            });
            missing = !loaded.image;
            shape = shape_of(
                make_ref(loaded.image ? model_of(height_sheet(*loaded.image, sheet_of(*heights)))
                                      : Model{}));
            shape.notices.insert(shape.notices.begin(), loaded.notices.begin(),
                                 loaded.notices.end());
            if (missing) shape.lacks = loaded.notices;
        } else if (const auto* voxels = std::get_if<VoxelShape>(&source)) {
            shape = voxels_(*voxels, *assets_, timings, progress);
            missing = !shape.volume;
        } else
            shape = shape_of(timed(timings, "import", [&] {
                return make_ref(std::visit([](const auto& s) { return primitive(s); }, source));
            }));
    } catch (const Rejected& error) {
        if (!shape.materials) shape = shape_of(make_ref(Model{}));
        say_lacking(shape, error.what());
    }
    for (std::size_t i = 0; i < shape.meshes.size(); ++i)
        shape.meshes[i].slot = static_cast<int>(i);
    Ref<Shape> result = make_ref(std::move(shape));
    if (!missing) known_.emplace_back(source, result);
    return result;
}

void Shapes::forget_unused()
{
    std::erase_if(known_, [](const auto& known) { return known.second.use_count() == 1; });
}

} // namespace trivar
