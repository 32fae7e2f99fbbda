// SPDX-License-Identifier: GPL-3.0-or-later
// An iron protein, heads, a skull and a tooth, drawn by lines of the data themselves.

#include "core/base/text.h"
#include "core/drawing/drawing_file.h"
#include "core/scene/log.h"
#include "core/scene_lines/line_sheet.h"
#include "core/silhouette/border_lines.h"
#include "core/silhouette/silhouette_curves.h"
#include "core/silhouette/silhouette_finder.h"
#include "core/stages/shown_volume.h"
#include "editor/picture/picture.h"
#include "editor/picture/still.h"
#include "gpu/context.h"
#include "tests/support/fixtures.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

class RealDataVolumeScenes : public ::testing::TestWithParam<const char*> {
protected:
    void SetUp() override
    {
        const std::string folder = testing::real_data_folder();
        if (folder.empty()) GTEST_SKIP() << "there is no folder of real volumes here";
        const std::string path =
            std::string(TRIVAR_SOURCE_DIR "/tests/logs/real/volume_") + GetParam() + ".trivar";
        document_ = replay(read_log(read_text_file(path), path)).document();
        evaluated_ = Evaluator(std::make_shared<const AssetStore>(folder + "/volumes"))(document_);
        ASSERT_TRUE(shape().volume) << (shape().lacks.empty() ? "" : shape().lacks.front());
    }
    const Shape& shape() const { return *evaluated_.objects.at(1)->shape; }
    const ShownVolume& volume() const { return *shape().volume; }
    Camera camera(glm::ivec2 size_px) const
    {
        return picture_camera(evaluated_, document_, size_px);
    }
    Document document_;
    Evaluation evaluated_;
};

TEST_P(RealDataVolumeScenes, HaveCurvesWithoutBranchesThatEndInTheFacesOfTheData)
{
    const ScalarField<float>& field = volume().field->field();
    const Camera seen = camera({1000, 1000});
    SilhouetteFinder find;
    for (const ShownVolume::Level& level : volume().levels) {
        const LevelMesh& mesh = *level.mesh;
        for (int turn = 0; turn < 12; ++turn) {
            ViewPoint view = drawing_view(seen, volume().to_model, field.size()).from;
            if (turn > 0) view.at = {std::cos(0.5 * turn), std::sin(0.5 * turn), 0.2 * turn - 1, 0};
            const Silhouettes curves = find(field, mesh, view);
            ASSERT_GT(curves.count(), 0u) << level.name;
            std::vector<std::uint64_t> edges;
            for (const SilhouettePoint& point : curves.points) edges.push_back(point.edge);
            std::ranges::sort(edges);
            EXPECT_EQ(std::ranges::adjacent_find(edges), edges.end()) << level.name;
            for (std::size_t c = 0; c < curves.count(); ++c) {
                if (curves.closed[c]) continue;
                for (const std::uint32_t i : {curves.first[c], curves.first[c + 1] - 1}) {
                    const std::uint64_t edge = curves.points[i].edge;
                    EXPECT_TRUE(are_in_a_face(mesh.positions[edge >> 32],
                                              mesh.positions[edge & 0xFFFFFFFF], field.end()))
                        << level.name;
                }
            }
        }
        for (const char closed : border_lines(field, mesh).closed) EXPECT_TRUE(closed);
    }
}

TEST_P(RealDataVolumeScenes, FillALayerForEachLevelOfASheetThatIsSmall)
{
    constexpr std::size_t most_bytes = 150'000;
    const DrawingSheet sheet = line_sheet(evaluated_, document_, camera({1000, 1000})).sheet;
    EXPECT_GE(sheet.layers.size(), volume().levels.size());
    for (const DrawingLayer& layer : sheet.layers) {
        EXPECT_FALSE(layer.lines.empty()) << layer.name;
        for (const InkedLine& line : layer.lines)
            for (const InkedLine::Point& p : line.points)
                ASSERT_TRUE(glm::all(glm::greaterThan(p.at, glm::vec2(-50))) &&
                            glm::all(glm::lessThan(p.at, glm::vec2(1050))))
                    << layer.name;
    }
    const std::size_t bytes = drawing_bytes(sheet, DrawingFormat::svg).size();
    RecordProperty("svg_bytes", static_cast<int>(bytes));
    if (std::string_view(GetParam()) == "skull") {
        EXPECT_LT(bytes, most_bytes);
    }
}

TEST_P(RealDataVolumeScenes, AreDrawnWithoutAScreen)
{
    constexpr glm::ivec2 size_px(640, 480);
    const gpu::HeadlessContext context;
    const auto drawn = [&](const Evaluation& evaluated) {
        Still still;
        still.draw(evaluated, document_, camera(size_px), {.size_px = size_px});
        return still.image();
    };
    Evaluation without = evaluated_;
    without.objects.clear();
    const Image with = drawn(evaluated_), bare = drawn(without);
    std::size_t inked = 0;
    for (std::size_t i = 0; i < with.rgba.size(); i += 4)
        inked += std::abs(with.rgba[i] - bare.rgba[i]) > 40;
    constexpr std::size_t least = 640 * 480 / 200; // of the pixels
    EXPECT_GT(inked, least);
}

INSTANTIATE_TEST_SUITE_P(RealData, RealDataVolumeScenes,
                         ::testing::Values("iron_protein", "head", "skull", "tooth", "head_mr"),
                         [](const auto& scene) { return std::string(scene.param); });

} // namespace
} // namespace trivar
