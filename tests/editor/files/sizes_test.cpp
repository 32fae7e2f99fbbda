// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of a model that came in and is far larger than the rest, or cannot be seen.
#include "tests/editor/rig.h"
#include "tests/support/fixtures.h"

#include <fmt/format.h>

namespace trivar {
namespace {

struct Imports : testing::Rig {
    // A square of that side.
    std::string square(const std::string& name, double side, double x = 0)
    {
        const std::string path = folder.file(name);
        testing::write_file(path, fmt::format("v {0} 0 0\nv {1} 0 0\nv {1} {2} 0\nv {0} {2} 0\n"
                                              "f 1 2 3 4\n",
                                              x, x + side, side));
        return path;
    }
    void drop(std::vector<std::string> paths)
    {
        screen.input().push(ui::drop_files(std::move(paths)));
        frames(2);
        wait();
        frames(4);
    }
    const ui::Notices::Notice* said(const std::string& words) const
    {
        for (const auto& each : editor.session.notices.all())
            if (each.title.find(words) != each.title.npos) return &each;
        return nullptr;
    }
    testing::TemporaryFolder folder;
};

TEST(Imports, OfOneDropAreComparedWithEachOther)
{
    Imports rig;
    rig.drop({rig.square("small.obj", 1), rig.square("large.obj", 100)});
    const auto* notice = rig.said("times larger");
    ASSERT_TRUE(notice);
    ASSERT_EQ(notice->actions.size(), 1u);
    const auto scale = notice->actions.front().act;
    scale();
    EXPECT_EQ(object(rig.editor.session.document(), 2).transform.scale, glm::dvec3(0.01));
}

TEST(Imports, ThatCannotBeSeenOfferToBeFramed)
{
    Imports rig;
    rig.drop({rig.square("here.obj", 1)});
    rig.drop({rig.square("there.obj", 1, 500)});
    const auto* notice = rig.said("cannot be seen");
    ASSERT_TRUE(notice);
    const auto frame = notice->actions.front().act;
    frame();
    rig.frames(3);
    const glm::dvec2 p = project(rig.editor.session.view.camera, {500.5, 0.5, 0}).p_px;
    EXPECT_GT(p.x, 0);
    EXPECT_LT(p.x, rig.editor.session.view.camera.size_px.x);
}

TEST(Imports, InSightAreNotTalkedOf)
{
    Imports rig;
    rig.drop({rig.square("here.obj", 1)});
    rig.drop({rig.square("there.obj", 1.5, 0.2)});
    EXPECT_TRUE(rig.editor.session.notices.all().empty());
}

} // namespace
} // namespace trivar
