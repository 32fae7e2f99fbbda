// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/number_text.h"
#include "core/commands/objects/refine.h"
#include "core/commands/objects/view.h"
#include "core/refinement/refine.h"
#include "editor/picture/captions.h"
#include "editor/viewport/refined_view.h"

#include "core/files/pictures/image.h"
#include "editor/command_line/replay.h"
#include "tests/editor/rig.h"
#include "tests/support/fixtures.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cstdio>
#include <gmock/gmock.h>
#include <sstream>

namespace trivar {
namespace {

using ::testing::HasSubstr;
using testing::Rig;
using ::testing::StartsWith;

// The box laid on the plane and refined.
struct RefinedRig : Rig {
    explicit RefinedRig(const Refining& refining) : Rig({1000, 760})
    {
        two_objects();
        key({'D'});
        draw(stroke());
        wait();
        key({'Q'});
        run(Refine{{2}, refining, {}});
    }
    void run(const Command& command)
    {
        EXPECT_TRUE(editor.session.run(command));
        wait();
    }
    std::vector<Caption> captions() const
    {
        return captions_of(editor.session.evaluated(), editor.session.document());
    }
    const RefinementResult& refined() const
    {
        return *editor.session.evaluated().objects.at(2)->refined;
    }
};

TEST(Captions, SayWhatWasWorkedOut)
{
    RefinedRig rig({.tolerance = 0.002});
    ASSERT_EQ(rig.captions().size(), 1u);
    const Caption caption = rig.captions().front();
    EXPECT_EQ(caption.title, with_commas(rig.refined().triangles()) + " triangles");
    EXPECT_THAT(caption.words, StartsWith("split by curvature, certified to "));
    double mm = 0; // never less than the bound
    std::sscanf(caption.words.c_str() + caption.words.rfind("to "), "to %lf mm", &mm);
    EXPECT_GE(mm, 1000 * rig.refined().bound);
    EXPECT_LE(mm, 1000 * rig.refined().bound * 1.01);
    rig.run(Refine{{2}, {.tolerance = 0.002, .split = SplitPoint::midpoint, .budget = 12}, {}});
    EXPECT_THAT(rig.captions().front().words,
                HasSubstr(with_commas(rig.refined().not_certified()) + " not certified"));
    rig.run(Refine{{2}, {.tolerance = 0.002, .rule = RefinementRule::chua_neumann_midpoint}, {}});
    EXPECT_THAT(rig.captions().front().words, HasSubstr("nothing certified"));
    rig.run(ClearRefine{{2}});
    EXPECT_TRUE(rig.captions().empty());
}

TEST(Captions, StandInThePictureAndNotOnEachOther)
{
    const Rig rig;
    const std::vector<glm::dvec3> points{{0, 0, 0}, {0.3, 0, 0}};
    const std::vector<Caption> three(3, {"120 triangles", "a line that is longer", points});
    Camera camera;
    camera.eye = {0, -5, 1};
    camera.target = {0, 0, 0};
    camera.size_px = {720, 520};
    const ui::Rect view{{40, 30}, {760, 550}};
    for (const glm::dvec3 at : {glm::dvec3(0), {0, 0, 0.6}, {2, 0, 0}}) {
        camera.target = at;
        const auto places = caption_places(three, view, camera, rig.screen.theme());
        ASSERT_EQ(places.size(), 3u);
        for (std::size_t i = 1; i < 3; ++i) EXPECT_GE(places[i].rect.lo.y, places[i - 1].rect.hi.y);
        EXPECT_TRUE(view.contains(places.front().rect.lo));
        EXPECT_LE(places.front().rect.hi.x, view.hi.x);
    }
    camera.target = {0, -9, 1}; // all of it is behind the eye
    EXPECT_TRUE(caption_places(three, view, camera, rig.screen.theme()).empty());
}

TEST(Captions, AreInAFileUnderWhatTheySpeakOfAndChangeNothingElse)
{
    const testing::TemporaryFolder folder;
    { // replay has a context of its own
        RefinedRig rig({.tolerance = 0.002});
        rig.editor.session.save_as(folder.file("without.trivar"));
        rig.editor.session.save_as(folder.file("with.trivar"));
        RenderSettings settings;
        settings.captions = true;
        rig.run(SetRender{settings});
    }
    const auto drawn = [&](const std::string& name) {
        ReplayOptions options;
        options.scene.path = folder.file(name + ".trivar");
        options.image = folder.file(name + ".png");
        options.drawing.size = "640x360";
        std::ostringstream out, talk;
        EXPECT_EQ(run_replay(options, {out, talk}), Status::done) << talk.str();
        return read_image(options.image).rgba;
    };
    const std::vector<std::uint8_t> without = drawn("without"), with = drawn("with");
    ASSERT_EQ(with.size(), without.size());
    std::size_t others = 0, first = 360;
    for (std::size_t i = 0; i < with.size(); ++i)
        if (with[i] != without[i]) {
            ++others;
            first = std::min(first, i / 4 / 640);
        }
    EXPECT_GT(others, 1000u);
    EXPECT_LT(others, with.size() / 6);
    EXPECT_GT(first, 120u);
}

} // namespace
} // namespace trivar
