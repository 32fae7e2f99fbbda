// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/primitives.h"
#include "core/document/document_digest.h"
#include "core/scene_lines/line_sheet.h"
#include "editor/picture/picture.h"
#include "editor/viewport/lines_at_rest.h"
#include "tests/editor/volume_rig.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::StartsWith;
using namespace std::chrono_literals;

// A ball whose lines are wanted with a proof.
struct CertifiedLinesInWindow : public ::testing::Test {
    testing::VolumeRig rig{{900, 700}};
    void SetUp() override
    {
        rig.add_ball({30.5});
        settle();
    }
    void certify(FieldOrder order = FieldOrder::cubic)
    {
        SetVoxels set{1, rig.shape()};
        set.shape.levels[0].certified = true;
        set.shape.order = order;
        ASSERT_TRUE(rig.editor.session.run(set));
        settle();
    }
    void settle()
    {
        for (int i = 0; i < 2000; ++i) {
            rig.frames(1);
            if (rig.editor.session.up_to_date() && lines().up_to_date()) break;
            std::this_thread::sleep_for(2ms);
        }
        rig.frames(2);
    }
    const LinesAtRest& lines() const { return rig.editor.viewport.lines_at_rest(); }
};

TEST_F(CertifiedLinesInWindow, ReplaceQuickOnesOnceTheViewRests)
{
    EXPECT_EQ(lines().words(), "") << "where nobody wants them";
    const long before = lines().number(), pictures = rig.editor.viewport.pictures();
    certify();
    const std::string document = digest(rig.editor.session.document());
    const std::size_t steps = rig.steps();
    EXPECT_THAT(lines().words(), StartsWith("Lines certified to 1/8 voxel, "));
    EXPECT_GT(lines().number(), before);
    EXPECT_GT(rig.editor.viewport.pictures(), pictures);
    EXPECT_EQ(rig.steps(), steps);
    EXPECT_EQ(digest(rig.editor.session.document()), document);
}

TEST_F(CertifiedLinesInWindow, AreDroppedAsSoonAsTheViewMoves)
{
    certify();
    const long before = lines().number();
    Camera& camera = rig.editor.session.view.camera;
    camera.eye += 0.1 * (camera.target - camera.eye);
    rig.frames(1);
    EXPECT_EQ(lines().words(), "Certifying lines to 1/8 voxel");
    EXPECT_FALSE(lines().up_to_date());
    EXPECT_EQ(lines().number(), before);
    settle();
    EXPECT_THAT(lines().words(), StartsWith("Lines certified"));
    EXPECT_EQ(lines().number(), before + 1);
}

TEST_F(CertifiedLinesInWindow, AreThereOfCubicSplinesAlone)
{
    certify(FieldOrder::quadratic);
    EXPECT_EQ(lines().words(), "");
}

// The number of points of curves.
std::size_t points_of(const std::vector<gpu::Curve>& curves)
{
    std::size_t points = 0;
    for (const gpu::Curve& curve : curves) points += curve.line->points.size();
    return points;
}

TEST_F(CertifiedLinesInWindow, AreInFilesAtOnce)
{
    certify();
    const Session& session = rig.editor.session;
    PictureLines in_files, quick;
    quick.effort = LineEffort::quick;
    const auto points = [&](PictureLines& lines) {
        return points_of(lines(session.evaluated(), session.document(), session.view.camera, 1));
    };
    const std::size_t certified = points(in_files);
    EXPECT_NE(certified, points(quick));
    std::size_t on_sheet = 0;
    for (const DrawingLayer& layer :
         line_sheet(session.evaluated(), session.document(), session.view.camera).sheet.layers)
        for (const InkedLine& line : layer.lines) on_sheet += line.points.size();
    EXPECT_EQ(on_sheet, certified);
}

TEST_F(CertifiedLinesInWindow, TakeThePlaceOfThoseOfTheirViewAlone)
{
    certify();
    const Session& session = rig.editor.session;
    PictureLines lines;
    lines.effort = LineEffort::quick;
    const auto count = [&](const Camera& camera) {
        return lines(session.evaluated(), session.document(), camera, 1).size();
    };
    const Camera& camera = session.view.camera;
    const std::size_t quick = count(camera);
    const LineScene scene = line_scene(session.evaluated(), session.document(), camera);
    SceneLines given = LineDrawer()(scene);
    given.objects.push_back(given.objects.front());
    lines.give(scene, make_ref(given));
    EXPECT_EQ(count(camera), 2 * quick);
    Camera other = camera;
    other.eye.x += 0.01;
    EXPECT_EQ(count(other), quick);
    lines.give({}, nullptr);
    EXPECT_EQ(count(camera), quick);
}

// Lines that depend on other objects are drawn once the view rests.
TEST_F(CertifiedLinesInWindow, AreBesideThoseThatOtherObjectsHide)
{
    EXPECT_TRUE(rig.editor.session.run(AddBox{}));
    settle();
    EXPECT_EQ(lines().words(), "") << "what is drawn needs no word";
    EXPECT_GT(lines().number(), 0);
    const long before = lines().number();
    EXPECT_TRUE(rig.editor.session.run(Hide{{2}}));
    settle();
    EXPECT_EQ(lines().number(), before) << "a scene of one object is drawn at once";
}

} // namespace
} // namespace trivar
