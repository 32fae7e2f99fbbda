// SPDX-License-Identifier: GPL-3.0-or-later
// What the tool of incisions shows: lines, handles, numbers at the mouse, its settings and hints.
#include "core/base/rounded.h"
#include "editor/hands/arrow_head.h"
#include "editor/hands/handle_drag.h"
#include "editor/tools/incise/incise.h"
#include "editor/tools/incise/incision_picture.h"
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

// Of the handles that are there, the one that was held before something changed.
const CrossingHold& shown_crossing(const CrossingHold& held, const std::vector<CrossingHold>& now)
{
    const CrossingHold* out = &held;
    double nearest = 1e300;
    for (const CrossingHold& each : now) {
        const bool same = each.crossing.first == held.crossing.first &&
                          each.crossing.second == held.crossing.second &&
                          each.flap.has_value() == held.flap.has_value() &&
                          (!each.flap || each.flap->same_place(*held.flap));
        const double away = glm::distance(each.base_px, held.base_px);
        if (same && away < nearest) {
            nearest = away;
            out = &each;
        }
    }
    return *out;
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
    for (const auto& each : cuts_)
        if (each) add(dashes_of(*each, session.view.camera, theme, &*each == one));
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
                   {typed_words(ui::short_number(rounded(stroke.length(), 3)) + " m" +
                                (stroke.end()        ? ", joined"
                                 : stroke.lacks_uv() ? ", drawn freely: no UVs here"
                                                     : ""))});
}

void InciseTool::overlay(const Session& session, const ui::Theme& theme,
                         const ViewportInput& input) const
{
    if (gesture_) return paint_stroke(session, theme, input);
    const Camera& camera = session.view.camera;
    const NamedIncision* one = chosen(session);
    const SeenCut* seen = seen_chosen(session);
    if (hovered_cut_ != 0 && !hovers() && !dragging() && hovered_cut_ != session.incision.number &&
        static_cast<std::size_t>(hovered_cut_) <= cuts_.size() &&
        cuts_[static_cast<std::size_t>(hovered_cut_) - 1]) {
        std::vector<glm::dvec3> line;
        for (const SurfaceHit& each : cuts_[static_cast<std::size_t>(hovered_cut_) - 1]->line)
            line.push_back(each.p_world);
        paint_haloed(theme, seen_path(line, camera, input), theme.color.hovered, 2);
    }
    if (hovered_snap_ && !dragging())
        for (const glm::vec2& p : seen_path({hovered_snap_->p_world}, camera, input))
            ui::paint_dot(p, theme.px(hovered_snap_->along ? 4 : 7), 0, theme.color.selected,
                          theme.px(2));
    if (!one || !seen) return;
    paint_crossings(session, theme, input);
    const IncisionHold lit = drag_ ? drag_->held.hold : hovered_;
    const std::vector<IncisionHoldPoint> points = paint_holds(session, theme, input);
    std::string words;
    if (const auto& held = crossing_drag_ ? std::optional(crossing_drag_->held) : hovered_crossing_)
        words = words_of(shown_crossing(*held, crossing_holds(session, input.scale)), *known_,
                         *seen, session.incision.number);
    else if (!points.empty() && lit != IncisionHold::none && points.back().hold == lit)
        words = words_of(lit, *one, *seen);
    if (words.empty()) return;
    const glm::vec2 mouse = input.rect.lo + glm::vec2(input.mouse);
    ui::paint_chip(theme, mouse + glm::vec2(theme.px(18), -theme.px(30)), {typed_words(words)});
}

void InciseTool::paint_crossings(const Session& session, const ui::Theme& theme,
                                 const ViewportInput& input) const
{
    const ui::Palette& c = theme.color;
    const std::vector<CrossingHold> all = crossing_holds(session, input.scale);
    const std::optional<CrossingHold> lit =
        crossing_drag_ ? std::optional(crossing_drag_->held) : hovered_crossing_;
    const CrossingHold* const on = lit ? &shown_crossing(*lit, all) : nullptr;
    for (const CrossingHold& each : all) {
        const bool is_lit = &each == on;
        const glm::vec2 p = input.rect.lo + glm::vec2(each.p_px);
        if (each.flap) {
            paint_haloed(theme, {input.rect.lo + glm::vec2(each.base_px), p}, c.free_node, 1.4f);
            paint_arrow_head(theme, p, glm::vec2(each.way_px), theme.scale * (is_lit ? 6.5f : 5),
                             is_lit ? c.incision : c.free_node);
            continue;
        }
        ui::paint_diamond(p, theme.scale * (is_lit ? 8.0f : 6.5f), is_lit ? c.selected : c.halo,
                          c.incision, theme.px(2));
        if (!is_lit) continue;
        // A bar along the one that is cut first
        const auto& first = cuts_.at(static_cast<std::size_t>(each.crossing.first) - 1);
        if (!first) continue;
        const double s = each.crossing.share_of_first;
        const Camera& camera = session.view.camera;
        const glm::vec2 way = glm::vec2(project(camera, first->at(s + 0.01)).p_px -
                                        project(camera, first->at(s - 0.01)).p_px);
        if (const float length = glm::length(way); length > 0.01f) {
            const glm::vec2 half = way / length * theme.px(15);
            paint_haloed(theme, {p - half, p + half}, c.selected, 2);
        }
    }
}

