// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/place.h"

#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace trivar {
namespace {

bool can_be_placed(const Document& document, Id id)
{
    const auto found = document.objects.find(id);
    return found != document.objects.end() &&
           !std::holds_alternative<GroupShape>(found->second->source);
}

const Placement* placement_of(const Session& session, Id id)
{
    const auto found = session.evaluated().objects.find(id);
    return found == session.evaluated().objects.end() ? nullptr : found->second->placement.get();
}

// Nobody means a stroke that never left the place where it began.
bool is_click(const Sketch& sketch)
{
    return std::all_of(sketch.samples.begin(), sketch.samples.end(), [&](const StrokeSample& s) {
        return glm::distance(s.p_px, sketch.samples.front().p_px) <= click_slip_px;
    });
}

// The corner nearest to the mouse would be covered by the hand; the chips stand to its right.
void measure_chips(const ui::Theme& theme, glm::vec2 at, const Placement* placement)
{
    if (!placement) return;
    const PlacementReport& report = placement->report;
    ui::paint_chip(theme, at + glm::vec2(theme.px(28), -theme.px(28)),
                   {fmt::format("{} m", ui::short_number(report.length_world))});
    ui::paint_chip(theme, at + glm::vec2(theme.px(28), theme.px(2)),
                   {fmt::format("width {} m", ui::short_number(report.width_world))});
}

} // namespace

Id model_to_place(const Session& session, Id chosen)
{
    const Document& document = session.document();
    if (can_be_placed(document, chosen)) return chosen;
    // The oldest is what the others are laid on: only what came later is meant, even where a click
    // selected the oldest.
    Id oldest = 0, newest = 0, newest_loose = 0;
    for (const auto& [id, each] : document.objects) {
        if (!can_be_placed(document, id) || each->hidden || locked(document, id)) continue;
        if (oldest == 0) oldest = id;
        newest = id;
        if (id != oldest && !each->placement) newest_loose = id;
    }
    if (session.selected != oldest && can_be_placed(document, session.selected) &&
        !locked(document, session.selected))
        return session.selected;
    return newest_loose != 0 ? newest_loose : newest;
}

const char* PlaceTool::icon() const
{
    return ui::icon::place;
}

Command PlaceTool::command(const Session& session) const
{
    const Object& model = object(session.committed(), model_);
    if (model.placement) // a new stroke for what was placed before keeps how it lies
        return EditPlacement{model_, model.placement->parameters, sketch_, std::vector<Id>{}};
    return Place{model_, sketch_, parameters_, {}};
}

void PlaceTool::use(Session& session, const ViewportInput& input)
{
    if (input.pressed && !session.committing()) {
        model_ = model_to_place(session, chosen_);
        if (model_ == 0) {
            session.notices.say(ui::NoticeKind::warning, "There is no model to place",
                                "Drop a model into the window, then draw the stroke again.");
            return;
        }
        if (session.document().objects.size() < 2) {
            session.notices.say(
                ui::NoticeKind::warning, "There is nothing to place it on",
                "Drop a scene into the window, or add a primitive, then draw on it.");
            return;
        }
        drawing_ = true;
        sketch_ = {session.camera, {}};
        began_s_ = input.moves.empty() ? 0 : input.moves.front().time_s;
    }
    if (!drawing_) return;
    const std::size_t before = sketch_.samples.size();
    for (StrokeSample sample : input.moves) {
        sample.time_s -= began_s_;
        // A mouse that rests repeats itself.
        if (sketch_.samples.empty() || sketch_.samples.back().p_px != sample.p_px)
            sketch_.samples.push_back(sample);
    }
    constexpr std::size_t enough_to_show = 3;
    const bool grown = sketch_.samples.size() > before;
    if (input.released) {
        drawing_ = false;
        if (is_click(sketch_)) {
            session.cancel();
            session.notices.say(ui::NoticeKind::warning, "Nothing was placed",
                                "Keep the left button down and draw a line across the scene.");
            return;
        }
        if (session.propose(command(session)))
            session.commit_if_placed(model_);
        else
            session.cancel();
        session.selected = model_;
    } else if (grown && sketch_.samples.size() >= enough_to_show && session.up_to_date()) {
        // One proposal at a time: the next piece waits until the last one can be seen.
        session.propose_quietly(command(session));
    }
}

void PlaceTool::cancel(Session& session)
{
    if (!drawing_) return;
    drawing_ = false;
    session.cancel();
}

