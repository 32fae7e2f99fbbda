// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/primitives.h"
#include "core/mesh/mesh.h"
#include "core/simplex/cell_search.h"
#include "core/tetrahedra/cloud_room.h"
#include "core/tetrahedra/tetrahedra_shaper.h"
#include "editor/tools/tetrahedra/tetrahedra.h"
#include "tests/editor/rig.h"

namespace trivar {
namespace {

using testing::Rig;

// A ball in tetrahedra (object 2), and the tool that pulls them.
struct TetrahedraRig : Rig {
    TetrahedraRig()
    {
        EXPECT_TRUE(editor.session.run(AddSphere{.shape = {.radius = 0.5}}));
        wait();
        editor.session.selected = 1;
        action(editor, tetrahedra_action).run(editor);
        editor.session.view.camera.eye = {0, -4, 0.5};
        editor.session.view.camera.target = {0, 0, 0};
        wait();
    }
    const TetrahedraShape& shape() const
    {
        return std::get<TetrahedraShape>(object(editor.session.document(), 2).source);
    }
    TetrahedraTool& tool() { return dynamic_cast<TetrahedraTool&>(editor.active_tool()); }
    void choose(TetrahedraTool::By by)
    {
        tool().choose(by);
        frames();
    }
    const SimplexVolume& volume() const
    {
        return *editor.session.evaluated().objects.at(2)->tetrahedra->volume;
    }
    std::vector<ControlPlace> places() const { return control_places(*volume().layers[0]); }
    glm::vec2 seen_in(const glm::dvec3& p) const // of the volume
    {
        const auto& object = *editor.session.evaluated().objects.at(2);
        return seen_at(glm::dvec3(object.tetrahedra_to_world * glm::dvec4(p, 1)));
    }
    // The place that is nearest to the eye, and so hidden by no other.
    std::size_t nearest_place() const
    {
        const std::vector<ControlPlace> all = places();
        std::size_t out = 0;
        for (std::size_t i = 0; i < all.size(); ++i)
            if (all[i].rest.y < all[out].rest.y) out = i;
        return out;
    }
    void drag(glm::vec2 by, bool let_go = true)
    {
        const glm::vec2 at = seen_at({0.1, -0.48, 0.1});
        move(at);
        draw({at, at + 0.5f * by, at + by}, let_go);
        wait();
    }
};

TEST(TetrahedraTool, PutsTetrahedraRoundWhatIsSelectedAndIsChosen)
{
    TetrahedraRig rig;
    EXPECT_EQ(rig.editor.active_tool().name(), "Tetrahedra");
    EXPECT_EQ(rig.editor.session.selected, 2);
    EXPECT_EQ(object(rig.editor.session.document(), 1).parent, 2);
    EXPECT_GE(rig.shape().size.x, 1.0);
}

TEST(TetrahedraTool, PullsWhatTheBallHoldsInOneStep)
{
    TetrahedraRig rig;
    const std::size_t before = rig.steps();
    rig.drag({30, 0});
    EXPECT_EQ(rig.steps(), before + 1);
    ASSERT_EQ(rig.shape().edits.size(), 1U);
    const TetrahedraPull& pull = *rig.shape().edits[0].pull;
    EXPECT_NEAR(pull.at.y, -0.48, 0.05); // where the mouse was on the ball
    EXPECT_GT(pull.by.x, 0.01);
    EXPECT_NEAR(pull.by.y, 0, 1e-9); // in the plane that the camera faces
    rig.editor.session.undo();
    rig.wait();
    EXPECT_TRUE(rig.shape().edits.empty());
}

TEST(TetrahedraTool, APullCarriesWhatWasGrabbedWithTheMouse)
{
    TetrahedraRig rig;
    const glm::vec2 by{24, 0};
    const glm::vec2 before = rig.seen_in({0.1, -0.48, 0.1});
    rig.drag(by);
    const TetrahedraPull& pull = *rig.shape().edits.at(0).pull;
    const glm::vec2 now = rig.seen_in(evaluate(rig.volume(), pull.at).position);
    EXPECT_NEAR(now.x - before.x, by.x, 2);
    EXPECT_NEAR(now.y - before.y, by.y, 2);
}

TEST(TetrahedraTool, IsCancelledWithoutATrace)
{
    TetrahedraRig rig;
    const std::size_t before = rig.steps();
    rig.drag({30, 0}, false);
    EXPECT_EQ(rig.shape().edits.size(), 1U);
    rig.key({ui::key_escape});
    rig.wait();
    EXPECT_EQ(rig.steps(), before);
    EXPECT_TRUE(rig.shape().edits.empty());
}

TEST(TetrahedraTool, FitsTetrahedraToWhatTheyHold)
{
    Rig rig;
    ASSERT_TRUE(rig.editor.session.run(AddTorus{}));
    rig.wait();
    rig.editor.session.selected = 1;
    action(rig.editor, fitted_tetrahedra_action).run(rig.editor);
    rig.wait();
    const auto& shape = std::get<TetrahedraShape>(object(rig.editor.session.document(), 2).source);
    EXPECT_GE(shape.cells.size(), 200U);
    const auto& shown = *rig.editor.session.evaluated().objects.at(2);
    ASSERT_TRUE(shown.tetrahedra);
}

TEST(TetrahedraTool, FitsTetrahedraToFacesAndNotToTheirCornersAlone)
{
    Rig rig;
    ASSERT_TRUE(rig.editor.session.run(AddBox{.shape = {.segments = glm::ivec3(1)}}));
    rig.wait();
    rig.editor.session.selected = 1;
    action(rig.editor, fitted_tetrahedra_action).run(rig.editor);
    rig.wait();
    const Evaluation& all = rig.editor.session.evaluated();
    const SimplexDomain<3>& domain = all.objects.at(2)->tetrahedra->volume->layers[0]->domain();
    SimplexMesh<3> mesh{{}, domain.cells};
    for (std::size_t v = 0; v < domain.vertex_count(); ++v)
        mesh.vertices.push_back(domain.vertex(static_cast<int>(v)));
    const CellSearch search(mesh);
    const Part part = all.objects.at(1)->parts.at(0);
    const glm::dmat4 to_volume =
        glm::inverse(all.objects.at(2)->tetrahedra_to_world) * part.to_world;
    const std::vector<glm::vec3>& p = part.mesh()->positions;
    for (const glm::uvec3& t : triangles(*part.mesh()))
        for (int a = 0; a <= 10; ++a)
            for (int b = 0; a + b <= 10; ++b) {
                const glm::dvec3 at =
                    (glm::dvec3(p[t.x]) * double(a) + glm::dvec3(p[t.y]) * double(b) +
                     glm::dvec3(p[t.z]) * double(10 - a - b)) /
                    10.0;
                EXPECT_GE(search.cell_at(glm::dvec3(to_volume * glm::dvec4(at, 1))), 0);
            }
}

TEST(TetrahedraPoints, AreMovedByHandEachAlone)
{
    TetrahedraRig rig;
    rig.choose(TetrahedraTool::By::points);
    const std::size_t before = rig.steps(), nearest = rig.nearest_place();
    const ControlPlace place = rig.places()[nearest];
    const glm::vec2 at = rig.seen_in(place.rest);
    rig.draw({at, at + glm::vec2(20, 0)});
    rig.wait();
    EXPECT_EQ(rig.steps(), before + 1);
    ASSERT_EQ(rig.shape().edits.size(), 1U);
    const TetrahedraPull& pull = *rig.shape().edits[0].pull;
    EXPECT_LE(glm::distance(pull.at, place.rest), 1e-6);
    EXPECT_GT(pull.by.x, 0.01);
    EXPECT_TRUE(pull.also.empty());
    const std::vector<glm::dvec3>& moved = rig.volume().displacements;
    for (std::size_t i = 0; i < moved.size(); ++i)
        EXPECT_EQ(moved[i] != glm::dvec3(0),
                  std::ranges::count(place.points, static_cast<int>(i)) == 1);
    EXPECT_LE(glm::distance(rig.seen_in(place.rest + pull.by), at + glm::vec2(20, 0)), 2);
}

TEST(TetrahedraPoints, GoByKeysAsOthersDo)
{
    TetrahedraRig rig;
    rig.choose(TetrahedraTool::By::points);
    const glm::vec2 at = rig.seen_in(rig.places()[rig.nearest_place()].rest);
    rig.click(at);
    rig.key({'A'}); // all
    rig.key({'G'});
    rig.key({'X'});
    rig.type("0.1");
    rig.key({ui::key_enter});
    rig.wait();
    ASSERT_EQ(rig.shape().edits.size(), 1U);
    EXPECT_EQ(rig.shape().edits[0].pull->by, glm::dvec3(0.1, 0, 0));
    EXPECT_EQ(rig.shape().edits[0].pull->also.size() + 1, rig.places().size());
    for (const glm::dvec3& d : rig.volume().displacements) EXPECT_EQ(d, glm::dvec3(0.1, 0, 0));
    const auto names = rig.tool().parts()->numbers(rig.editor.session);
    ASSERT_TRUE(names);
    EXPECT_EQ(names->front(), "shape.edits.0.pull.by.x");
}

TEST(TetrahedraPoints, AreChosenInABoxAndTurnAboutTheirMiddle)
{
    TetrahedraRig rig;
    rig.choose(TetrahedraTool::By::points);
    const ui::Rect view = rig.layout().view;
    rig.draw({view.lo + 6.0f, view.hi - 6.0f});
    rig.key({'R'});
    rig.key({'Z'});
    rig.type("90");
    rig.key({ui::key_enter});
    rig.wait();
    ASSERT_EQ(rig.shape().edits.size(), 1U);
    EXPECT_EQ(rig.shape().edits[0].pull->rotation_deg, glm::dvec3(0, 0, 90));
    const glm::dvec3 p{0.3, 0.1, 0.2}, q = evaluate(rig.volume(), p).position;
    glm::dvec3 middle(0);
    const std::vector<ControlPlace> all = rig.places();
    for (const ControlPlace& each : all) middle += each.rest / static_cast<double>(all.size());
    const glm::dvec3 from = p - middle;
    EXPECT_LE(glm::distance(q, middle + glm::dvec3(-from.y, from.x, from.z)), 1e-9);
}

TEST(TetrahedraPoints, LeaveNoTraceWhenCancelled)
{
    TetrahedraRig rig;
    rig.choose(TetrahedraTool::By::points);
    const std::size_t before = rig.steps();
    const glm::vec2 at = rig.seen_in(rig.places()[rig.nearest_place()].rest);
    rig.draw({at, at + glm::vec2(30, 0)}, false);
    rig.wait();
    EXPECT_EQ(rig.shape().edits.size(), 1U);
    rig.key({ui::key_escape});
    rig.wait();
    EXPECT_EQ(rig.steps(), before);
    EXPECT_TRUE(rig.shape().edits.empty());
}

// The upper vertex of the domain that is nearest to the eye.
int nearest_vertex(const SimplexDomain<3>& domain)
{
    int out = 0;
    for (int v = 0; v < static_cast<int>(domain.vertex_count()); ++v)
        if (domain.vertex(v).y - domain.vertex(v).z <
            domain.vertex(out).y - domain.vertex(out).z - 1e-9)
            out = v;
    return out;
}

TEST(TetrahedraKnots, AreMovedByHandAndStopBeforeCloudsCross)
{
    TetrahedraRig rig;
    rig.choose(TetrahedraTool::By::knots);
    const SimplexDomain<3> domain = rig.volume().layers[0]->domain();
    const int vertex = nearest_vertex(domain);
    rig.click(rig.seen_in(domain.vertex(vertex)));
    const std::size_t before = rig.steps();
    const glm::vec2 at = rig.seen_in(domain.knot(vertex, 2));
    rig.draw({at, at + glm::vec2(6, 4)});
    rig.wait();
    EXPECT_EQ(rig.steps(), before + 1);
    ASSERT_EQ(rig.shape().edits.size(), 1U);
    const TetrahedraCloud first = *rig.shape().edits[0].cloud;
    EXPECT_EQ(first.at, domain.vertex(vertex));
    EXPECT_EQ(first.knot, 2);
    EXPECT_LE(glm::distance(rig.volume().layers[0]->domain().knot(vertex, 2),
                            domain.knot(vertex, 2) + first.by),
              1e-12);
    const glm::vec2 now = rig.seen_in(rig.volume().layers[0]->domain().knot(vertex, 2));
    rig.draw({now, rig.layout().view.center() + glm::vec2(0, 120)}); // through the domain
    rig.wait();
    EXPECT_EQ(rig.shape().edits.size(), 1U); // both drags of the knot
    const SimplexDomain<3>& last = rig.volume().layers[0]->domain();
    const double room = cloud_room(last, cells_round(last, vertex));
    EXPECT_GE(room, least_room - 1e-9);
    EXPECT_LE(room, least_room + 1e-6);
}

TEST(TetrahedraKnots, AreScaledAsACloud)
{
    TetrahedraRig rig;
    rig.choose(TetrahedraTool::By::knots);
    const SimplexDomain<3> domain = rig.volume().layers[0]->domain();
    const int vertex = nearest_vertex(domain);
    rig.click(rig.seen_in(domain.vertex(vertex)));
    rig.key({'S'});
    rig.type("0.5");
    rig.key({ui::key_enter});
    rig.wait();
    ASSERT_EQ(rig.shape().edits.size(), 1U);
    EXPECT_EQ(*rig.shape().edits[0].cloud,
              (TetrahedraCloud{.at = domain.vertex(vertex), .factor = 0.5}));
}

TEST(TetrahedraTool, FillsHullsAndCages)
{
    for (const Around around : {Around::hull, Around::cage}) {
        Rig rig;
        ASSERT_TRUE(rig.editor.session.run(AddBox{.shape = {.size = {1, 1, 2}}}));
        ASSERT_TRUE(rig.editor.session.run(AddSphere{.shape = {.radius = 0.3}}));
        rig.wait();
        rig.editor.session.selected.set({2, 1}); // the box is the active one
        ASSERT_EQ(rig.editor.session.selected, 1);
        ASSERT_TRUE(put_tetrahedra_round_selection(rig.editor.session, around));
        rig.wait();
        const Document& document = rig.editor.session.document();
        const auto& shape = std::get<TetrahedraShape>(object(document, 3).source);
        EXPECT_GE(shape.cells.size(), 200U);
        EXPECT_TRUE(rig.editor.session.evaluated().objects.at(3)->tetrahedra);
        EXPECT_EQ(object(document, 2).parent, 3);
        EXPECT_EQ(object(document, 1).parent, around == Around::cage ? 0 : 3);
        EXPECT_EQ(object(document, 1).hidden, around == Around::cage);
    }
}

TEST(TetrahedraTool, SaysWhyACageThatIsOpenIsNone)
{
    Rig rig;
    ASSERT_TRUE(rig.editor.session.run(AddPlane{}));
    rig.wait();
    rig.editor.session.selected = 1;
    const std::size_t before = rig.steps();
    EXPECT_FALSE(put_tetrahedra_round_selection(rig.editor.session, Around::cage));
    EXPECT_EQ(rig.steps(), before);
}

} // namespace
} // namespace trivar
