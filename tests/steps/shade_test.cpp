// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/commands/objects/group.h"
#include "core/commands/objects/import.h"
#include "core/commands/objects/play.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/objects/shade.h"
#include "core/commands/objects/simplify.h"
#include "core/commands/objects/unwrap.h"
#include "core/commands/paste.h"
#include "core/commands/volumes/lattice.h"
#include "core/commands/volumes/warp.h"
#include "core/document/document_digest.h"
#include "core/evaluation/evaluate.h"
#include "core/files/write_model.h"
#include "core/mesh/adjacency.h"
#include "tests/support/fixtures.h"
#include "tests/support/rigged.h"
#include "tests/support/scenes/commands.h"

#include <cmath>
#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::HasSubstr;
using testing::new_evaluator;
using ::testing::ThrowsMessage;

Ref<EvaluatedObject> shaded(const Document& document, Id id = 1, double frame = 1)
{
    return new_evaluator()(document, frame).objects.at(id);
}

Document a_ball()
{
    return after(Document{}, AddSphere{.shape = {.radius = 1, .segments = 24, .rings = 12}});
}

// The greatest angle in degrees between the normals of corners and those of their faces.
double off_the_faces(const Mesh& mesh)
{
    double least = 1;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c)
            least = std::min(least, glm::dot(glm::normalize(area_normal(mesh, f)),
                                             glm::dvec3(mesh.normals[mesh.corners[c]])));
    return glm::degrees(std::acos(std::clamp(least, -1.0, 1.0)));
}

std::vector<glm::vec3> corner_places(const Mesh& mesh)
{
    std::vector<glm::vec3> out;
    for (const std::uint32_t v : mesh.corners) out.push_back(mesh.positions[v]);
    return out;
}

TEST(ShadedObjects, AreFlatSmoothOrSharpAtAnAngleAndKeepTheirSurface)
{
    const Mesh before = *shaded(a_ball())->parts.at(0).mesh();
    const auto mesh = [&](FaceShading shading) {
        return *shaded(after(a_ball(), Shade{{1}, shading}))->parts.at(0).mesh();
    };
    EXPECT_GT(off_the_faces(before), 5);
    EXPECT_LT(off_the_faces(mesh({ShadingWay::flat})), 1);
    EXPECT_GT(off_the_faces(mesh({ShadingWay::smooth})), 5);
    EXPECT_LT(off_the_faces(mesh({ShadingWay::by_angle, 1})), 1);
    EXPECT_GT(off_the_faces(mesh({ShadingWay::by_angle, 35})), 5);
    for (const ShadingWay way : {ShadingWay::flat, ShadingWay::smooth, ShadingWay::by_angle}) {
        EXPECT_EQ(corner_places(mesh({way})), corner_places(before));
        EXPECT_TRUE(Adjacency(mesh({way})).is_closed());
    }
}

TEST(ShadedObjects, AreSeveralAtOnceAndGetTheirOwnShadingBack)
{
    const Document two = after(a_ball(), AddSphere{});
    const Document flat = after(two, Shade{{1, 2}, {ShadingWay::flat}});
    EXPECT_LT(off_the_faces(*shaded(flat, 2)->parts.at(0).mesh()), 1);
    EXPECT_NE(digest(flat), digest(two));
    EXPECT_EQ(digest(after(flat, Shade{{1, 2}, {}})), digest(two));
}

TEST(ShadedObjects, AreCopiedAsTheyAre)
{
    const Document flat = after(a_ball(), Shade{{1}, {ShadingWay::by_angle, 12}});
    const Document both = after(flat, copied(flat, {1}, "/nowhere"));
    EXPECT_EQ(both.objects.at(2)->shading, flat.objects.at(1)->shading);
}

TEST(ShadedObjects, AreNoGroups)
{
    EXPECT_THAT(
        [] {
            after(after(a_ball(), Group{{1}}), Shade{{2}, {ShadingWay::flat}});
        },
        ThrowsMessage<Rejected>(HasSubstr("shade the objects in it")));
    EXPECT_THAT(
        [] {
            after(a_ball(), Shade{{1}, {ShadingWay::by_angle, 181}});
        },
        ThrowsMessage<Rejected>(HasSubstr("angle_deg")));
}

TEST(ShadedObjects, AreSimplifiedUnwrappedAndBentInTheSamePlacesAndStayFlat)
{
    const auto places_when = [](std::optional<FaceShading> shading, bool flat) {
        Document document = after(a_ball(), Simplify{{1}, {.keep = 0.5}});
        document = after(document, Unwrap{{1}, {}});
        document = after(document, AddLattice{.objects = {1}, .shape = {.size = {2, 2, 2}}});
        document = after(document, WarpVolume{2, {.twist_deg = 20}});
        if (shading) document = after(document, Shade{{1}, *shading});
        const Mesh mesh = *shaded(document)->parts.at(0).mesh();
        EXPECT_EQ(off_the_faces(mesh) < 8, flat); // exact normals of the bent facets
        return corner_places(mesh);
    };
    EXPECT_EQ(places_when({}, false), places_when(FaceShading{ShadingWay::flat}, true));
}

TEST(ShadedObjects, OfFilesWithoutNormalsLoseTheSameTrianglesAsSmoothOnes)
{
    const testing::TemporaryFolder folder;
    const auto simplified = [&](const std::string& name) {
        write_model(single_mesh_model("ball", *shaded(a_ball())->parts.at(0).mesh()),
                    folder.file(name));
        const AssetStore assets(folder.path().string());
        ImportModel import;
        import.file.path = folder.file(name);
        Document document = after(Document{}, prepare(import, assets));
        document = after(document, Simplify{{1}, {.keep = 0.3}});
        Evaluator evaluate(std::make_shared<const AssetStore>(folder.path().string()));
        return *evaluate(document).objects.at(1)->parts.at(0).mesh();
    };
    const Mesh facets = simplified("a.stl"), by_angle = simplified("a.off");
    EXPECT_LT(off_the_faces(facets), 0.1);
    EXPECT_EQ(corner_places(facets).size(), corner_places(by_angle).size());
}

TEST(ShadedObjects, OfAClipAreShadedOnceAndMoveWithIt)
{
    const testing::TemporaryFolder folder;
    write_model(testing::rigged_model(), folder.file("a.glb"));
    const AssetStore assets(folder.path().string());
    ImportModel import;
    import.file.path = folder.file("a.glb");
    Document document = after(Document{}, prepare(import, assets));
    document = after(document, PlayClip{{1}, {.clip = "bend"}});
    Evaluator evaluate(std::make_shared<const AssetStore>(folder.path().string()));
    const Document flat = after(document, Shade{{1}, {ShadingWay::flat}});
    const auto part = [&](const Document& of, double frame) {
        return evaluate(of, frame).objects.at(1)->parts.at(0);
    };
    EXPECT_EQ(part(flat, 1).rest, part(flat, 13).rest);
    for (const double frame : {1.0, 13.0})
        EXPECT_EQ(corner_places(*part(flat, frame).mesh()),
                  corner_places(*part(document, frame).mesh()));
    EXPECT_LT(off_the_faces(*part(flat, 13).mesh()), 30);
}

} // namespace
} // namespace trivar
