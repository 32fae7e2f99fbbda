// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/document_digest.h"
#include "core/stages/shown_volume.h"
#include "editor/picture/line_sheet.h"
#include "editor/picture/picture.h"
#include "editor/viewport/certified_lines.h"
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
    const CertifiedLines& lines() const { return rig.editor.viewport.certified_lines(); }
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

TEST_F(CertifiedLinesInWindow, AreInFilesAtOnce)
{
    certify();
    const Session& session = rig.editor.session;
    const EvaluatedObject& ball = *session.evaluated().objects.at(1);
    const auto count = [](const std::vector<gpu::Curve>& curves) {
        std::size_t points = 0;
        for (const gpu::Curve& curve : curves) points += curve.line->points.size();
        return points;
    };
    const VolumeView view{ball.shape->volume, glm::dmat4(1), session.view.camera, 1};
    const std::size_t quick = count(lines_of(view, 1, LineProof::none).curves),
                      certified = count(lines_of(view, 1, LineProof::as_wanted).curves);
    EXPECT_NE(certified, quick);
    EXPECT_EQ(count(VolumeLines()(ball, view.to_world, view.camera, 1)), certified);
    std::size_t on_sheet = 0;
    for (const DrawingLayer& layer :
         line_sheet(session.evaluated(), session.document(), session.view.camera).layers)
        for (const InkedLine& line : layer.lines) on_sheet += line.points.size();
    EXPECT_EQ(on_sheet, certified);
}

TEST_F(CertifiedLinesInWindow, TakeThePlaceOfThoseOfTheirViewAlone)
{
    certify();
    const Session& session = rig.editor.session;
    const EvaluatedObject& ball = *session.evaluated().objects.at(1);
    VolumeLines lines;
    lines.proof = LineProof::none;
    const VolumeView view{ball.shape->volume, glm::dmat4(1), session.view.camera, 1};
    const std::size_t quick = lines(ball, view.to_world, view.camera, 1).size();
    SeenLines given = lines_of(view, 1, LineProof::as_wanted);
    given.curves.push_back(given.curves.front());
    lines.give({{view, given}});
    EXPECT_EQ(lines(ball, view.to_world, view.camera, 1).size(), given.curves.size());
    Camera other = view.camera;
    other.eye.x += 0.01;
    EXPECT_EQ(lines(ball, view.to_world, other, 1).size(), quick);
    lines.give({});
    EXPECT_EQ(lines(ball, view.to_world, view.camera, 1).size(), quick);
}

} // namespace
} // namespace trivar