std::vector<gpu::Line> PlaceTool::lines(const Session& session, const ui::Theme& theme) const
{
    const Placement* placement = drawing_ ? placement_of(session, model_) : nullptr;
    if (!placement) return {};
    std::vector<gpu::Line> lines;
    for (const std::vector<glm::dvec3>& curve : placement->strip) {
        gpu::Line line;
        line.points.assign(curve.begin(), curve.end());
        line.color = ui::linear_light(theme.color.stroke);
        line.width_px = theme.scale * (lines.empty() ? 3.0f : 1.4f);
        lines.push_back(std::move(line));
    }
    return lines;
}

void PlaceTool::overlay(const Session& session, const ui::Theme& theme,
                        const ViewportInput& input) const
{
    const glm::vec2 mouse = input.rect.lo + glm::vec2(input.mouse);
    if (!drawing_) {
        if (!input.hovered) return;
        ui::paint_dot(mouse, theme.px(5), ui::faded(theme.color.stroke, 0.35f), theme.color.stroke,
                      1.4f * theme.scale);
        return;
    }
    std::vector<glm::vec2> path;
    for (const StrokeSample& sample : sketch_.samples)
        path.push_back(input.rect.lo + glm::vec2(sample.p_px));
    // A band of the strip's width shows at once where the model will lie.
    if (const Placement* placement = placement_of(session, model_); placement && path.size() > 1) {
        const glm::dvec3 end = placement->strip.front().empty() ? session.camera.target
                                                                : placement->strip.front().back();
        const double depth = std::max(1e-6, project(session.camera, end).depth_world);
        const double width_px =
            placement->report.width_world / pixel_size_world(session.camera, depth);
        ui::paint_path(path, ui::faded(theme.color.stroke, 0.16f),
                       static_cast<float>(std::clamp(width_px, 2.0, 400.0)));
    }
    ui::paint_path(path, theme.color.halo, 5 * theme.scale);
    ui::paint_path(path, theme.color.stroke, 3 * theme.scale);
    ui::paint_dot(mouse, theme.px(6), theme.color.stroke, theme.color.halo, 1.5f * theme.scale);
    measure_chips(theme, mouse, placement_of(session, model_));
}

void PlaceTool::options(Session& session, const ui::Theme& theme, float width)
{
    const float x0 = ImGui::GetCursorScreenPos().x;
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
    int index = at == ids.end() ? 0 : static_cast<int>(at - ids.begin());
    const auto label = [&](const char* words) {
        const ImVec2 p = ImGui::GetCursorScreenPos();
        const float w = ui::text_width(theme.font.body, words);
        ui::paint_text(theme.font.body, ui::rect_at({p.x, p.y}, {w, theme.size.row}),
                       theme.color.text_2, words);
        ImGui::SetCursorScreenPos({p.x + w + theme.px(8), p.y});
    };
    const auto fits = [&](float more) {
        return ImGui::GetCursorScreenPos().x - x0 + theme.px(more) <= width;
    };
    const auto advance = [&](ImVec2 from, float by) {
        ImGui::SetCursorScreenPos({from.x + theme.px(by), from.y});
    };
    label("Model");
    ImVec2 p = ImGui::GetCursorScreenPos();
    if (ui::choice(theme, "model", index, names, theme.px(208)) == ui::Edit::changed)
        chosen_ = ids[static_cast<std::size_t>(index)];
    advance(p, 208 + 16);
    const ui::NumberStyle size{.lo = 0, .hi = 1e6, .unit = "m", .zero = "auto"};
    if (fits(160)) {
        label("Width");
        p = ImGui::GetCursorScreenPos();
        ui::number_field(theme, "width", parameters_.width, size, theme.px(88));
        advance(p, 88 + 16);
    }
    if (fits(160)) {
        label("Height");
        p = ImGui::GetCursorScreenPos();
        ui::number_field(theme, "height", parameters_.height, size, theme.px(88));
        advance(p, 88 + 16);
    }
    if (fits(220)) {
        label("Gaps");
        int gaps = parameters_.springs ? 0 : 1;
        ui::segments(theme, "gaps", gaps, {"Bridge", "Follow"}, theme.px(144));
        parameters_.springs = gaps == 0;
    }
}

std::vector<Hint> PlaceTool::hints(const Session& session) const
{
    if (drawing_) return {{{"left"}, "Let go to place"}, {{"Esc", "/", "right"}, "Cancel"}};
    const Id model = model_to_place(session, chosen_);
    const std::string name = name_of(session.document(), model);
    return {{{"left"}, name.empty() ? "Drag to draw" : "Drag to lay " + name},
            {{"middle"}, "Orbit"},
            {{"Shift", "middle"}, "Pan"},
            {{"wheel"}, "Zoom"},
            {{"Esc"}, "Select"}};
}

} // namespace trivar
