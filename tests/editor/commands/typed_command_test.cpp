// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/objects/view.h"
#include "core/commands/placement/place.h"
#include "editor/commands/typed_command.h"

#include "core/base/rejected.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

Document two_objects()
{
    Document document = after({}, AddBox{.name = "Rock", .shape = {}, .transform = {}});
    return after(document, AddSphere{.name = "Sea shell",
                                     .shape = {},
                                     .transform = {.translation = {1, 2, 3}, .scale = {2, 2, 2}}});
}
Command typed(std::string_view text, const Document& document = two_objects())
{
    return std::get<Command>(typed_line(text, document).what);
}
std::string refusal(std::string_view text)
{
    try {
        typed_line(text, two_objects());
    } catch (const Rejected& why) {
        return why.what();
    }
    return "";
}

TEST(TypedCommand, TakesObjectsByNameOrNumberAndBareWords)
{
    EXPECT_EQ(typed("rename object=Rock name=Stone"), Command(Rename{1, "Stone"}));
    EXPECT_EQ(typed("  rename object=\"Sea shell\"   name=\"A b\" "), Command(Rename{2, "A b"}));
    EXPECT_EQ(typed("delete objects=[\"Rock\", 2]"), Command(Delete{{1, 2}}));
    EXPECT_EQ(typed("hide objects=Rock"), Command(Hide{{1}}));
}

TEST(TypedCommand, TakesALineOfTheFileAsItStands)
{
    const Command command = SetTransform{2, {.translation = {0.1, 1.0 / 3, 0}}};
    EXPECT_EQ(typed(to_json_line(command)), command);
    EXPECT_TRUE(std::holds_alternative<UndoLine>(typed_line("undo", {}).what));
    EXPECT_TRUE(std::holds_alternative<RedoLine>(typed_line("{\"redo\":true}", {}).what));
}

TEST(TypedCommand, KeepsWhatIsNotTypedOfATransformAndOfAPlacement)
{
    EXPECT_EQ(typed("transform object=\"Sea shell\" translation=[0,0,9]"),
              Command(SetTransform{2, {.translation = {0, 0, 9}, .scale = {2, 2, 2}}}));
    RenderSettings clay;
    clay.look = "clay";
    Document document = after(two_objects(), SetRender{clay});
    clay.exposure = 1;
    EXPECT_EQ(typed("set_render exposure=1", document), Command(SetRender{clay}));
    Sketch sketch;
    sketch.samples = {{{10, 10}, 0, 1}, {{200, 10}, 1, 1}, {{400, 30}, 2, 1}};
    PlacementParameters p;
    p.height = 3;
    document = after(document, Place{2, sketch, p, {1}});
    p.width = 0.24;
    EXPECT_EQ(typed("edit_placement object=2 parameters.width=0.24", document),
              Command(EditPlacement{2, p, {}, {}}));
}

TEST(TypedCommand, ComesBackFromItsOwnText)
{
    const Document document = two_objects();
    for (const Command& command :
         {Command(Rename{2, "a \"b\" = c"}), Command(Hide{{1, 2}}),
          Command(SetTransform{1, {.rotation_deg = {0, 0, 30}}}), Command(AddTorus{}),
          Command(KeepView{"front", {}}), Command(SetMaterial{{2}, {}})})
        EXPECT_EQ(typed(typed_text(command, document), document), command)
            << typed_text(command, document);
}

TEST(TypedCommand, SaysInASentenceWhatIsWrong)
{
    using ::testing::HasSubstr;
    EXPECT_EQ(refusal("fly object=Rock"), "There is no command \"fly\". Tab lists them.");
    EXPECT_EQ(refusal("delete objects=Pebble"), "No object is called Pebble.");
    EXPECT_THAT(refusal("rename Rock"), HasSubstr("field=value"));
    EXPECT_EQ(refusal("rename object="), "\"object\" has no value.");
    EXPECT_EQ(refusal("rename object=1 object=2"), "\"object\" is given twice.");
    EXPECT_THAT(refusal("rename object=1"), HasSubstr("\"name\" is missing"));
    EXPECT_THAT(refusal("add_box size=[1,2"), HasSubstr("not closed"));
    EXPECT_THAT(refusal("add_box size.x=[1,2] size=3"), HasSubstr("twice"));
    EXPECT_NE(refusal("{\"do\":1"), "");
    for (const char* text : {"", " ", "=", "a=b", "\"", "rename =", "rename object=\"", "add_box ]",
                             "rename object.a.b=1 object.a=2", "rename object=1e999 name=x",
                             "rename object=[[[[]]]] name=x"})
        EXPECT_NE(refusal(text), "") << text;
    EXPECT_EQ(refusal("rename object=" + std::string(100000, '[')), "Brackets nest too deeply.");
}

TEST(TypedCommand, IsContinuedAsFarAsItIsCertain)
{
    const Document document = two_objects();
    const auto text = [&](std::string_view typed) { return completed(typed, document).text; };
    EXPECT_EQ(text("ren"), "rename ");
    EXPECT_EQ(text("add_t"), "add_t");
    EXPECT_THAT(completed("add_t", document).words,
                ::testing::ElementsAre("add_torus", "add_teapot", "add_text", "add_tetrahedra"));
    EXPECT_EQ(text("rename o"), "rename object=");
    EXPECT_EQ(text("rename object=S"), "rename object=S"); // it wants a quote
    EXPECT_EQ(text("rename object=\""), "rename object=\"Sea shell\" ");
    EXPECT_EQ(text("rename object=Ro"), "rename object=Rock ");
    EXPECT_EQ(text("rename object=Rock "), "rename object=Rock name=");
    EXPECT_EQ(text("xyzzy "), "xyzzy ");
}

} // namespace
} // namespace trivar
