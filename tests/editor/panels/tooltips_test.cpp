// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/words/field_words.h"
#include "tests/editor/rig.h"
#include "ui/sentence.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::IsSupersetOf;

struct Hovering : testing::Rig {
    Hovering() : Rig({1024, 700}) { two_objects(); }
    // Returns the tooltip once the mouse rests there.
    ui::Tip said_at(glm::vec2 at)
    {
        screen.input().push(ui::move_to(at));
        screen.settle(body(), 60);
        return ui::tooltips().shown().value_or(ui::Tip{""});
    }
    std::map<std::string, ui::Tip> said_along(glm::vec2 from, glm::vec2 to, float step)
    {
        std::map<std::string, ui::Tip> all;
        const float length = glm::distance(from, to);
        for (float t = 0; t <= length; t += step) {
            const ui::Tip tip = said_at(glm::mix(from, to, t / length));
            if (!tip.name.empty()) all[tip.name] = tip;
        }
        return all;
    }
};

TEST(Tooltips, NameEveryToolWithItsKeyAndWhatItDoes)
{
    Hovering hand;
    const ui::Rect strip = hand.layout().strip;
    for (std::size_t i = 0; i < hand.editor.tools.size(); ++i) {
        const Tool& tool = *hand.editor.tools[i];
        const ui::Tip tip =
            hand.said_at({strip.center().x, strip.lo.y + 24 + 40 * static_cast<float>(i)});
        EXPECT_EQ(tip.name, tool.name());
        EXPECT_EQ(tip.key, key_text(action(hand.editor, tool.name())));
        EXPECT_EQ(tip.sentence, tool.facts().help);
    }
}

TEST(Tooltips, StandOverTheBarsAndTheDock)
{
    using ::testing::Key; // a key of the document elsewhere
    Hovering hand;
    const Layout l = hand.layout();
    hand.editor.choose_tool(1);
    const auto row = [&](const ui::Rect& r, float y) {
        return hand.said_along({r.lo.x + 6, y}, {r.hi.x - 6, y}, 12);
    };
    EXPECT_THAT(row(l.timeline, l.timeline.center().y),
                IsSupersetOf({Key("Open the timeline"), Key("First frame"), Key("Previous frame"),
                              Key("Play or pause"), Key("Next frame"), Key("Last frame"),
                              Key("Play in a loop"), Key("Frame")}));
    EXPECT_THAT(row(l.options, l.options.center().y),
                IsSupersetOf({Key("Axes"), Key("Pivot"), Key("Ctrl snaps to")}));
    EXPECT_THAT(row(l.tabs, l.tabs.center().y),
                IsSupersetOf({Key("Inspector"), Key("History"), Key("Log")}));
    EXPECT_THAT(row(l.outliner, l.outliner.lo.y + 84), IsSupersetOf({Key("Hide"), Key("Lock")}));
    EXPECT_THAT(row({{l.top.hi.x - 260, 0}, l.top.hi}, l.top.center().y),
                IsSupersetOf({Key("Find a command")}));
    const float x = l.view.hi.x - 56;
    EXPECT_THAT(hand.said_along({x, l.view.lo.y + 10}, {x, l.view.lo.y + 190}, 8),
                IsSupersetOf({Key("Top"), Key("Frame all"), Key("Perspective")}));
}

TEST(Tooltips, SayOfAFieldWhatItsCommandSays)
{
    using ::testing::Key; // a key of the document elsewhere
    Hovering hand;
    const ui::Rect r = hand.layout().inspector;
    for (const float x : {r.lo.x + 40, r.lo.x + 160}) { // over the label and over the field
        const auto said = hand.said_along({x, r.lo.y}, {x, r.lo.y + 200}, 14);
        for (const auto& [label, field] :
             {std::pair("Position, m", "translation"), std::pair("Rotation, deg", "rotation_deg"),
              std::pair("Scale", "scale")}) {
            ASSERT_THAT(said, ::testing::Contains(Key(label)));
            EXPECT_EQ(said.at(label).sentence, help_of_field("transform", field));
        }
    }
    EXPECT_EQ(help_of_field("transform", "rotation_deg"), "about X, then Y, then Z")
        << "the unit stands in the field";
}

TEST(Tooltips, SayWhyAButtonCannotBePressed)
{
    testing::Rig rig({1024, 700});
    const Action& undo = action(rig.editor, "Undo");
    ASSERT_FALSE(is_enabled(rig.editor, undo));
    EXPECT_EQ(tip_of(rig.editor, undo, "Back.").sentence,
              "Back. " + ui::sentence(undo.enabled.otherwise));
}

} // namespace
} // namespace trivar
