// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/view.h"
#include "core/commands/placement/place.h"
#include "editor/commands/command_form.h"

#include "core/base/rejected.h"
#include "editor/commands/as_it_is.h"
#include "editor/commands/typed_command.h"
#include "editor/editor.h"
#include "tests/editor/rig.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::ElementsAre, ::testing::HasSubstr;

Document scene()
{
    Document document = after({}, AddBox{.name = "Rock", .shape = {}, .transform = {}});
    document =
        after(document, AddSphere{.name = "Say \"hi\", twice", .shape = {}, .transform = {}});
    document = after(document, AddBox{.name = "Twin", .shape = {}, .transform = {}});
    document = after(document, AddBox{.name = "Twin", .shape = {}, .transform = {}});
    return after(document, SetTransform{2, {.translation = {1, 2, 3}, .scale = {2, 2, 2}}});
}

CommandForm form(const Command& command, const Document& document = scene())
{
    return *form_of(command, "Any", document);
}
CommandForm::Field& field(CommandForm& form, std::string_view name)
{
    return *std::ranges::find(form.fields, name, &CommandForm::Field::name);
}
Command with(const Command& ready, std::string_view name, const std::string& typed)
{
    CommandForm any = form(ready);
    field(any, name).typed = typed;
    return filled(any, scene());
}

TEST(CommandForm, AsksForEveryValueThatCanBeTyped)
{
    const CommandForm add = form(AddBox{});
    std::vector<std::string> names;
    for (const auto& each : add.fields) names.push_back(each.name);
    EXPECT_THAT(names, ElementsAre("name", "size", "segments", "transform.translation",
                                   "transform.rotation_deg", "transform.scale"));
    EXPECT_EQ(add.fields[1].unit, "m");
    EXPECT_EQ(add.fields[3].label, "Position");
    EXPECT_EQ(add.fields[5].present, "1 1 1");
    EXPECT_FALSE(form_of(Relink{}, "Relink", scene())) << "nobody types a list of files";
    for (const Command& each : every_command())
        if (const auto any = form_of(each, "Any", scene())) {
            EXPECT_NO_THROW(filled(*any, scene())) << verb(each);
        }
}

TEST(CommandForm, LeavesWhatIsNotTypedAsItIs)
{
    const Command ready = *as_it_is(SetTransform{}, 2, scene());
    EXPECT_EQ(filled(form(ready), scene()), ready);
    EXPECT_EQ(with(ready, "translation", "0 0 9"),
              Command(SetTransform{2, {.translation = {0, 0, 9}, .scale = {2, 2, 2}}}));
    EXPECT_EQ(with(ready, "object", "Rock"), Command(SetTransform{1, {}})) << "of that object";
}

TEST(CommandForm, ReadsNumbersAsPeopleTypeThem)
{
    const Command ready = *as_it_is(SetTransform{}, 2, scene());
    const auto moved = [&](const std::string& typed) {
        return with(ready, "translation", typed).get<SetTransform>().transform.translation;
    };
    EXPECT_EQ(moved("12 mm, 5 mm, 0"), glm::dvec3(0.012, 0.005, 0));
    EXPECT_EQ(moved("12 mm 5 mm 0"), glm::dvec3(0.012, 0.005, 0));
    EXPECT_EQ(moved("[1,2,4]"), glm::dvec3(1, 2, 4));
    EXPECT_EQ(moved("+=1 2 max(1, 3)"), glm::dvec3(2, 2, 3));
    EXPECT_EQ(with(SetRender{}, "exposure", "1 + 1/2").get<SetRender>().settings.exposure, 1.5);
}

TEST(CommandForm, ReadsPointsAsPairsBetweenCommas)
{
    Place ready;
    ready.object = 1;
    ready.sketch.camera.size_px = {800, 600};
    CommandForm place = form(ready);
    EXPECT_EQ(place.fields[0].name, "object");
    EXPECT_EQ(place.fields[1].name, "samples") << "the view is asked for last";
    EXPECT_THAT(place.fields[1].help, HasSubstr("800 by 600"));
    EXPECT_TRUE(place.fields.back().name.starts_with("camera."));
    const auto points = [&](const std::string& typed) {
        place.fields[1].typed = typed;
        std::vector<glm::dvec2> all;
        const Command command = filled(place, scene());
        for (const StrokeSample& each : command.get<Place>().sketch.samples)
            all.push_back(each.p_px);
        return all;
    };
    const std::vector<glm::dvec2> line{{200, 300}, {400.5, 320}};
    EXPECT_EQ(points("200 300, 400.5 320"), line);
    EXPECT_EQ(points("[[200,300,0,1],[400.5,320,0.1,1]]"), line);
    EXPECT_EQ(points("800/4 300; 400.5 320;"), line);
    EXPECT_THROW(points("200 300, 400"), Rejected);
    EXPECT_THROW(points("200 300, 400 far"), Rejected);
    EXPECT_THROW(points("[["), Rejected);
    place.at = 1;
    place.fields[1].typed.clear();
    const auto options = options_of(place, scene());
    ASSERT_FALSE(options.empty()) << "a stroke to begin with";
    take(place, options.front());
    EXPECT_NO_THROW(filled(place, scene()));
    EditPlacement edit;
    edit.object = 1;
    EXPECT_EQ(with(edit, "parameters.height_map", "1 1 1, 1 2 1"),
              with(edit, "parameters.height_map", "[[1,1,1],[1,2,1]]"));
    EXPECT_EQ(with(edit, "parameters.width_profile", "0 1, 0.5 2, 1 1"),
              with(edit, "parameters.width_profile", "[[0,1],[0.5,2],[1,1]]"));
}