std::vector<IncisionHoldPoint> InciseTool::paint_holds(const Session& session,
                                                       const ui::Theme& theme,
                                                       const ViewportInput& input) const
{
    const IncisionHold lit = drag_ ? drag_->held.hold : hovered_;
    std::vector<IncisionHoldPoint> points = holds(session, input.scale);
    // The one in the hand above the others
    std::stable_partition(points.begin(), points.end(),
                          [&](const auto& p) { return p.hold != lit; });
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
            ui::paint_dot(p, radius, c.halo, c.halo, rim + theme.px(1));
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
    return points;
}

void InciseTool::options(Session&, const ui::Theme& theme, float width)
{
    std::vector<ui::Option> options;
    const auto length = [&](const char* words, double& value, const char* help) {
        options.push_back({words, 76,
                           [&theme, words, &value](float field) {
                               ui::number_field(theme, words, value,
                                                {.lo = 0, .hi = 1000, .unit = "m", .zero = "auto"},
                                                field);
                           },
                           help});
    };
    length("Width", width_world_, "How wide the next incision gapes when it is quite open.");
    length("Depth", depth_world_, "How deep the next incision goes, as far as there is body.");
    options.push_back({"Floor", 160,
                       [&](float field) {
                           int floor = static_cast<int>(settings_.cut.floor);
                           ui::segments(theme, "floor", floor, {"Sharp", "Flat", "Through"}, field);
                           settings_.cut.floor = static_cast<Incision::Floor>(floor);
                       },
                       "Sharp: its walls meet at the bottom. Flat: a floor joins them. Through: it "
                       "goes through the body."});
    options.push_back({"Stroke", 120,
                       [&](float field) {
                           int way = static_cast<int>(way_);
                           ui::segments(theme, "stroke", way, {"Free", "Line", "UV"}, field);
                           way_ = static_cast<Way>(way);
                       },
                       "As the hand goes, straight as it is seen, or along a line of the model's "
                       "texture coordinates."});
    options.push_back({"Open", 100,
                       [&](float) { ui::check_box(theme, "open", opens_, "as it cuts"); },
                       "It opens while it is drawn; else it is shut, to be opened later."});
    options.push_back({"Snap", 62, [&](float) { ui::check_box(theme, "snap", snaps_, "joins"); },
                       "Strokes begin and end at other incisions that are near, and go through "
                       "their crossings."});
    ui::option_bar(theme, options, width);
}

std::vector<Hint> InciseTool::hints(const Session& session) const
{
    if (gesture_)
        return {{{"left"}, "Let go to cut"},
                {{"Shift"}, "Straight"},
                {{"wheel"}, "Width"},
                {{"0", "...", "9"}, "Type the width"},
                {{"Esc", "/", "right"}, "Cancel"}};
    if (dragging()) {
        const bool typed = crossing_drag_ || (drag_->held.hold != IncisionHold::start &&
                                              drag_->held.hold != IncisionHold::end &&
                                              drag_->held.hold != IncisionHold::place);
        std::vector<Hint> out{{{"left"}, by_key_ ? "Click when done" : "Let go when done"},
                              {{"Ctrl"}, "Round steps"}};
        if (typed) out.push_back({{"0", "...", "9"}, "Type a number"});
        out.push_back({{"Esc", "/", "right"}, "Cancel"});
        return out;
    }
    if (hovered_crossing_ && hovered_crossing_->flap)
        return handle_hints(false, "Drag to peel this flap");
    if (hovered_crossing_)
        return {{{"left"}, "Drag to slide the crossing"},
                {{"left"}, "Click to swap which is cut first"},
                {{"Ctrl"}, "Round steps"}};
    if (hovers()) return handle_hints(false, drag_words(hovered_));
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
    if (chosen(session)) {
        out.push_back({{"F"}, "Opening"});
        out.push_back({{"Shift", "F"}, "Depth"});
        out.push_back({{"Del"}, "Heal"});
    } else {
        out.push_back({{"middle"}, "Orbit"});
    }
    out.push_back({{"Esc"}, "Select"});
    return out;
}

} // namespace trivar
