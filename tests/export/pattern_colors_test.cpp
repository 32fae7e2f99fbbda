// SPDX-License-Identifier: GPL-3.0-or-later
// Patterns that fill objects, in files that know only colours of vertices.
#include "core/base/text.h"
#include "core/commands/cutting/split.h"
#include "core/commands/edits/edits.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/objects/shape.h"
#include "core/commands/volumes/lattice.h"
#include "core/export/animated_files.h"
#include "core/export/still_export.h"
#include "core/files/formats.h"
#include "core/files/read_model.h"
#include "tests/support/fixtures.h"
#include "tests/support/scenes/commands.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

namespace trivar {
namespace {

using namespace testing;

// A ball that a column has parted, with a pattern inside.
Document parted_ball(Filling inside)
{
    Document document =
        after(Document{}, AddSphere{.shape = {.radius = 1, .segments = 48, .rings = 24}});
    document = after(document, AddCylinder{.shape = {.radius = 0.2, .height = 4}});
    return after(document, Split{{1}, {.obstacles = {{.object = 2}}, .inside = inside}});
}

Export exported_first(const Document& document)
{
    return export_of(new_evaluator()(document, 1), {.document = document, .log = {}});
}

struct CapColors {
    std::size_t vertices = 0;
    float low = 1, high = 0; // of green
    const Material* material = nullptr;
};

// Returns the colours of the vertices at faces whose material is called "inside".
CapColors cap_colors(const Model& model)
{
    CapColors out;
    for (const Ref<Mesh>& mesh : model.meshes)
        for (std::size_t f = 0; f < mesh->face_count() && !mesh->face_material.empty(); ++f) {
            const Material& material = model.materials.at(mesh->face_material[f]);
            if (material.name != "inside" || mesh->colors.empty()) continue;
            out.material = &material;
            for (std::uint32_t c = mesh->face_begin[f]; c < mesh->face_begin[f + 1]; ++c) {
                const float green = mesh->colors[mesh->corners[c]].g;
                out.low = std::min(out.low, green);
                out.high = std::max(out.high, green);
                ++out.vertices;
            }
        }
    return out;
}

TEST(PatternColors, OfCapsAreInAGlbOnAWhiteMaterial)
{
    for (const Filling inside : {Filling::wood, Filling::flesh, Filling::metal}) {
        const Export made = exported_first(parted_ball(inside));
        const Model read = read_model_bytes(write_glb(made.model), "a.glb", "");
        const CapColors caps = cap_colors(read);
        ASSERT_GT(caps.vertices, 100u);
        EXPECT_GT(caps.high - caps.low, 0.05f);
        EXPECT_LT(caps.high, 0.9f);
        EXPECT_EQ(caps.material->base_color, glm::vec4(1));
        EXPECT_EQ(caps.material->metallic > 0.5f, inside == Filling::metal);
        // The skin keeps its own material, on white
        std::size_t white = 0;
        for (const Ref<Mesh>& mesh : read.meshes)
            white += static_cast<std::size_t>(std::ranges::count(mesh->colors, glm::vec4(1)));
        EXPECT_GT(white, 500u);
    }
}

TEST(PatternColors, AreNotThereWithoutAPattern)
{
    const Model plain = exported_first(parted_ball(Filling::none)).model;
    for (const Ref<Mesh>& mesh : plain.meshes) EXPECT_TRUE(mesh->colors.empty());
}

TEST(PatternColors, AreInObjAndPlyFiles)
{
    const Model model = exported_first(parted_ball(Filling::wood)).model;
    const ObjFiles obj = write_obj(model, "a");
    const Model read = read_model_bytes(obj.obj, "a.obj", ""),
                ply = read_model_bytes(write_ply(model), "a.ply", "");
    for (const Model* each : {&read, &ply}) {
        std::set<float> greens;
        for (const Ref<Mesh>& mesh : each->meshes)
            for (const glm::vec4& color : mesh->colors) greens.insert(color.g);
        EXPECT_GT(greens.size(), 20u);
        EXPECT_TRUE(greens.contains(1));
    }
}

TEST(PatternColors, FollowTheBodyThatAVolumeBends)
{
    Document document =
        after(Document{}, AddBox{.shape = {.size = {1, 1, 1}, .segments = {24, 24, 24}}});
    document = after(document, SetMaterial{{1}, {.filling = Filling::wood}});
    const Model straight = exported_first(document).model;
    document = after(document, AddLattice{.objects = {1}});
    document =
        after(document, MovePoints{.object = 2,
                                   .shift = {.points = {{1, 1, 3}, {2, 2, 3}}, .by = {0, 0, 0.5}}});
    const Model bent = exported_first(document).model;
    const auto boxes = [](const Model& model) {
        return *std::ranges::find_if(model.meshes,
                                     [](const Ref<Mesh>& mesh) { return mesh->face_count() > 0; });
    };
    EXPECT_FALSE(boxes(straight)->colors.empty());
    EXPECT_EQ(boxes(bent)->colors, boxes(straight)->colors);
    EXPECT_NE(boxes(bent)->positions, boxes(straight)->positions);
}

TEST(PatternColors, OfUsdAreTheDisplayColorThatMaterialsShow)
{
    const TemporaryFolder folder;
    const auto written = [&](Filling inside) {
        const std::string path = folder.file("a.usda");
        write_animated({parted_ball(inside), {1, 1}, 1e-3, ""},
                       std::make_shared<const AssetStore>(""), path);
        return read_text_file(path);
    };
    const std::string wood = written(Filling::wood), none = written(Filling::none);
    for (const char* part : {"inputs:varname = \"displayColor\"", "Color.outputs:result>"}) {
        EXPECT_TRUE(wood.find(part) != std::string::npos) << part;
        EXPECT_TRUE(none.find(part) == std::string::npos) << part;
    }
}

TEST(PatternColors, AreInAFilmAndInItsVerifiedCopy)
{
    const AnimatedScene scene{parted_ball(Filling::metal), {1, 2}, 1e-3, ""};
    const Ref<AssetStore> assets = std::make_shared<const AssetStore>("");
    const AnimatedExport made = animated_export(scene, assets);
    const CapColors caps = cap_colors(made.model);
    ASSERT_GT(caps.vertices, 100u);
    EXPECT_GT(caps.high - caps.low, 0.05f);
    EXPECT_EQ(write_glb(animated_export(scene, assets).model), write_glb(made.model));
}

} // namespace
} // namespace trivar
