// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/animated_files.h"
#include "core/export/curve_strips.h"
#include "core/files/file_bytes.h"
#include "core/files/read_model.h"
#include "tests/export/scenes.h"
#include "tests/files/curves.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::HasSubstr, ::testing::Not;
using testing::Line;

// A line of three points, object 6, beside what the other scenes have.
class ExportedCurves : public testing::ExportedScenes {
protected:
    ExportedCurves()
    {
        testing::write_file(folder_.file("wire.obj"), "v 0 0 0\nv 0.1 0 0\nv 0.1 0.1 0\nl 1 2 3\n");
        ImportModel import;
        import.file.path = "wire.obj";
        import.file.up = UpAxis::z;
        import.name = "Wire";
        wired_ = after(still_, import);
    }
    Document turning() const
    {
        return keyed(wired_, 6, "transform.rotation_deg.z", {{1, 0}, {7, 90}});
    }
    Document laid_wire() const
    {
        return after(after(wired_, Place{6, testing::small_sketch(), {.fill = 0.2}, {1}}),
                     SetTravel{{6}, {.speed = 0.5}});
    }
    AnimatedFile written(const Document& document, const std::string& name) const
    {
        return write_animated({document, {1, 7}, 2e-3, ""}, assets_, folder_.file(name));
    }
    Line there(const Document& document, double frame) const
    {
        Evaluator evaluate(assets_);
        return in_world(evaluate(document, frame).objects.at(6)->curves.at(0)).points->positions;
    }
    Document wired_;
};

TEST_F(ExportedCurves, ThatMoveAsAWholeGoWithANodeOfAGlb)
{
    const Document document = turning();
    EXPECT_EQ(written(document, "a.glb").left_out, "");
    const Model model = read_model(folder_.file("a.glb"));
    const auto node =
        std::ranges::find_if(model.nodes, [](const Node& n) { return n.curves >= 0; });
    ASSERT_NE(node, model.nodes.end());
    EXPECT_EQ(node->name, "Wire");
    for (const int frame : {1, 4, 7}) {
        const Stance stance = stance_at(model, &model.clips.at(0), (frame - 1) / 12.0);
        const Curves at =
            transformed(*model.curves.at(0),
                        stance.to_model[static_cast<std::size_t>(node - model.nodes.begin())]);
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_LT(glm::distance(at.points->positions[i], there(document, frame)[i]), 2e-3);
    }
}

TEST_F(ExportedCurves, ThatBendInTimeAreLeftOutOfAGlbAndSaid)
{
    EXPECT_EQ(
        written(laid_wire(), "a.glb").left_out,
        "the curves of Wire are left out: a .glb has none that bend or shear in time; a .usda "
        "has");
    EXPECT_TRUE(read_model(folder_.file("a.glb")).curves.empty());
}

TEST_F(ExportedCurves, OfUsdAreLinearAndHaveSamplesOfTheirPointsInEveryFrame)
{
    const Document document = laid_wire();
    EXPECT_EQ(written(document, "a.usda").left_out, "");
    const std::string text = read_bytes(folder_.file("a.usda"), 1 << 24);
    const std::size_t at = text.find("def BasisCurves \"Wire_");
    ASSERT_NE(at, std::string::npos);
    const std::string own = text.substr(at, text.find("\n    }\n", at) - at);
    EXPECT_THAT(own, HasSubstr("uniform token type = \"linear\""));
    EXPECT_THAT(own, HasSubstr("int[] curveVertexCounts = [3]"));
    EXPECT_THAT(own, HasSubstr("point3f[] points.timeSamples = {"));
    EXPECT_THAT(own, HasSubstr("            7: [("));
    EXPECT_THAT(own, HasSubstr("rel material:binding = </Scene/Materials/Material_"));
}

TEST_F(ExportedCurves, ThatRestAreSaidOnceInUsd)
{
    EXPECT_EQ(written(wired_, "a.usda").left_out, "");
    const std::string text = read_bytes(folder_.file("a.usda"), 1 << 24);
    EXPECT_THAT(text, HasSubstr("point3f[] points = [(0, 0, 0), (0.1, 0, 0), (0.1, 0.1, 0)]"));
}

TEST_F(ExportedCurves, AreLeftOutOfPointCachesAndSaid)
{
    EXPECT_THAT(written(wired_, "a.pc2").left_out,
                "the curves of Wire are left out: .pc2 files are of meshes alone");
}

TEST_F(ExportedCurves, AloneMakeAFile)
{
    Document alone = after(Document{}, [] {
        ImportModel import;
        import.file.path = "wire.obj";
        return import;
    }());
    alone.time = still_.time;
    EXPECT_EQ(written(alone, "a.glb").certificate->parts.size(), 0u);
    EXPECT_EQ(line_count(read_model(folder_.file("a.glb"))), 1u);
    written(alone, "a.usda");
    EXPECT_THROW(written(alone, "a.mdd"), Rejected);
}

} // namespace
} // namespace trivar
