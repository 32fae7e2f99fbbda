// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/hint_steps.h"

#include "core/commands/placement/place.h"
#include "editor/actions/actions.h"
#include "editor/actions/file_actions.h"
#include "editor/actions/model_actions.h"
#include "editor/editor.h"
#include "editor/jobs/background_evaluator.h"

#include <algorithm>

namespace trivar {
namespace {

constexpr const char *draw_hint = "draw", *let_go_hint = "let go", *widen_hint = "widen";

// The steps that are known: of which scene, and how many.
struct FollowedSteps {
    long scene = -1;
    std::size_t count = 0;
};

bool closed(const Editor& editor, const std::string& name)
{
    const auto& names = editor.preferences.closed_hints;
    return std::ranges::find(names, name) != names.end();
}

bool draws(const Editor& editor)
{
    const auto& proposal = editor.session.scene().history().proposal();
    return proposal && !editor.palette.open && proposal->command.is<Place>();
}

// Some of the models that come with the program, and files.
std::vector<std::string> offers_of_models(const Editor& editor, ModelUse use)
{
    constexpr std::size_t most = 6;
    std::vector<std::string> offers;
    for (const OwnModel& each : own_models())
        if (each.use == use && offers.size() < most && !editor.files.own_models_folder.empty())
            offers.emplace_back(each.name);
    offers.emplace_back(import_action);
    return offers;
}

HintCard card_before_a_stroke(const Editor& editor, std::size_t shapes, std::size_t texts)
{
    if (shapes < 2) {
        const bool below = shapes == 0 || texts > 0;
        return {draw_hint,
                0,
                shapes == 0  ? "Drop a scene here"
                : texts == 0 ? "Now drop the model to lay on it"
                             : "Now drop a scene to lay the text on",
                "Or add one from the Add menu.",
                "Or take one of these. The Add menu has more.",
                offers_of_models(editor, below ? ModelUse::stands : ModelUse::laid)};
    }
    if (editor.tools[editor.tool]->name() == "Place")
        return {draw_hint, 1, "Draw across the scene",
                editor.preferences.look.click_holds
                    ? "A click begins the stroke, another one places the model."
                    : "Keep the left button down; let go to place the model."};
    const std::string key = key_text(action(editor, "Place"));
    return {draw_hint, 1,
            (key.empty() ? "Choose Place" : "Press " + key) + ", then draw across the scene",
            "The model will lie along the stroke."};
}

// Whoever bends, parts, paints or draws things without a stroke is not told of strokes.
bool is_for_more_than_strokes(const Object& o)
{
    return kind_of(o).bends_others || kind_of(o).has_levels || o.tiles || o.splitting ||
           o.cutting || o.incising || o.line_drawing;
}

} // namespace

std::optional<HintCard> hint_card(const Editor& editor)
{
    const Session& session = editor.session;
    if (!editor.preferences.hints || session.jobs().status() || session.scene().look_only())
        return {};
    if (draws(editor)) {
        if (closed(editor, let_go_hint)) return {};
        return HintCard{let_go_hint, 2, "Keep going, then let go",
                        "The strip follows the scene. Where its points are white, it spans a gap."};
    }
    if (editor.active_tool().busy()) return {};
    const std::string tool = editor.tools[editor.tool]->name();
    if (tool != "Select" && tool != "Place") return {}; // whoever uses another one knows what for
    const BackgroundEvaluator::Status work = session.evaluator().status();
    if (work.busy && work.seconds > progress_shown_s) return {}; // its bar is there
    std::size_t shapes = 0, texts = 0, placed = 0, others = 0;
    for (const auto& [id, each] : session.document().objects) {
        shapes += kind_of(*each).has_surface ? 1 : 0;
        texts += made_of<TextShape>(session.document(), id) ? 1 : 0;
        placed += each->stroke ? 1 : 0;
        others += is_for_more_than_strokes(*each) ? 1 : 0;
    }
    if (placed == 0 && others == 0 && !closed(editor, draw_hint))
        return card_before_a_stroke(editor, shapes, texts);
    const auto selected = session.document().objects.find(session.selected);
    const bool handles = selected != session.document().objects.end() && selected->second->stroke &&
                         !selected->second->stroke->round;
    if (!handles || closed(editor, widen_hint) || !closed(editor, let_go_hint)) return {};
    return HintCard{widen_hint, 3, "Drag a white point to change the width",
                    "The blue one changes the height, the amber ones bend the stroke."};
}

void close_hint(Editor& editor, const std::string& name)
{
    if (!closed(editor, name)) editor.preferences.closed_hints.push_back(name);
}

void follow_hints(Editor& editor)
{
    const History& history = editor.session.scene().history();
    auto& followed = editor.memory.of<FollowedSteps>();
    const std::size_t now = history.position();
    const bool made = followed.scene == editor.session.scenes() && now == followed.count + 1 &&
                      now == history.steps().size() && !editor.tutorial.runs(editor.session);
    followed = {editor.session.scenes(), now};
    if (!made) return;
    const Command& command = history.steps().back().command;
    if (command.is<Place>()) {
        close_hint(editor, draw_hint);
        close_hint(editor, let_go_hint);
    } else if (closed(editor, let_go_hint)) {
        close_hint(editor, widen_hint); // it was seen, and whoever goes on needs it no more
    }
}

void show_hints_again(Editor& editor)
{
    editor.preferences.hints = true;
    editor.preferences.closed_hints.clear();
    if (!hint_card(editor))
        editor.session.notices.say(ui::NoticeKind::good, "Hints are shown again",
                                   "The next hint appears with the next stroke.");
}

} // namespace trivar
