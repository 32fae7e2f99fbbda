// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/cutting/incise.h"
#include "core/commands/cutting/peel.h"
#include "editor/panels/inspector/incision_rows.h"
#include "editor/panels/inspector/wound_section.h"
#include "tests/editor/panels/number_rows.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

NamedIncision straight_incision()
{
    NamedIncision out;
    for (int i = -4; i <= 4; ++i) {
        const glm::dvec3 n = glm::normalize(glm::dvec3(0.12 * i, -1, 0.1));
        out.cut.stroke.push_back({n, n});
    }
    out.cut.floor = Incision::Floor::u;
    out.cut.width = 0.08;
    return out;
}

// A ball with two incisions, of which the first is chosen, and its inspector.
struct IncisionSection : testing::Rig {
    IncisionSection() : Rig({1100, 1900})
    {
        EXPECT_TRUE(editor.session.run(AddSphere{.shape = {.radius = 1}}));
        EXPECT_TRUE(editor.session.run(Incise{1, straight_incision()}));
        NamedIncision other = straight_incision();
        for (SurfacePoint& each : other.cut.stroke) each.p.z = each.normal.z = -each.p.z;
        EXPECT_TRUE(editor.session.run(Incise{1, other}));
        editor.session.selected = 1;
        editor.session.incision = {1, 1};
        editor.preferences.timeline_open = false;
        wait();
    }
    const NamedIncision& one() const
    {
        return object(editor.session.committed(), 1).incising->cuts.at(0);
    }
    const Action& action(const std::string& name) const
    {
        return *std::ranges::find(editor.actions, name, &Action::name);
    }
    void type_into(const std::string& name, const std::string& text)
    {
        type_into_row("incising.cuts.0." + name, text);
    }
    void type_into_row(const std::string& parameter, const std::string& text)
    {
        click(testing::number_field(*this, parameter));
        frames(4);
        type(text);
        key({ui::key_enter});
        wait();
    }
};

TEST(IncisionSection, EveryNumberDrivesItsFieldInOneStep)
{
    IncisionSection rig;
    const NamedIncision before = rig.one();
    NamedIncision wanted = before;
    const auto expect = [&](const std::string& name, const std::string& text, double& field,
                            double value) {
        const std::size_t steps = rig.steps();
        rig.type_into(name, text);
        field = value;
        EXPECT_EQ(rig.steps(), steps + 1) << name;
        EXPECT_EQ(rig.one(), wanted) << name;
    };
    expect("opening", "40", wanted.opening.share, 0.4);
    expect("width", "0.05", wanted.cut.width, 0.05);
    expect("depth", "0.2", wanted.cut.depth, 0.2);
    expect("floor_width", "30", wanted.cut.floor_width, 0.3);
    expect("lean_deg", "10", wanted.cut.lean_deg, 10);
    expect("bevel", "0.01", wanted.cut.bevel, 0.01);
    expect("roundness", "50", wanted.cut.roundness, 0.5);
    expect("reach", "0.3", wanted.cut.reach, 0.3);
    expect("from", "10", wanted.opening.from, 0.1);
    expect("to", "80", wanted.opening.to, 0.8);
    for (int i = 0; i < 10; ++i) rig.editor.session.undo();
    EXPECT_EQ(rig.one(), before);
}

TEST(IncisionSection, RaisesAndLaysFlaps)
{
    IncisionSection rig;
    EXPECT_TRUE(rig.editor.session.run(PeelFlap{1, {.lift = 0.02}}));
    rig.wait();
    const std::size_t steps = rig.steps();
    rig.type_into_row("incising.flaps.0.lift", "0.05");
    EXPECT_EQ(rig.steps(), steps + 1);
    EXPECT_EQ(object(rig.editor.session.committed(), 1).incising->flaps.at(0).lift, 0.05);
}

TEST(IncisionSection, ClearsAllIncisionsOfTheSelection)
{
    IncisionSection rig;
    const Action& clear = rig.action("Clear incisions");
    EXPECT_TRUE(clear.enabled.holds(rig.editor));
    clear.run(rig.editor);
    rig.wait();
    EXPECT_FALSE(object(rig.editor.session.committed(), 1).incising);
    EXPECT_EQ(rig.editor.session.incision, ChosenIncision{});
    EXPECT_FALSE(clear.enabled.holds(rig.editor));
}

TEST(IncisionSection, BeginsACustomProfileLikeTheOneBefore)
{
    for (const IncisionProfile::Shape shape :
         {IncisionProfile::Shape::lens, IncisionProfile::Shape::even}) {
        const IncisionProfile before{shape, {}};
        const IncisionProfile custom{IncisionProfile::Shape::custom, custom_points(before)};
        for (double x = 0; x <= 1; x += 0.05)
            EXPECT_NEAR(value_at(custom, x), value_at(before, x), 0.12) << x;
    }
}

TEST(WoundSection, ALineOverAProfileChangesItThereOnly)
{
    const IncisionProfile before{IncisionProfile::Shape::lens, {}};
    const IncisionProfile after = drawn_over(before, {0.6, 0.2}, {0.4, 0.3});
    EXPECT_NEAR(value_at(after, 0.5), 0.25, 0.03);
    for (const double x : {0.1, 0.2, 0.3, 0.7, 0.8, 0.9})
        EXPECT_NEAR(value_at(after, x), value_at(before, x), 0.05) << x;
    EXPECT_EQ(value_at(after, 0), 0);
    EXPECT_EQ(value_at(after, 1), 0);
}

TEST(WoundSection, KnowsHowThickTheBodyIs)
{
    IncisionSection rig;
    IncisedSkin skin;
    skin.look(rig.editor.session, 1);
    const WoundSection section = section_of(skin, rig.one(), {});
    EXPECT_NEAR(section.length, 0.95, 0.1);
    ASSERT_EQ(section.thickness.size(), SeenIncision::steps + 1);
    for (const double each : section.thickness) EXPECT_NEAR(each, 2, 0.05);
}

} // namespace
} // namespace trivar
