// SPDX-License-Identifier: GPL-3.0-or-later
// The settings and hints of the Place tool.
#include "editor/session/scene_facts.h"
#include "editor/tools/place/place.h"
#include "editor/tools/place/place_round.h"
#include "ui/option_bar.h"
#include "ui/widgets.h"

#include <algorithm>

namespace trivar {

namespace {

// All round a body, and how the way lies about it.
void options_of_round(Session& session, const ui::Theme& theme, std::vector<ui::Option>& options,
                      Id model)
{
    const std::vector<Id> bodies = bodies_to_go_round(session, model);
    if (model == 0 || bodies.empty()) return;
    std::vector<std::string> round{"Lay it round..."};
    for (const Id id : bodies) round.push_back(name_of(session.document(), id));
    const std::optional<RoundWish> now = round_now(session.document(), model);
    const auto at = now ? std::ranges::find(bodies, now->around) : bodies.end();
    const int present = at == bodies.end() ? 0 : static_cast<int>(at - bodies.begin()) + 1;
    options.push_back(
        {"Round", 136,
         [&session, &theme, round, bodies, model, present](float field) {
             int body = present;
             if (ui::choice(theme, "round", body, round, field) == ui::Edit::changed && body > 0 &&
                 !session.committing())
                 lay_round(session, {model, bodies[static_cast<std::size_t>(body) - 1]});
         },
         "Lays the model all the way round an object; no stroke is needed."});
    if (!now || present == 0) return;
    options.push_back(
        {"About", 88,
         [&session, &theme, now](float field) {
             int axis = static_cast<int>(now->axis);
             if (ui::segments(theme, "about", axis, {"X", "Y", "Z"}, field) == ui::Edit::changed &&
                 !session.committing())
                 lay_round(session, {now->model, now->around, static_cast<RoundAxis>(axis)});
         },
         "The axis of the object that the model goes round."});
}

} // namespace

void PlaceTool::options_of_model(Session& session, const ui::Theme& theme,
                                 std::vector<ui::Option>& options)
{
    std::vector<std::string> names{"Automatic"};
    std::vector<Id> ids{0};
    for (const auto& [id, each] : session.document().objects)
        if (can_be_placed(session.document(), id)) {
            names.push_back(each->name);
            ids.push_back(id);
        }
    const Id model = model_to_place(session, chosen_);
    if (chosen_ == 0 && model != 0) names[0] = "Automatic: " + name_of(session.document(), model);
    auto at = std::find(ids.begin(), ids.end(), chosen_);
    const int chosen = at == ids.end() ? 0 : static_cast<int>(at - ids.begin());
    options.push_back({"Model", 208,
                       [this, &theme, names, ids, index = chosen](float field) mutable {
                           if (ui::choice(theme, "model", index, names, field) == ui::Edit::changed)
                               chosen_ = ids[static_cast<std::size_t>(index)];
                       },
                       "The model that a stroke lays."});
    options_of_round(session, theme, options, model);
    if (model == 0 || !object(session.document(), model).stroke) return;
    options.push_back(ui::enum_option(
        ui::segments, theme, "New stroke", 152, "new stroke", new_stroke_,
        {"Moves it", "Lays a copy"},
        "What a stroke does with a placed model. Hold Alt while you draw for the other choice."));
}

void PlaceTool::options(Session& session, const ui::Theme& theme, float width)
{
    const ui::NumberStyle size{.lo = 0, .hi = 1e6, .unit = "m", .zero = "auto"};
    std::vector<ui::Option> options;
    options_of_model(session, theme, options);
    options.push_back(
        {"Width", 88,
         [&](float field) { ui::number_field(theme, "width", parameters_.width, size, field); },
         "Size across the stroke. Auto: in proportion to the model."});
    options.push_back(
        {"Height", 88,
         [&](float field) { ui::number_field(theme, "height", parameters_.height, size, field); },
         "Size away from the surface. Auto: in proportion to the model."});
    options.push_back(ui::enum_option(
        ui::segments, theme, "Brush", 192, "brush", brush_, {"Even", "Speed", "Wheel"},
        "What makes the stroke wider and narrower: nothing, the hand's speed, or "
        "the wheel."));
    options.push_back({"Gaps", 144,
                       [&](float field) {
                           int gaps = parameters_.springs ? 0 : 1;
                           ui::segments(theme, "gaps", gaps, {"Bridge", "Follow"}, field);
                           parameters_.springs = gaps == 0;
                       },
                       "Bridge: springs hold the model over gaps. Follow: it drops into them."});
    if (const auto handles = handles_option(session, theme, *choice_)) options.push_back(*handles);
    ui::option_bar(theme, options, width);
}

std::vector<Hint> PlaceTool::hints(const Session& session) const
{
    if (handles_.busy() || handles_.hovers()) return handles_.hints();
    if (drawing_) {
        std::vector<Hint> hints;
        if (typed_.open())
            hints.push_back(
                {{}, "Width " + typed_.words(0, " m", ui::short_number(width_) + " m")});
        const bool copy = copies(session);
        const std::vector<Hint> usual{{{"left"},
                                       redrawing_ ? "Let go to redraw"
                                       : copy     ? "Let go to lay a copy"
                                                  : "Let go to place"},
                                      {{"wheel"}, "Width"},
                                      {{"Shift"}, "Straight"}};
        hints.insert(hints.end(), usual.begin(), usual.end());
        if (!typed_.open()) hints.push_back({{"0", "-", "9"}, "Type the width"});
        if (!redrawing_) hints.push_back({{"Ctrl"}, "Close the ring"});
        if (!redrawing_ && object(session.committed(), model_).stroke)
            hints.push_back({{"Alt"}, copy ? "Move it instead" : "Lay a copy instead"});
        hints.push_back({{"Esc", "/", "right"}, "Cancel"});
        return hints;
    }
    const std::string name = name_of(session.document(), model_to_place(session, chosen_));
    const Hint draw{{"left"},
                    on_line_          ? "Drag to redraw from here"
                    : name.empty()    ? "Drag to draw"
                    : copies(session) ? "Drag to lay a copy of " + name
                                      : "Drag to lay " + name};
    return {why_not_.empty() ? draw : Hint{{}, why_not_},
            {{"middle"}, "Orbit"},
            {{"Shift", "middle"}, "Pan"},
            {{"wheel"}, "Zoom"},
            {{"Esc"}, "Select"}};
}

} // namespace trivar
