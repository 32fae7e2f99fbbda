// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/hands/gesture_dice.h"

#include "core/commands/command.h"
#include "editor/actions/all_actions.h"
#include "editor/actions/palette_entries.h"
#include "editor/editor.h"
#include "tests/fuzz/json_damage.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

namespace trivar::testing {
namespace {

using Kind = Gesture::Kind;
using Words = std::vector<std::string>;
using CommandJson = nlohmann::ordered_json;

const Words absurd_texts{
    "0",          "-1",    "1e30", "-1e30", "nan",          "inf", "",     "abc",   "1/0", "1e-30",
    "=2*3",       "0.5",   "2cm",  "--",    "1e308",        "-0",  "7",    "100",   "1e9", "0.001",
    "4294967296", "%s%n",  ")",    "1,2,3", "\u00e4\u20ac", "3",   "12",   "-0.25", "90",  "0.1",
    "2",          "((((1", "1e-9", "-45",   "1000000",      "5 m", "10 %", "*2",    "+1",  "/3"};

double share(Dice& dice) // of 1, in thousandths: as it is written
{
    return static_cast<double>(dice.below(1001)) / 1000;
}

glm::dvec2 rounded(const glm::dvec2& p)
{
    return glm::round(p * 1000.0) / 1000.0;
}

bool once_in(Dice& dice, std::size_t count)
{
    return dice.below(count) == 0;
}

std::string absurd_text(Dice& dice)
{
    if (once_in(dice, 25)) return std::string(1 + dice.below(3000), once_in(dice, 2) ? '9' : 'a');
    return dice.one_of(absurd_texts);
}

// Near the middle of the picture, where something is.
glm::dvec2 on_body(Dice& dice)
{
    return {0.28 + 0.44 * share(dice), 0.25 + 0.5 * share(dice)};
}

// Anywhere in the picture, and a little beyond.
glm::dvec2 anywhere(Dice& dice)
{
    return {1.3 * share(dice) - 0.15, 1.3 * share(dice) - 0.15};
}

// A way that bends from where it begins.
std::vector<glm::dvec2> bent_way(Dice& dice, glm::dvec2 at, std::size_t count, double step)
{
    std::vector<glm::dvec2> out{at};
    double heading = 2 * std::numbers::pi * share(dice);
    const double turn = 1.2 * (share(dice) - 0.5);
    for (std::size_t i = 1; i < count; ++i) {
        heading += turn + 0.3 * (share(dice) - 0.5);
        at += step * glm::dvec2(std::cos(heading), std::sin(heading));
        out.push_back(rounded(at));
    }
    return out;
}

std::vector<glm::dvec2> some_way(Dice& dice)
{
    std::vector<glm::dvec2> out;
    switch (dice.below(10)) {
    case 0: // from the air over the body into the air
        out = {{0.02 + 0.1 * share(dice), share(dice)}, {0.88 + 0.1 * share(dice), share(dice)}};
        if (once_in(dice, 2)) std::ranges::reverse(out);
        break;
    case 1: // from the body into the air, and back
        out = {on_body(dice), anywhere(dice), on_body(dice)};
        break;
    case 2: // a scribble
        for (std::size_t i = 4 + dice.below(14); i > 0; --i) out.push_back(on_body(dice));
        break;
    case 3: // to and fro on one line
        out = {on_body(dice), on_body(dice)};
        out.push_back(out.front());
        break;
    case 4: out.assign(2 + dice.below(2), on_body(dice)); break; // a button that only goes down
    case 5: out = {on_body(dice), anywhere(dice)}; break;
    case 6: // begins in the air
        out = {anywhere(dice), on_body(dice), on_body(dice)};
        break;
    default: out = bent_way(dice, on_body(dice), 2 + dice.below(6), 0.02 + 0.12 * share(dice));
    }
    for (glm::dvec2& p : out) p = rounded(p);
    return out;
}

const Words areas{"inspector", "inspector", "inspector", "outliner", "options", "options",
                  "timeline",  "top",       "tabs",      "strip",    "status",  "window"};

std::string some_interruption(const GestureWords& words, Dice& dice)
{
    switch (dice.below(9)) {
    case 0: return "Esc";
    case 1: return "right";
    case 2: return "focus";
    case 3: return "turn";
    case 4: return "wheel";
    case 5: return "resize";
    case 6: return "type " + dice.one_of(absurd_texts);
    case 7: return dice.one_of(words.tools);
    default:
        return once_in(dice, 2)
                   ? dice.one_of(Words{"Ctrl+Z", "Ctrl+Y", "Del", "Tab", "Enter", "Space", "F3"})
                   : dice.one_of(words.chords);
    }
}

Words some_held(Dice& dice)
{
    if (!once_in(dice, 5)) return {};
    Words out;
    for (const char* key : {"Ctrl", "Shift", "Alt"})
        if (once_in(dice, 2)) out.emplace_back(key);
    return out;
}

Gesture some_stroke(const GestureWords& words, Dice& dice)
{
    Gesture g{.points = some_way(dice)};
    g.frames = 1 + static_cast<int>(dice.below(5));
    if (g.points.size() > 6) g.frames = 1;
    if (once_in(dice, 12)) { // from panel to panel, or over them
        g.area = dice.one_of(areas);
        g.points = {{share(dice), share(dice)}, {share(dice), share(dice)}};
    } else if (once_in(dice, 2)) { // over one of the objects, wherever that is
        g.area = "object";
        g.number = static_cast<int>(dice.below(4));
    }
    g.held = some_held(dice);
    if (once_in(dice, 15)) g.button = once_in(dice, 2) ? "middle" : "right";
    if (once_in(dice, 5)) {
        g.between = some_interruption(words, dice);
        g.at = share(dice);
    }
    g.hasty = once_in(dice, 8);
    g.keeps = once_in(dice, 40);
    return g;
}

// One of the entries that the click offers, if it does.
void choose_too(Gesture& g, Dice& dice)
{
    g.kind = Kind::choose;
    g.points.push_back({0.5, share(dice)});
}

Gesture some_click(Dice& dice)
{
    Gesture g{.kind = Kind::click, .points = {rounded(on_body(dice))}};
    if (once_in(dice, 3)) {
        g.area = "object";
        g.number = static_cast<int>(dice.below(5));
        g.points = {{share(dice), share(dice)}};
    }
    g.twice = once_in(dice, 5);
    if (once_in(dice, 6)) g.button = once_in(dice, 2) ? "middle" : "right";
    if (g.button == "right") choose_too(g, dice);
    g.held = some_held(dice);
    return g;
}

// Rows and fields of panels.
Gesture some_row(Dice& dice, const std::string& area)
{
    Gesture g{.kind = Kind::click, .area = area, .points = {{share(dice), share(dice)}}};
    if (area == "outliner") g.points = {{share(dice), rounded(glm::dvec2(0.5 * share(dice))).y}};
    if (area == "options") g.points.front().x = rounded(glm::dvec2(0.8 * share(dice))).x;
    if (area == "inspector") g.points.front().x = rounded(glm::dvec2(0.4 + share(dice) / 2)).x;
    switch (dice.below(6)) {
    case 0:
    case 1:
        if (area == "outliner") break;
        g.kind = Kind::field;
        g.text = absurd_text(dice);
        g.end = dice.one_of(Words{"Enter", "Enter", "Tab", "Esc", ""});
        break;
    case 2:
        g.kind = Kind::stroke;
        g.points.push_back({share(dice), area == "inspector" ? g.points.front().y : share(dice)});
        break;
    case 3: g.twice = true; break;
    case 4: choose_too(g, dice); break;
    default: g.held = some_held(dice);
    }
    if (g.points.size() < 2 && once_in(dice, 8)) {
        g.button = "right";
        choose_too(g, dice);
    }
    return g;
}

Gesture some_palette(const GestureWords& words, Dice& dice)
{
    Gesture g{.kind = Kind::palette, .text = dice.one_of(words.entries), .end = "Enter"};
    if (once_in(dice, 8)) g.text = absurd_text(dice);
    if (once_in(dice, 4)) g.end = dice.one_of(Words{"Tab", "Esc", "Ctrl+Enter", "Down"});
    return g;
}

// Names objects that may be there, where the line of a command has none.
void name_objects(CommandJson& value, Dice& dice)
{
    for (auto& [name, inner] : value.items()) {
        const bool names_one = name == "object" || name == "base" || name == "around" ||
                               name == "into" || name == "parent";
        if (names_one) inner = 1 + dice.below(4);
        if ((name == "objects" || name == "onto" || name == "bases") && inner.is_array())
            inner = {1 + dice.below(4)};
        if (inner.is_object()) name_objects(inner, dice);
    }
}

Gesture some_command(const GestureWords& words, Dice& dice)
{
    CommandJson json = CommandJson::parse(dice.one_of(words.commands));
    name_objects(json, dice);
    std::string line = json.dump();
    if (once_in(dice, 2)) line = with_values_replaced(line, dice);
    std::erase_if(line, [](unsigned char c) { return c < 32 || c > 126; });
    if (line.size() > 3000) line.resize(3000);
    return {.kind = Kind::command, .text = line, .end = "Enter"};
}

Gesture some_edit(Dice& dice)
{
    Gesture g{.kind = Kind::chord};
    g.text = dice.one_of(Words{"Ctrl+Z", "Ctrl+Z", "Ctrl+Z", "Ctrl+Y", "Ctrl+Y", "Del", "Shift+D",
                               "Ctrl+C", "Ctrl+V", "Ctrl+X", "Ctrl+A", "H", "Esc", "Enter", "Tab"});
    g.number = 1 + static_cast<int>(once_in(dice, 3) ? dice.below(12) : 0);
    return g;
}

Gesture some_rare(const StartScene& scene, Dice& dice)
{
    Gesture g;
    switch (dice.below(9)) {
    case 0:
    case 1:
        g.kind = Kind::save;
        g.text = dice.one_of(Words{"a.trivar", "b", "sub/c.trivar", "", "/nowhere/d.trivar"});
        break;
    case 2:
    case 3:
        g.kind = Kind::drop;
        g.text = once_in(dice, 3) ? "a.trivar" : dice.one_of(scene.files).name;
        break;
    case 4:
        g.kind = Kind::resize;
        g.points = {{200 + static_cast<double>(dice.below(900)),
                     150 + static_cast<double>(dice.below(600))}};
        break;
    case 5: g.kind = once_in(dice, 6) ? Kind::card : Kind::focus; break;
    case 6:
        g.kind = Kind::type;
        g.text = absurd_text(dice);
        g.end = dice.one_of(Words{"Enter", "Esc", ""});
        break;
    default:
        g.kind = Kind::wheel;
        g.number = static_cast<int>(dice.below(9)) - 4;
        g.area = once_in(dice, 3) ? dice.one_of(areas) : "view";
        g.points = {{share(dice), share(dice)}};
        g.held = some_held(dice);
    }
    return g;
}

Gesture some_gesture(const GestureWords& words, const StartScene& scene, Dice& dice)
{
    const std::size_t at = dice.below(100);
    if (at < 48) return some_stroke(words, dice);
    if (at < 54) return some_click(dice);
    if (at < 62) return some_row(dice, "inspector");
    if (at < 66) return some_row(dice, "outliner");
    if (at < 72) return some_row(dice, "options");
    if (at < 74) return some_row(dice, dice.one_of(areas));
    if (at < 81) return some_palette(words, dice);
    if (at < 85) return some_command(words, dice);
    if (at < 92) return some_edit(dice);
    if (at < 95) return {.kind = Kind::chord, .text = dice.one_of(words.chords)};
    return some_rare(scene, dice);
}

// Selects the object that a hand works at: mostly the one made for it.
Gesture some_selection(const StartScene& scene, Dice& dice)
{
    if (once_in(dice, 10)) return {.kind = Kind::chord, .text = "Ctrl+A"};
    Gesture g{.kind = Kind::click, .tool = "Q", .area = "object", .points = {{0.5, 0.5}}};
    g.number = once_in(dice, 4) ? static_cast<int>(dice.below(3)) : scene.main;
    return g;
}

} // namespace

GestureWords all_words()
{
    GestureWords out;
    const Editor editor([] {}, all_actions());
    for (const auto& tool : editor.tools)
        out.tools.push_back(ui::text_of(tool->facts().keys.front()));
    for (const Action& each : editor.actions)
        for (const ui::Chord& chord : each.keys) out.chords.push_back(ui::text_of(chord));
    for (const PaletteEntry& each : palette_commands(editor)) out.entries.push_back(each.name);
    for (const Command& each : every_command()) out.commands.push_back(to_json_line(each));
    return out;
}

std::vector<Gesture> drawn_gestures(const GestureWords& words, const StartScene& scene, Dice& dice,
                                    int count)
{
    std::string kept(1, scene.tools[dice.below(scene.tools.size())]);
    if (once_in(dice, 8)) kept = dice.one_of(words.tools);
    const bool keeps = !once_in(dice, 4);
    std::vector<Gesture> out;
    if (once_in(dice, 4)) out.push_back({.kind = Kind::chord, .text = "Shift+T"}); // the timeline
    while (std::ssize(out) < count) {
        if (out.empty() || once_in(dice, 8)) {
            out.push_back(some_selection(scene, dice));
            continue;
        }
        Gesture g = some_gesture(words, scene, dice);
        const bool works =
            (g.kind == Kind::stroke || g.kind == Kind::click) && g.area != "outliner";
        if (works && !once_in(dice, 5))
            g.tool = keeps && !once_in(dice, 8) ? kept : dice.one_of(words.tools);
        if (g.area == "object" && once_in(dice, 2)) g.number = scene.main;
        g.blind = once_in(dice, 6);
        out.push_back(std::move(g));
    }
    return out;
}

} // namespace trivar::testing