TEST(CommandForm, TakesObjectsWhateverTheyAreCalled)
{
    EXPECT_EQ(with(Hide{}, "objects", "Rock, \"Say \\\"hi\\\", twice\", 3"),
              Command(Hide{{1, 2, 3}}));
    EXPECT_EQ(with(Hide{}, "objects", "Say \"hi\", twice"), Command(Hide{{2}}));
    EXPECT_EQ(with(Rename{2, "x"}, "object", "Say \"hi\", twice"), Command(Rename{2, "x"}));
    EXPECT_EQ(with(Rename{1, "x"}, "name", "a \"b\" = c"), Command(Rename{1, "a \"b\" = c"}));
    EXPECT_EQ(with(Reorder{{1}, 0, 0}, "before", "Rock"), Command(Reorder{{1}, 0, 1}));
}

TEST(CommandForm, OffersWhatFitsAndCompletesIt)
{
    CommandForm hide = form(Hide{});
    hide.fields[0].typed = "Rock, sayhi";
    auto options = options_of(hide, scene());
    ASSERT_EQ(options.size(), 1u);
    take(hide, options[*taken_option(hide, options, scene())]);
    EXPECT_EQ(hide.fields[0].typed, "Rock, \"Say \\\"hi\\\", twice\"");
    EXPECT_EQ(filled(hide, scene()), Command(Hide{{1, 2}}));
    hide.fields[0].typed = "twi";
    options = options_of(hide, scene());
    EXPECT_EQ(options.front().typed, "3") << "a name that two have";
    CommandForm material = form(SetMaterial{{1}, {}});
    material.at = static_cast<std::size_t>(
        std::ranges::find(material.fields, "solid", &CommandForm::Field::name) -
        material.fields.begin());
    ASSERT_LT(material.at, material.fields.size());
    material.fields[material.at].typed = "wo";
    options = options_of(material, scene());
    ASSERT_EQ(options.size(), 1u);
    EXPECT_EQ(options[0].words, "wood");
    material.fields[material.at].typed.clear();
    EXPECT_FALSE(taken_option(material, options_of(material, scene()), scene()));
}

TEST(CommandForm, SaysWhichValueIsWrong)
{
    const auto refusal = [](const Command& ready, std::string_view name, const std::string& typed) {
        try {
            with(ready, name, typed);
        } catch (const Rejected& why) {
            return std::string(why.what());
        }
        return std::string();
    };
    EXPECT_EQ(refusal(SetMaterial{{1}, {}}, "metallic", "shiny"),
              "field \"metallic\" must be a number, not \"shiny\"");
    EXPECT_THAT(refusal(SetMaterial{{1}, {}}, "base_color", "1 2"), HasSubstr("4 numbers"));
    EXPECT_EQ(refusal(Hide{}, "objects", "Rock, Pebble"), "No object is called Pebble.");
    EXPECT_THAT(refusal(Hide{}, "objects", "Twin"), HasSubstr("Two objects are called Twin"));
    for (const char* typed : {"\"", "[", "]", ",", "((", "1e999", "\\", "\"\\", ", ,", "-"})
        for (const char* name : {"translation", "object"})
            EXPECT_NO_FATAL_FAILURE(refusal(SetTransform{1, {}}, name, typed)) << typed;
}

// The palette with the values of the command that was found first.
void fill(testing::Rig& rig, const std::string& letters)
{
    rig.key({.key = 'P', .ctrl = true, .shift = true});
    rig.type(letters);
    rig.key({.key = ui::key_tab});
    ASSERT_TRUE(rig.editor.palette.filling) << letters;
}

