// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/view.h"
#include "core/document/document_digest.h"
#include "core/files/pictures/image.h"
#include "core/scene/log.h"
#include "editor/command_line/replay.h"
#include "tests/editor/rig.h"
#include "tests/support/buffer_traffic.h"
#include "tests/support/copied_shaders.h"

#include <algorithm>
#include <epoxy/gl.h>
#include <gmock/gmock.h>
#include <sstream>

namespace trivar {
namespace {

using testing::Rig;

// The picture of the viewport, first row on top, once it is whole.
std::vector<std::uint8_t> shown(Rig& rig, glm::ivec2 size_px, int most_frames = 400)
{
    rig.draw_whole();
    rig.wait();
    rig.screen.settle(rig.body(), most_frames);
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(size_px.x) * size_px.y * 4);
    glBindTexture(GL_TEXTURE_2D, rig.editor.viewport.texture());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    const std::ptrdiff_t row = std::ptrdiff_t{4} * size_px.x;
    for (int y = 0; y < size_px.y / 2; ++y)
        std::swap_ranges(bytes.begin() + y * row, bytes.begin() + (y + 1) * row,
                         bytes.end() - (y + 1) * row);
    return bytes;
}

TEST(ViewportPicture, IsBitForBitTheOneThatReplayDraws)
{
    const testing::TemporaryFolder folder;
    std::vector<std::uint8_t> in_window;
    glm::ivec2 size_px(0);
    { // replay has a context of its own
        Rig rig;
        rig.two_objects();
        rig.editor.session.selected = 0;
        size_px = rig.layout().view.size();
        const auto with_grid = shown(rig, size_px);
        rig.editor.preferences.backdrop_as_in_pictures = true;
        in_window = shown(rig, size_px);
        EXPECT_NE(with_grid, in_window);
        ASSERT_TRUE(rig.editor.session.run(KeepView{"picture", rig.editor.session.view.camera}));
        rig.editor.session.save_as(folder.file("scene.trivar"));
    }
    ReplayOptions options;
    options.scene.path = folder.file("scene.trivar");
    options.image = folder.file("picture.png");
    options.drawing.size = std::to_string(size_px.x) + "x" + std::to_string(size_px.y);
    std::ostringstream out, talk;
    ASSERT_EQ(run_replay(options, {out, talk}), Status::done) << talk.str();
    EXPECT_EQ(read_image(options.image).rgba, in_window);
}

TEST(ViewportPicture, IsTheSameAfterTheGraphicsCardWasResetAndOneNoticeSaysSo)
{
    Rig rig;
    rig.two_objects();
    const glm::ivec2 size_px = rig.layout().view.size();
    const auto before = shown(rig, size_px);
    const std::size_t steps = rig.steps(), notices = rig.editor.session.notices.all().size();
    const std::string document = digest(rig.editor.session.document());
    rig.screen.lose_context([&] { rig.editor.lose_context(); });
    EXPECT_EQ(rig.editor.viewport.texture(), 0u);
    EXPECT_EQ(rig.editor.session.notices.all().size(), notices + 1);
    EXPECT_EQ(shown(rig, size_px), before);
    EXPECT_EQ(rig.steps(), steps);
    EXPECT_EQ(digest(rig.editor.session.document()), document);
    EXPECT_GT(rig.screen.picture().rgba.size(), 0u);
}

TEST(ViewportPicture, FollowsADevelopersShadersAndOneNoticeSaysWhatIsWrongTillItIsMended)
{
    const testing::CopiedShaders copy;
    Rig rig;
    rig.two_objects();
    const glm::ivec2 size_px = rig.layout().view.size();
    const auto embedded = shown(rig, size_px);
    rig.editor.viewport.follow(gpu::ShaderFolder(copy.folder.path().string()));
    const auto followed = [&] { return shown(rig, size_px, 50); };
    const auto said = [&] {
        std::vector<std::string> out;
        for (const ui::Notices::Notice& notice : rig.editor.session.notices.all())
            if (notice.title == "A shader could not be updated") out.push_back(notice.body);
        return out;
    };
    EXPECT_EQ(followed(), embedded);
    const long pictures = rig.editor.viewport.pictures();
    followed();
    EXPECT_EQ(rig.editor.viewport.pictures(), pictures) << "the scene was drawn for nothing";

    const std::string own = "return saturate(c);", blue = "return vec3(0.0, 0.0, 1.0);";
    copy.replace("tonemap.glsl", own, blue);
    const auto changed = followed();
    EXPECT_NE(changed, embedded);
    EXPECT_TRUE(said().empty());
    copy.replace("tonemap.glsl", "    float x", "    x");
    EXPECT_EQ(followed(), changed);
    EXPECT_THAT(said(), ::testing::ElementsAre(::testing::HasSubstr("tonemap.glsl:7 ")));
    copy.replace("tonemap.glsl", blue, own);
    copy.replace("tonemap.glsl", "    x", "    float x");
    EXPECT_EQ(followed(), embedded);
    EXPECT_TRUE(said().empty());
}

TEST(ViewportPicture, StaysAsItWasWhereTheDeviceHasNoRoomForMoreAndOneNoticeSaysSo)
{
    Rig rig;
    rig.two_objects();
    const glm::ivec2 size_px = rig.layout().view.size();
    const auto before = shown(rig, size_px);
    const auto said = [&] {
        return std::ranges::count(rig.editor.session.notices.all(), "The picture is out of date",
                                  &ui::Notices::Notice::title);
    };
    testing::BufferTraffic traffic;
    traffic.room = 100'000;
    AddSphere sphere;
    sphere.shape.segments = 200;
    sphere.shape.rings = 100;
    ASSERT_TRUE(rig.editor.session.run(sphere));
    EXPECT_EQ(shown(rig, size_px), before);
    EXPECT_EQ(said(), 1);
    EXPECT_EQ(rig.steps(), 3u) << "nothing is lost";
    traffic.room = 1 << 30;
    rig.editor.session.view.camera.eye.x += 1;
    EXPECT_NE(shown(rig, size_px), before);
    EXPECT_EQ(said(), 0);
}

TEST(ViewportPicture, DeformsNothingAnewThatStaysWhereOthersAreHidden)
{
    Rig rig;
    rig.editor.preferences.deform = "two_phases";
    rig.two_objects();
    AddBox box;
    box.shape.size = {0.6, 0.3, 0.3};
    ASSERT_TRUE(rig.editor.session.run(box));
    for (const Id id : {2, 3}) {
        rig.editor.session.selected = id;
        rig.key({'D'});
        rig.draw(rig.stroke());
        rig.wait();
    }
    const auto& drafts = rig.editor.viewport.drafts();
    const auto deformed = [&](long since) {
        bool any = false;
        for (long i = since + 1; i <= drafts.count(); ++i)
            any |= std::ranges::any_of(drafts.find(i)->passes.stages, [](const auto& stage) {
                return stage.name == "deform on device";
            });
        return any;
    };
    EXPECT_TRUE(deformed(0));
    const long before = drafts.count();
    rig.key({ui::key_slash});
    ASSERT_EQ(rig.editor.session.hidden_here, (std::vector<Id>{1, 2}));
    rig.wait();
    EXPECT_GT(drafts.count(), before);
    EXPECT_FALSE(deformed(before));
}

TEST(ViewportPicture, OfADarkLookStaysDarkInALightInterface)
{
    ui::Theme theme;
    const ui::Look light{.light = true}, dark;
    theme.look = light;
    theme.color = ui::palette_of(light);
    RenderSettings settings;
    for (const bool as_in_pictures : {false, true}) {
        settings.look = "dark";
        const ui::Palette over = theme_over_picture(theme, settings, as_in_pictures).color;
        EXPECT_EQ(over.lattice, ui::palette_of(dark).lattice);
        EXPECT_EQ(over.sky_top, ui::palette_of(dark).sky_top);
        EXPECT_EQ(over.text, theme.color.text);
        settings.look = "studio";
        EXPECT_EQ(theme_over_picture(theme, settings, as_in_pictures).color.lattice,
                  theme.color.lattice);
    }
}

} // namespace
} // namespace trivar
