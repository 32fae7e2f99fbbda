// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/placement/place.h"
#include "core/document/document_digest.h"
#include "editor/actions/actions.h"
#include "editor/viewport/refined_view.h"
#include "tests/editor/rig.h"

namespace trivar {
namespace {

using testing::Rig;

// A box laid on a plane, which the window may refine.
struct RefinedViews : ::testing::Test {
    Rig rig{{1024, 700}};
    void SetUp() override
    {
        rig.two_objects();
        rig.key({'D'});
        rig.draw(rig.stroke());
        rig.wait();
        ASSERT_TRUE(session().evaluated().objects.at(2)->placement);
    }
    Session& session() { return rig.editor.session; }
    RefinedView& view() { return rig.editor.viewport.refined(); }
    void run(const char* name)
    {
        action(rig.editor, name).run(rig.editor);
        settle();
    }
    void settle()
    {
        using namespace std::chrono_literals;
        for (int i = 0; i < 2000; ++i) {
            rig.frames(1);
            if (session().up_to_date() && view().up_to_date()) break;
            std::this_thread::sleep_for(5ms);
        }
        rig.frames(2);
    }
    std::size_t drawn_vertices()
    {
        std::size_t count = 0;
        for (const Part& part : view().seen().objects.at(2)->parts) count += part.vertex_count();
        return count;
    }
};

TEST_F(RefinedViews, AreChosenInTheMenuAndLeaveTheDocumentAndItsEffectsAlone)
{
    const std::string document = digest(session().document()),
                      effects = digest(session().evaluated());
    const std::size_t steps = rig.steps(), plain = drawn_vertices();
    EXPECT_EQ(view().seen().objects, session().evaluated().objects);
    run("Triangles within 1 px");
    const std::size_t one = drawn_vertices();
    EXPECT_GT(one, plain);
    EXPECT_EQ(view().words(0).substr(0, 11), "Within 1 px");
    run("Triangles within 0.5 px");
    EXPECT_GT(drawn_vertices(), one);
    EXPECT_EQ(rig.steps(), steps);
    EXPECT_EQ(digest(session().document()), document);
    EXPECT_EQ(digest(session().evaluated()), effects);
    run("Original triangles");
    EXPECT_EQ(view().seen().objects, session().evaluated().objects);
    EXPECT_EQ(view().words(0), "");
}

TEST_F(RefinedViews, FollowEditsAndTheCamera)
{
    run("Triangles within 1 px");
    const auto first = view().seen().objects.at(2);
    PlacementParameters p = object(session().document(), 2).stroke->parameters;
    p.fill *= 0.8;
    ASSERT_TRUE(session().run(EditPlacement{2, p, {}, {}}));
    settle();
    const auto edited = view().seen().objects.at(2);
    EXPECT_NE(edited, first);
    EXPECT_TRUE(edited->refined);
    const std::size_t before = drawn_vertices();
    session().view.camera.eye =
        glm::mix(session().view.camera.eye, session().view.camera.target, 0.7);
    settle();
    EXPECT_GT(drawn_vertices(), before);
}

} // namespace
} // namespace trivar
