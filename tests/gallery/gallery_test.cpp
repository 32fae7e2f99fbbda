// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures of docs/gallery.md and the README are what these scenes give today.

#include "core/base/text.h"
#include "core/certificate/film_check.h"
#include "core/commands/placement/travel.h"
#include "core/document/parameters.h"
#include "core/export/animated_model.h"
#include "core/placement/view.h"
#include "core/scene/log.h"
#include "editor/picture/captions.h"
#include "editor/picture/picture.h"
#include "editor/record/contact_sheet.h"
#include "gpu/context.h"
#include "gpu/ffd/deform_timer.h"
#include "gpu/ffd/device_poser.h"
#include "gpu/renderer.h"
#include "tests/gallery/scenes.h"
#include "tests/golden/pictures.h"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <map>

namespace trivar {
namespace {

constexpr glm::ivec2 gallery_size_px{1280, 720};

struct Scene {
    Document document;
    Evaluation evaluated;
};

// The models as this build made them, in whatever folder it is.
std::map<std::string, std::string> models_made_here()
{
    std::map<std::string, std::string> out;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(TRIVAR_BINARY_DIR "/assets/models"))
        out[entry.path().filename()] = entry.path();
    return out;
}

const std::string scenes_folder = TRIVAR_SOURCE_DIR "/assets/scenes";
using testing::every_scene;

Document document_of(const std::string& name, const std::string& folder = scenes_folder)
{
    const std::string path = folder + "/" + name + ".trivar";
    return replay(read_log(read_text_file(path), path)).document();
}

Evaluator evaluator_here()
{
    return Evaluator(std::make_shared<const AssetStore>(scenes_folder, models_made_here()));
}

Scene replayed(const std::string& name)
{
    const Document document = document_of(name);
    return {document_at(document, document.time.first_frame), evaluator_here()(document)};
}

// Returns the scene in its first frame, or in the one that says what it is about.
Scene shown(const std::string& name)
{
    const std::optional<int> frame = testing::shown_frame(name);
    if (!frame) return replayed(name);
    const Document document = document_of(name);
    return {document_at(document, *frame), evaluator_here()(document, *frame)};
}

class Gallery : public ::testing::TestWithParam<std::string> {};

TEST_P(Gallery, ShowsTheSceneAsItIs)
{
    const Scene scene = shown(GetParam());
    const gpu::HeadlessContext context;
    gpu::Renderer renderer;
    const Camera camera = picture_camera(scene.evaluated, scene.document, gallery_size_px);
    ShownValues values;
    Image image = renderer.render(picture_of(scene.evaluated, scene.document, camera, values),
                                  gallery_size_px);
    if (scene.document.render->captions)
        image = with_captions(std::move(image), captions_of(scene.evaluated, scene.document),
                              camera, *scene.document.render);
    EXPECT_TRUE(testing::matches_picture(image, "docs/gallery/" + GetParam() + ".png"));
}

// Seen from where a stroke was drawn, nothing that it fell on is before the surface that was laid
// on it: by rays of our own, denser than the nodes, to a hundredth of the volume's height.
TEST_P(Gallery, LaysNothingIntoWhatItLiesOn)
{
    const Scene scene = replayed(GetParam());
    int rays = 0, seen = 0;
    for (const auto& [id, o] : scene.evaluated.objects) {
        if (!o->placement || !o->lies_on || o->shaped) continue;
        const PlacementStep& step = *object(scene.document, id).stroke;
        if (step.parameters.contact_level > 0) continue; // what hangs below it reaches in
        const View view(step.sketch.camera);
        const double slack = 1e-2 * o->placement->report.height_world;
        for (int i = 1; i < 60; ++i)
            for (int j = 1; j < 12; ++j) {
                const glm::dvec3 p = evaluate(o->placement->contact, {i / 60.0, j / 12.0}).value;
                const Ray ray = view.ray_to(p);
                ++rays;
                if (const auto hit = o->lies_on->hit(ray); hit)
                    seen += glm::distance(ray.origin, p) > hit->distance + slack;
            }
    }
    EXPECT_LE(seen, rays / 200) << "of " << rays;
}

DeformedArrays arrays_of(const Mesh& mesh)
{
    return {mesh.positions, mesh.normals, mesh.tangents};
}

// Vertex by vertex, at the first frame and in the middle of what moves; by the box of an object.
TEST_P(Gallery, IsPosedAndDeformedAlikeInEveryWay)
{
    const gpu::HeadlessContext context;
    const Document document = document_of(GetParam());
    Evaluator evaluator = evaluator_here();
    gpu::DeformTimer device(0);
    gpu::Programs programs;
    gpu::DevicePoser poser(programs);
    std::size_t vertices = 0;
    for (const int frame :
         {document.time.first_frame, (document.time.first_frame + document.time.last_frame) / 2}) {
        const Evaluation evaluated = evaluator(document, frame);
        ShownValues none;
        const gpu::Picture picture =
            picture_of(evaluated, document, {}, none, gpu::DeformBy::two_phases);
        for (const gpu::Instance& instance : picture.instances) {
            const auto expect_small = [&](const gpu::DeformErrors& off, double size) {
                EXPECT_LT(off.position * off.diagonal, 1e-6 * size)
                    << "object " << instance.id << ", frame " << frame;
                EXPECT_LT(off.normal_deg, 0.05) << "object " << instance.id << ", frame " << frame;
            };
            const Ref<Mesh>& mesh = instance.posed ? *instance.posed->mesh : instance.mesh;
            if (instance.posed) {
                gpu::DeviceVertices posed;
                poser.pose(gpu::uploaded_vertices(*instance.mesh), posed, *instance.posed);
                const gpu::DeformErrors off =
                    gpu::errors_of(gpu::read_back(posed), arrays_of(*mesh));
                expect_small(off, off.diagonal);
            }
            if (instance.stages.empty()) continue;
            ASSERT_EQ(instance.stages.size(), 1u);
            device.take(mesh);
            vertices += mesh->vertex_count();
            const double object = glm::length(evaluated.objects.at(instance.id)->bounds->size());
            for (const gpu::Way way : {gpu::Way::one_phase, gpu::Way::two_phases})
                expect_small(device.errors(instance.stages.front(), way, {}), object);
        }
    }
    const bool volumes = std::ranges::any_of(document.objects, [&](const auto& entry) {
        const Object& o = *entry.second;
        const auto lattice = document.objects.find(o.parent);
        return !o.hidden &&
               (o.stroke || (lattice != document.objects.end() &&
                             std::holds_alternative<LatticeShape>(lattice->second->source)));
    });
    EXPECT_EQ(vertices > 0, volumes); // tiles are bent by no volume
}

class Motion : public ::testing::TestWithParam<std::string> {};

// The picture is that of trivar render --sheet 3x2 --size 480x270 of all frames.
TEST_P(Motion, ShowsTheSceneInSixOfItsFrames)
{
    constexpr glm::ivec2 size_px{480, 270};
    const Document document = document_of(GetParam());
    std::vector<int> frames;
    for (int frame = document.time.first_frame; frame <= document.time.last_frame; ++frame)
        frames.push_back(frame);
    Evaluator evaluator = evaluator_here();
    const gpu::HeadlessContext context;
    gpu::Renderer renderer;
    ShownValues values;
    std::vector<Image> pictures;
    for (const int frame : evenly_chosen(frames, 6)) {
        const Document now = document_at(document, frame);
        const Evaluation evaluated = evaluator(document, frame);
        const Camera camera = picture_camera(evaluated, now, size_px);
        pictures.push_back(renderer.render(picture_of(evaluated, now, camera, values), size_px));
    }
    EXPECT_TRUE(testing::matches_picture(contact_sheet(pictures, 3),
                                         "docs/gallery/" + GetParam() + "_sheet.png"));
}

class ProvenMotion : public ::testing::TestWithParam<std::string> {};

// Only two of its frames are exported; docs/export.md has more of them.
TEST_P(ProvenMotion, IsExportedAndProvenBetweenItsMomentsToo)
{
    const int middle = document_of(GetParam()).time.first_frame + 19;
    const AnimatedExport made =
        animated_export({document_of(GetParam()), {middle, middle + 1}, 0.02, GetParam()},
                        std::make_shared<const AssetStore>(scenes_folder, models_made_here()));
    int deformed = 0;
    for (const FilmCertificate::PartClaim& claim : made.certificate.parts) {
        EXPECT_TRUE(is_proven(claim)) << claim.name << ": " << claim.unproven;
        EXPECT_LE(claim.bound, 0.02) << claim.name;
        deformed += claim.way == "targets";
    }
    EXPECT_GT(deformed, 0);
}

// A reptile whose steps follow a travel that is not even.
TEST(LockedFeet, AreWhereTheirExportHasThemWhileTheyHurryAndGoBack)
{
    constexpr Id reptiles = 4;
    const Document scene = document_of("reptiles");
    const auto assets = std::make_shared<const AssetStore>(scenes_folder, models_made_here());
    for (const Travel& travel : {Travel{.speed = 0.8, .ease_in = 0.3},
                                 Travel{.speed = -0.8, .ease_in = 0.3, .start_frame = 2}}) {
        const Document document = after(scene, SetTravel{{reptiles}, travel});
        const AnimatedExport made = animated_export({document, {1, 3}, 0.02, "a"}, assets);
        const std::vector<FilmSample> found = sampled_film(made, document, assets, 10);
        for (std::size_t p = 0; p < found.size(); ++p) {
            const FilmCertificate::PartClaim& claim = made.certificate.parts[p];
            EXPECT_TRUE(is_proven(claim)) << claim.name << ": " << claim.unproven;
            EXPECT_LE(claim.bound, 0.02) << claim.name;
            EXPECT_LE(found[p].furthest, claim.bound + 1e-6) << claim.name;
        }
    }
}

TEST(GalleryScenes, AndTutorialsHaveTheirStrokesAttachedToWhatTheyLieOn)
{
    for (const std::string folder : {"scenes", "tutorials"})
        for (const std::string& name : every_scene(folder))
            for (const auto& [id, object] :
                 document_of(name, TRIVAR_SOURCE_DIR "/assets/" + folder).objects)
                EXPECT_TRUE(!object->stroke || object->stroke->round || object->stroke->attach)
                    << name << ": " << object->name;
}

TEST(GalleryPage, ShowsEverySceneAndNoPictureThatIsNotThere)
{
    const std::string folder = TRIVAR_SOURCE_DIR "/docs/";
    const std::string page = read_text_file(folder + "gallery.md");
    for (const std::string& scene : every_scene())
        EXPECT_NE(page.find("](gallery/" + scene + ".png)"), std::string::npos) << scene;
    const std::string_view before = "](";
    for (std::size_t at = page.find("](gallery/"); at != std::string::npos;
         at = page.find("](gallery/", at + 1)) {
        const std::size_t begin = at + before.size();
        const std::string picture = page.substr(begin, page.find(')', begin) - begin);
        EXPECT_TRUE(std::filesystem::exists(folder + picture)) << picture;
    }
}

const auto proven_scenes = ::testing::Values("ants_moebius", "ants_terrain", "cars_over_obstacle",
                                             "text_teapot", "bulldozer_parks", "reptiles");
INSTANTIATE_TEST_SUITE_P(Scenes, Motion, proven_scenes,
                         [](const auto& scene) { return scene.param; });
INSTANTIATE_TEST_SUITE_P(Others, Motion,
                         ::testing::Values("rider", "wreath", "thorn_to_flower", "robots_teapot",
                                           "face_thorns", "teapot_statues", "robot_bars",
                                           "bulldozer_tree", "sphere_cylinder",
                                           "sphere_cylinder_stitched", "sphere_cylinder_ends",
                                           "part_profile", "bunny_cylinder", "crossing_cuts",
                                           "face_incisions", "forearm_layers", "anatomical_plate"),
                         [](const auto& scene) { return scene.param; });
INSTANTIATE_TEST_SUITE_P(Scenes, ProvenMotion, proven_scenes,
                         [](const auto& scene) { return scene.param; });
INSTANTIATE_TEST_SUITE_P(Scenes, Gallery, ::testing::ValuesIn(every_scene()),
                         [](const auto& scene) { return scene.param; });

} // namespace
} // namespace trivar
