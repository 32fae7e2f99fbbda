// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures of docs/gallery.md and the README are what these scenes give today.

#include "core/base/text.h"
#include "core/document/log.h"
#include "editor/picture.h"
#include "gpu/context.h"
#include "gpu/renderer.h"
#include "tests/support/pictures.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <map>

namespace trivar {
namespace {

constexpr glm::ivec2 gallery_size_px{1280, 720};

struct Scene {
    Document document;
    Evaluated evaluated;
};

// The models as this build made them, in whatever folder it is.
std::map<std::string, std::string> models_made_here()
{
    std::map<std::string, std::string> out;
    for (const auto& entry :
         std::filesystem::directory_iterator(TRIVAR_BINARY_DIR "/assets/models"))
        out[entry.path().filename()] = entry.path();
    return out;
}

Scene replayed(const std::string& name)
{
    const std::string folder = TRIVAR_SOURCE_DIR "/assets/scenes";
    const std::string path = folder + "/" + name + ".trivar";
    const Document document = replay(read_log(read_text_file(path), path)).document();
    Evaluator evaluator(std::make_shared<const AssetStore>(folder, models_made_here()));
    return {document, evaluator(document)};
}

class Gallery : public ::testing::TestWithParam<const char*> {};

TEST_P(Gallery, ShowsTheSceneAsItIs)
{
    const Scene scene = replayed(GetParam());
    const gpu::HeadlessContext context;
    gpu::Renderer renderer;
    const Camera camera = picture_camera(scene.evaluated, scene.document, gallery_size_px);
    Stretches stretches;
    const Image image = renderer.render(
        picture_of(scene.evaluated, scene.document, camera, stretches), gallery_size_px);
    EXPECT_TRUE(
        testing::matches_picture(image, std::string("docs/gallery/") + GetParam() + ".png"));
}

// The thousandth of the height that the lift promises, measured by denser samples than it used.
TEST_P(Gallery, LaysNothingIntoWhatItLiesOn)
{
    const Scene scene = replayed(GetParam());
    int placed = 0;
    for (const auto& [id, object] : scene.evaluated.objects) {
        if (!object->placement) continue;
        ++placed;
        EXPECT_LE(object->placement->report.penetration, 1e-3) << "object " << id;
    }
    EXPECT_GT(placed, 0);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Gallery,
                         ::testing::Values("first_placement", "snake_bridge", "crocodile_on_horse",
                                           "stacked", "f1_f2", "ants", "whales", "car"),
                         [](const auto& scene) { return std::string(scene.param); });

} // namespace
} // namespace trivar