TEST(FillingValues, ShowsTheResultAndEndsAsOneStep)
{
    testing::Rig rig({1024, 700});
    rig.two_objects();
    const std::size_t before = rig.steps();
    fill(rig, "set mater");
    rig.key({.key = ui::key_tab}); // past the objects
    rig.type("1 0 0 1");
    EXPECT_TRUE(rig.editor.session.proposing());
    EXPECT_EQ(object(rig.editor.session.document(), 2).surfacing->base_color,
              glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(rig.steps(), before);
    rig.key({.key = ui::key_enter});
    EXPECT_FALSE(rig.editor.palette.open);
    EXPECT_FALSE(rig.editor.session.proposing());
    EXPECT_EQ(rig.steps(), before + 1);
    EXPECT_EQ(rig.editor.session.selected.ids(), std::vector<Id>{2});
}

TEST(FillingValues, LaysAModelAlongAStrokeThatIsTyped)
{
    testing::Rig rig({1024, 700});
    rig.two_objects();
    rig.editor.session.selected = 0;
    const std::size_t before = rig.steps();
    const glm::dvec2 c = rig.editor.session.view.camera.size_px / 2.0;
    fill(rig, "place");
    ASSERT_EQ(rig.editor.palette.filling->form.title, "Place");
    EXPECT_EQ(rig.editor.palette.filling->form.fields[0].present, "Box");
    rig.key({.key = ui::key_tab});
    rig.type("100");
    rig.key({.key = ui::key_tab});
    EXPECT_FALSE(rig.editor.palette.filling->form.trouble.empty()) << "a point has two numbers";
    EXPECT_FALSE(rig.editor.session.proposing());
    rig.type("100 " + std::to_string(int(c.y)) + ", " + std::to_string(int(c.x)) + " " +
             std::to_string(int(c.y)) + ", " + std::to_string(int(c.x) + 150) + " " +
             std::to_string(int(c.y)));
    EXPECT_TRUE(rig.editor.session.proposing());
    EXPECT_TRUE(object(rig.editor.session.document(), 2).stroke) << "shown before it is done";
    rig.key({.key = ui::key_enter});
    EXPECT_FALSE(rig.editor.palette.open);
    rig.wait();
    EXPECT_EQ(rig.steps(), before + 1);
    ASSERT_TRUE(object(rig.editor.session.committed(), 2).stroke);
    EXPECT_EQ(object(rig.editor.session.committed(), 2).stroke->sketch.samples.size(), 3u);
    EXPECT_EQ(rig.editor.session.selected.ids(), std::vector<Id>{2});
}

TEST(FillingValues, LeavesNoTraceWhenItIsCancelled)
{
    testing::Rig rig({1024, 700});
    rig.two_objects();
    const Document before = rig.editor.session.committed();
    const std::size_t lines = rig.editor.session.scene().lines().size();
    fill(rig, "delete");
    rig.frames();
    EXPECT_EQ(rig.editor.session.document().objects.size(), 1u) << "as it would be";
    rig.key({.key = ui::key_escape});
    EXPECT_FALSE(rig.editor.palette.open);
    EXPECT_TRUE(std::ranges::equal(rig.editor.session.document().objects, before.objects));
    EXPECT_EQ(rig.editor.session.selected.ids(), std::vector<Id>{2});
    EXPECT_EQ(rig.editor.session.scene().lines().size(), lines);
    EXPECT_TRUE(rig.editor.session.refused().empty());
}

TEST(FillingValues, SaysWhatIsWrongAndChangesNothing)
{
    testing::Rig rig({1024, 700});
    rig.two_objects();
    const std::size_t before = rig.steps();
    fill(rig, "set mater");
    rig.key({.key = ui::key_tab});
    rig.key({.key = ui::key_tab});
    rig.type("shiny");
    rig.key({.key = ui::key_tab});
    ASSERT_TRUE(rig.editor.palette.filling);
    const CommandForm& form = rig.editor.palette.filling->form;
    EXPECT_EQ(form.at, 2u) << "it stays there";
    EXPECT_THAT(form.trouble, HasSubstr("\"metallic\" must be a number"));
    rig.key({.key = ui::key_enter});
    EXPECT_TRUE(rig.editor.palette.open);
    EXPECT_EQ(rig.steps(), before);
    rig.type("0");
    EXPECT_TRUE(rig.editor.palette.filling->form.trouble.empty()) << "it may become right";
}

TEST(FillingValues, LosesNoLetterThatIsTypedBeforeTheNextFieldIsThere)
{
    testing::Rig rig({1024, 700});
    rig.two_objects();
    fill(rig, "add box");
    rig.screen.input().push(ui::press_key(ui::key_tab));
    rig.screen.input().push(ui::press_key(ui::key_tab, false));
    for (const char c : std::string("4 5 6"))
        rig.screen.input().push(ui::type_text(static_cast<unsigned char>(c)));
    rig.frames(8);
    rig.type("7");
    EXPECT_EQ(rig.editor.palette.filling->form.fields[1].typed, "4 5 67");
}

TEST(FillingValues, GoesBackToTheListBeforeTheFirstValue)
{
    testing::Rig rig({1024, 700});
    rig.two_objects();
    fill(rig, "add box");
    rig.type("Tower");
    rig.key({.key = ui::key_tab, .shift = true});
    EXPECT_FALSE(rig.editor.palette.filling);
    EXPECT_TRUE(rig.editor.palette.open);
    EXPECT_FALSE(rig.editor.session.proposing());
    rig.key({.key = ui::key_tab});
    rig.type("Tower");
    rig.key({.key = ui::key_tab});
    rig.type("1 1 5");
    rig.key({.key = ui::key_enter});
    const Document& document = rig.editor.session.committed();
    EXPECT_EQ(object(document, 3).name, "Tower");
    EXPECT_EQ(rig.editor.session.selected.ids(), std::vector<Id>{3});
}

} // namespace
} // namespace trivar
