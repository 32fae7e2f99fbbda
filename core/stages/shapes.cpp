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
Model primitive(const SimplexSheetShape& s)
{
    Model model = model_of(simplex_sheet(s));
    for (Material& material : model.materials) material.double_sided = true;
    return model;
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

// A Making makes the shape of one source. What it made before it threw is kept.
struct Making {
    const AssetStore& assets;
    VoxelShapes& voxels;
    Timings& timings;
    const Progress& progress;
    Shape shape = {};
    bool missing = false; // its file

    void take(const std::vector<std::string>& notices)
    {
        shape.notices.insert(shape.notices.begin(), notices.begin(), notices.end());
        if (missing) shape.lacks = notices;
    }
    template <class Primitive> void operator()(const Primitive& source)
    {
        shape = shape_of(timed(timings, "import", [&] {
            if constexpr (object_kind<Primitive>.has_surface)
                return make_ref(primitive(source));
            else
                return make_ref(Model{});
        }));
    }
    void operator()(const ImportedFile& file)
    {
        const AssetStore::LoadedModel loaded =
            timed(timings, "import", [&] { return assets.load(file, progress); });
        missing = !loaded.model;
        shape = shape_of(loaded.model ? loaded.model : make_ref(Model{}));
        take(loaded.notices);
        if (file.subdivisions > 0)
            timed(timings, "subdivide", [&] { subdivide(shape, file.subdivisions, progress); });
    }
    void operator()(const TextShape& text)
    {
        Letters made = timed(timings, "letters", [&] { return letters(text, assets); });
        shape = shape_of(make_ref(std::move(made.model)));
        take(shape.model->notices);
        shape.lacks.insert(shape.lacks.begin(), made.lacks.begin(), made.lacks.end());
    }
    void operator()(const HeightShape& heights)
    {
        const AssetStore::LoadedImage loaded = timed(timings, "import", [&] {
            return assets.load_image(heights.image, heights.image_hash);
        });
        missing = !loaded.image;
        shape = shape_of(make_ref(
            loaded.image ? model_of(height_sheet(*loaded.image, sheet_of(heights))) : Model{}));
        take(loaded.notices);
    }
    void operator()(const VoxelShape& data)
    {
        shape = voxels(data, assets, timings, progress);
        missing = !shape.volume;
    }
};

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
    Making making{*assets_, voxels_, timings, progress};
    Shape& shape = making.shape;
    try {
        std::visit(making, source);
    } catch (const Rejected& error) {
        if (!shape.materials) shape = shape_of(make_ref(Model{}));
        say_lacking(shape, error.what());
    }
    for (std::size_t i = 0; i < shape.meshes.size(); ++i)
        shape.meshes[i].slot = static_cast<int>(i);
    Ref<Shape> result = make_ref(std::move(shape));
    if (!making.missing) known_.emplace_back(source, result);
    return result;
}

void Shapes::forget_unused()
{
    std::erase_if(known_, [](const auto& known) { return known.second.use_count() == 1; });
}

} // namespace trivar
