// SPDX-License-Identifier: GPL-3.0-or-later
// What the tool of incisions shows: lines, handles, numbers at the mouse, its settings and hints.
#include "core/base/rounded.h"
#include "editor/tools/arrow_head.h"
#include "editor/tools/handle_drag.h"
#include "editor/tools/incise.h"
#include "editor/tools/incision_picture.h"
#include "ui/icons.h"
#include "ui/option_bar.h"
#include "ui/widgets.h"

#include <algorithm>
#include <imgui.h>

namespace trivar {
namespace {

std::vector<glm::vec2> seen_path(const std::vector<glm::dvec3>& points, const Camera& camera,
                                 const ViewportInput& input)
{
    std::vector<glm::vec2> out;
    for (const glm::dvec3& p : points)
        if (const PicturePoint at = project(camera, p); at.depth_world > 0)
            out.push_back(input.rect.lo + glm::vec2(at.p_px));
    return out;
}

void paint_haloed(const ui::Theme& theme, const std::vector<glm::vec2>& path, ui::Color color,
                  float width)
{
    if (path.size() < 2) return;
    ui::paint_path(path, theme.color.halo, theme.line(width + 2));
    ui::paint_path(path, color, theme.line(width));
}

const char* drag_words(IncisionHold hold)
{
    switch (hold) {
    case IncisionHold::none: return "";
    case IncisionHold::start:
    case IncisionHold::end: return "Drag to move this end";
    case IncisionHold::open_left:
    case IncisionHold::open_right: return "Drag to open or close it";
    case IncisionHold::depth: return "Drag to cut deeper";
    case IncisionHold::zip: return "Drag along the cut to zip it";
    case IncisionHold::place: return "Drag to move it over the skin";
    }
    return "";
}

} // namespace

std::vector<gpu::Line> InciseTool::lines(const Session& session, const ui::Theme& theme) const
{
    std::vector<gpu::Line> out;
    const auto add = [&](std::vector<gpu::Line> lines) {
        std::ranges::move(lines, std::back_inserter(out));
    };
    const SeenCut* one = gesture_ ? nullptr : seen_chosen(session);
    if (one) add(cage_of(*one, theme));
    for (const SeenCut& each : cuts_)
        add(dashes_of(each, session.view.camera, theme, &each == one));
    return out;
}

void InciseTool::paint_stroke(const Session& session, const ui::Theme& theme,
                              const ViewportInput& input) const
{
    const CutStroke& stroke = gesture_->stroke;
    if (stroke.is_click()) return;
    paint_haloed(theme, seen_path(stroke.way_world(), session.view.camera, input),
                 theme.color.incision, 2);
    if (stroke.end())
        for (const glm::vec2& p : seen_path({stroke.end()->p_world}, session.view.camera, input))
            ui::paint_dot(p, theme.px(6), theme.color.selected, theme.color.halo, theme.px(1.5f));
    const glm::vec2 mouse = input.rect.lo + glm::vec2(input.mouse);
    ui::paint_chip(theme, mouse + glm::vec2(theme.px(18), -theme.px(30)),
                   {ui::short_number(rounded(stroke.length_world(), 3)) + " m" +
                    (stroke.end() ? ", joined" : "")});
}

void InciseTool::overlay(const Session& session, const ui::Theme& theme,
                         const ViewportInput& input) const
{
    if (gesture_) return paint_stroke(session, theme, input);
    const Camera& camera = session.view.camera;
    const NamedIncision* one = chosen(session);
    const SeenCut* seen = seen_chosen(session);
    if (hovered_cut_ != 0 && !hovers() && !drag_ && hovered_cut_ != session.incision.number &&
        static_cast<std::size_t>(hovered_cut_) <= cuts_.size()) {
        std::vector<glm::dvec3> line;
        for (const SurfaceHit& each : cuts_[static_cast<std::size_t>(hovered_cut_) - 1].line)
            line.push_back(each.p_world);
        paint_haloed(theme, seen_path(line, camera, input), theme.color.hovered, 2);
    }
    if (!one || !seen) return;
    const IncisionHold lit = drag_ ? drag_->held.hold : hovered_;
    std::vector<IncisionHoldPoint> points = holds(session, input.scale);
    // The one in the hand above the others
    std::ranges::stable_partition(points, [&](const auto& p) { return p.hold != lit; });
    const auto in_window = [&](const glm::dvec2& p_px) { return input.rect.lo + glm::vec2(p_px); };
    for (const IncisionHoldPoint& point : points)
        if (point.hold == IncisionHold::depth || point.hold == IncisionHold::zip)
            paint_haloed(theme, {in_window(point.base_px), in_window(point.p_px)},
                         point.hold == IncisionHold::depth ? theme.color.lattice : theme.color.path,
                         1.4f);
    for (const IncisionHoldPoint& point : points) {
        const bool on = point.hold == lit;
        const glm::vec2 p = in_window(point.p_px);
        const float radius = theme.scale * (on ? 7.0f : 5.5f), rim = theme.px(1.5f);
        const ui::Palette& c = theme.color;
        switch (point.hold) {
        case IncisionHold::none: break;
        case IncisionHold::start:
        case IncisionHold::end:
            ui::paint_dot(p, radius, on ? c.selected : c.incision, c.halo, rim);
            break;
        case IncisionHold::open_left:
        case IncisionHold::open_right:
            ui::paint_dot(p, radius, on ? c.incision : c.free_node, c.halo, rim);
            break;
        case IncisionHold::place: // hollow: it changes no number
            ui::paint_dot(p, radius + rim, 0, c.halo, rim + theme.px(1));
            ui::paint_dot(p, radius - theme.px(0.5f), 0, on ? c.selected : c.incision, theme.px(2));
            break;
        case IncisionHold::depth:
            paint_arrow_head(theme, p, glm::vec2(point.way_px), radius,
                             on ? c.selected : c.lattice);
            break;
        case IncisionHold::zip:
            ui::paint_diamond(p, radius + theme.px(1.5f), on ? c.selected : c.path, c.halo, rim);
            break;
        }
    }
    if (points.empty() || lit == IncisionHold::none || points.back().hold != lit) return;
    const glm::vec2 mouse = input.rect.lo + glm::vec2(input.mouse);
    ui::paint_chip(theme, mouse + glm::vec2(theme.px(18), -theme.px(30)),
                   {words_of(lit, *one, *seen)});
}

void InciseTool::options(Session&, const ui::Theme& theme, float width)
{
    std::vector<ui::Option> options;
    const auto length = [&](const char* words, double& value, const char* help) {
        options.push_back({words, 84,
                           [&theme, words, &value](float field) {
                               ui::number_field(theme, words, value,
                                                {.lo = 0, .hi = 1000, .unit = "m", .zero = "auto"},
                                                field);
                           },
                           help});
    };
    length("Width", width_world_, "How wide the next incision gapes when it is quite open.");
    length("Depth", depth_world_, "How deep the next incision goes, as far as there is body.");
    options.push_back({"Floor", 148,
                       [&](float field) {
                           int floor = static_cast<int>(settings_.cut.floor);
                           ui::segments(theme, "floor", floor, {"Sharp", "Flat", "Through"}, field);
                           settings_.cut.floor = static_cast<Incision::Floor>(floor);
                       },
                       "Its walls meet below, a floor joins them, or it goes through the body."});
    options.push_back({"Open", 112,
                       [&](float) { ui::check_box(theme, "open", opens_, "as it cuts"); },
                       "It opens while it is drawn; else it is shut, to be opened later."});
    options.push_back({"Snap", 70, [&](float) { ui::check_box(theme, "snap", snaps_, "ends"); },
                       "Strokes begin and end at the ends of other incisions that are near."});
    ui::option_bar(theme, options, width);
}

std::vector<Hint> InciseTool::hints(const Session& session) const
{
    if (gesture_)
        return {{{"left"}, "Let go to cut"},
                {{"Shift"}, "Straight"},
                {{"wheel"}, "Width"},
                {{"Esc", "/", "right"}, "Cancel"}};
    if (drag_ || hovers()) return handle_hints(drag_.has_value(), drag_words(hovered_));
    std::vector<Hint> out;
    if (hovered_cut_ != 0 && hovered_cut_ == session.incision.number)
        out.push_back({{"Ctrl", "left"}, "Drag to redraw from here"});
    else if (hovered_cut_ != 0)
        out.push_back({{"left"}, "Click to select this incision"});
    if (over_ != 0)
        out.push_back({{"left"}, "Drag to cut"});
    else
        out.push_back({{}, "Draw on a surface"});
    out.push_back({{"Shift"}, "Straight"});
    if (chosen(session)) out.push_back({{"Del"}, "Heal"});
    out.push_back({{"middle"}, "Orbit"});
    out.push_back({{"Esc"}, "Select"});
    return out;
}

} // namespace trivar
