// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/lattice/press.h"

#include "core/base/rounded.h"
#include "core/ffd/resolution.h"
#include "core/steps/laying/attaching.h"
#include "editor/hands/falloff_option.h"
#include "editor/hands/helpers.h"
#include "editor/hands/last_shaping.h"
#include "editor/hands/select.h"
#include "editor/hands/selected_placement.h"
#include "editor/hands/viewport_input.h"
#include "editor/picture/volume_picture.h"
#include "editor/session/topics.h"
#include "ui/option_bar.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>
#include <utility>

namespace trivar {
namespace {

constexpr double brush_step = 0.2; // of the radius, between samples; of the strength, each presses

// Returns the press of one pixel of the mouse, as a vector: along the picture of the way into the
// volume, or, where that is hardly seen, downwards.
glm::dvec2 metres_by_pixel(const Camera& camera, const glm::dvec3& center, const glm::dvec3& into)
{
    const PicturePoint at = project(camera, center);
    const double pixel = pixel_size_world(camera, std::max(1e-9, at.depth_world));
    const double step = 20 * pixel;
    const glm::dvec2 way = (project(camera, center + step * into).p_px - at.p_px) / step;
    constexpr double hardly_seen = 0.35;
    const double length = glm::length(way); // pixels a metre
    if (length * pixel < hardly_seen) return {0, pixel};
    return way / (length * length);
}

// Where the ball is, and where it is mirrored.
std::vector<glm::dvec3> places(const Press& press, const glm::dvec3& uvw)
{
    if (!press.mirror) return {uvw};
    return {uvw, {uvw.x, 1 - uvw.y, uvw.z}};
}

// Calls visit(index, weight) for each control point that balls of the press round those centres
// hold; how many there are.
int held_by(const Press& press, const Lattice& volume, const std::vector<glm::dvec3>& centers,
            auto&& visit)
{
    int held = 0;
    const std::array<Knots, 3>& axes = volume.displacement.axes;
    for (int i = 0; i < axes[0].count(); ++i)
        for (int j = 0; j < axes[1].count(); ++j)
            for (int k = 0; k < axes[2].count(); ++k) {
                const glm::dvec3 p = control_point(volume, i, j, k);
                double weight = 0;
                for (const glm::dvec3& center : centers)
                    weight = std::max(weight,
                                      decay(press.decay, glm::distance(p, center) / press.radius));
                if (!(weight > 0)) continue;
                ++held;
                visit(glm::ivec3(i, j, k), weight);
            }
    return held;
}

// All that bends with the control points that a press holds; of a long stroke at some places of it.
std::vector<VolumePart> parts_of(const Press& press, const Lattice& volume)
{
    std::vector<glm::ivec3> held;
    constexpr std::size_t places = 16;
    const std::size_t count = press.samples.size(), step = (count + places - 1) / places;
    for (std::size_t i = 0; i < count; i += step)
        held_by(press, volume, {evaluate(volume, glm::dvec3(press.samples[count - 1 - i])).value},
                [&](const glm::ivec3& point, double) { held.push_back(point); });
    if (held.empty()) return {};
    return with_mirrored(bent_by(volume, held), press.mirror);
}

// The lattice that something without a volume of its own stands in, if that is not selected; 0:
// none that can be pressed.
Id lattice_of_member(const Session& session, Id member)
{
    const Document& document = session.document();
    if (member == 0 || object(document, member).stroke) return 0;
    const std::vector<Id> all = lattices_round(document, member);
    if (all.empty() || locked(document, all.front()) || session.selected == all.front()) return 0;
    return session.evaluated().objects.contains(all.front()) ? all.front() : 0;
}

// While it is only held over the volume: the picture is not drawn anew for it.
void paint_held_ball(const ui::Theme& theme, const ViewportInput& input, const Camera& camera,
                     const glm::dvec3& center, double radius)
{
    const PicturePoint at = project(camera, center);
    if (at.depth_world <= 0) return;
    const auto radius_px = static_cast<float>(radius / pixel_size_world(camera, at.depth_world));
    ui::paint_ball(input.rect.lo + glm::vec2(at.p_px), radius_px, theme.color.sphere,
                   theme.line(1.6f));
}

} // namespace

ToolState PressTool::state() const
{
    const bool busy = gesture_.going();
    return {
        .busy = busy, .crosshair = at_ || busy, .takes_wheel = busy, .shows_volume_at_work = true};
}

double PressTool::radius(const Placement& placement) const
{
    constexpr double share = 0.55; // of the width
    return radius_ > 0 ? radius_ : rounded(share * placement.report.width_world, 2);
}

double PressTool::strength(const Placement& placement) const
{
    constexpr double share = 0.3; // of the height
    return strength_ > 0 ? strength_ : rounded(share * placement.report.height_world, 2);
}

Command PressTool::command() const
{
    // Its lengths are those of the space of the stroke.
    Press press = gesture_->press;
    if (gesture_->scale != 1) {
        press.radius /= gesture_->scale;
        for (glm::dvec4& sample : press.samples) sample.w /= gesture_->scale;
    }
    return PressVolume{gesture_->object, std::move(press)};
}

void PressTool::begin(Session& session, const ViewportInput& input)
{
    const Placement& laid = *placement_;
    Pressing g{session.selected, by_, {}, laid.volume};
    g.press = {.decay = decay_,
               .radius = radius(laid),
               .samples = {glm::dvec4(at_->uvw, 0)},
               .mirror = mirror_,
               .guard = guard_,
               .into_scene = into_scene_};
    if (const EvaluatedObject* shown = selected_volume(session))
        g.scale = glm::length(glm::dvec3(stroke_to_world(*shown)[0]));
    const glm::dvec3 up = volume_directions(laid.volume, at_->uvw).up;
    const bool lifts = at_scene(laid.volume, laid.ground, at_->uvw);
    g.into_px = metres_by_pixel(session.view.camera, at_->p_world, lifts ? up : -up);
    const bool pulls = ImGui::GetIO().KeyCtrl;
    if (g.by == By::brush)
        g.press.samples.back().w = (pulls ? -1 : 1) * brush_step * strength(laid);
    gesture_.begin(std::move(g), input);
    typed_ = {};
    session.notices.forget(of_a_step);
}

void PressTool::find_place(const Session& session, const ViewportInput& input)
{
    const EvaluatedObject* laid = selected_volume(session);
    at_.reset();
    if (laid && laid->placement != placement_) {
        placement_ = laid->placement;
        surface_ = volume_surface(placement_->volume);
    }
    if (!laid) placement_ = nullptr;
    if (placement_ && (input.hovered || input.pressed))
        at_ = on_volume(surface_, ray_through(session.view.camera, input.mouse));
    if (!at_) return;
    last_at_ = at_->uvw;
    last_of_ = laid->id;
}

void PressTool::use(Session& session, const ViewportInput& input)
{
    tell(session);
    if (gesture_) {
        if (!selected_volume(session)) return cancel(session);
        return go_on(session, input);
    }
    find_place(session, input);
    if (!input.pressed || session.committing()) return;
    // An object in a lattice is pressed with the lattice.
    if (const Id lattice = at_ ? 0 : lattice_of_member(session, input.under)) {
        session.selected = lattice;
        find_place(session, input);
    }
    if (at_)
        begin(session, input);
    else
        select_by_click(session, input.under);
}

void PressTool::extend(const Camera& camera, const ViewportInput& input)
{
    Press& press = gesture_->press;
    if (input.wheel != 0)
        press.radius = radius_ = rounded(press.radius * std::pow(radius_step, input.wheel), 3);
    if (gesture_->by == By::drag) {
        const glm::dvec2 drag = input.mouse - gesture_.from_px();
        if (gesture_.moved()) press.samples.back().w = glm::dot(drag, gesture_->into_px);
        if (const auto typed = typed_.value(0, Measure::length)) press.samples.back().w = *typed;
    } else if (const auto at = on_volume(surface_, ray_through(camera, input.mouse))) {
        const glm::dvec3 last = evaluate(gesture_->volume, glm::dvec3(press.samples.back())).value;
        constexpr std::size_t most_samples = 4000;
        if (glm::distance(last, at->p_world) >= brush_step * press.radius &&
            press.samples.size() < most_samples)
            press.samples.emplace_back(glm::dvec4(at->uvw, press.samples.back().w));
    }
}

bool PressTool::holds_points() const
{
    const Press& press = gesture_->press;
    const Lattice& volume = gesture_->volume;
    return std::ranges::any_of(press.samples, [&](const glm::dvec4& sample) {
        std::vector<glm::dvec3> centers = places(press, glm::dvec3(sample));
        for (glm::dvec3& center : centers) center = evaluate(volume, center).value;
        return held_by(press, volume, centers, [](const glm::ivec3&, double) {}) > 0;
    });
}

void PressTool::go_on(Session& session, const ViewportInput& input)
{
    gesture_.follow(input);
    extend(session.view.camera, input);
    const auto presses = [&] {
        return gesture_->by == By::brush || gesture_->press.samples.back().w != 0;
    };
    const auto wanted = [&]() -> std::optional<Command> {
        if (!presses() || !holds_points()) return {};
        return command();
    };
    const Gesture::State state = gesture_.go_on(session, input, wanted);
    if (state == Gesture::State::goes_on) return;
    told_ = gesture_->press;
    if (state == Gesture::State::done)
        told_of_ = gesture_->object;
    else if (presses() && !holds_points() &&
             !offer_points(session, gesture_->object, gesture_->volume))
        session.notices.say(ui::NoticeKind::warning, "Nothing was pressed",
                            "The ball holds no control point; make it larger.", of_a_step);
}

void PressTool::tell(Session& session)
{
    if (told_of_ == 0 || gesture_ || !session.up_to_date()) return;
    const Shaping* last = last_shaping(session, told_of_);
    const Id id = std::exchange(told_of_, 0);
    if (!last) return;
    if (!last->notice.empty())
        session.notices.say(ui::NoticeKind::warning, "Nothing was pressed", last->notice,
                            of_a_step);
    const EvaluatedObject* laid = selected_volume(session);
    const bool same = laid && laid->id == id;
    if (!last->notice.empty() || (same && offer_points(session, id, laid->placement->volume)))
        return;
    if (last->would_fold)
        tell_where_it_stopped(
            session, *last, last->asked > 0 ? "The press" : "The pull", "Use a larger radius", id,
            same ? parts_of(told_, laid->placement->volume) : std::vector<VolumePart>{});
}

std::vector<VolumePart> PressTool::held(const Session& session) const
{
    const EvaluatedObject* laid = selected_volume(session);
    if (!laid || laid->id != last_of_) return {};
    return parts_of({.decay = decay_,
                     .radius = radius(*laid->placement),
                     .samples = {glm::dvec4(last_at_, 0)},
                     .mirror = mirror_},
                    laid->placement->volume);
}

bool PressTool::offer_points(Session& session, Id id, const Lattice& volume) const
{
    const glm::dvec3 center = evaluate(volume, glm::dvec3(told_.samples.back())).value;
    constexpr int few = 4;
    if (held_by(told_, volume, {center}, [](const glm::ivec3&, double) {}) >= few) return false;
    const AxisKnots knots = knots_for_sphere(volume, center, told_.radius);
    if (knots[0].empty() && knots[1].empty() && knots[2].empty()) return false;
    session.notices.say(ui::NoticeKind::warning, "The ball holds few control points",
                        "The press would be coarse or have no effect. More can be added there; the "
                        "volume keeps its shape.",
                        of_a_step,
                        {{"Add control points", [&session, id, knots] {
                              session.run(InsertKnots{id, {knots[0], knots[1], knots[2]}});
                          }}});
    return true;
}

bool PressTool::resize(Session&, double factor)
{
    if (!placement_) return false;
    radius_ = rounded(radius(*placement_) * factor, 3);
    return true;
}

void PressTool::take_keys(Session&)
{
    if (gesture_ && gesture_->by == By::drag) typed_.take_letters();
}

Helpers PressTool::helpers(const Session& session, const ui::Theme& theme) const
{
    const EvaluatedObject* laid = selected_volume(session);
    if (!laid || !gesture_) return {};
    return {.veils = balls_of(gesture_->press, laid->placement->volume, theme.color)};
}

void PressTool::overlay(const Session& session, const ui::Theme& theme,
                        const ViewportInput& input) const
{
    const EvaluatedObject* laid = selected_volume(session);
    if (!laid || (!at_ && !gesture_)) return;
    const Lattice& start = gesture_ ? gesture_->volume : laid->placement->volume;
    const Lattice& shown = laid->placement->volume;
    const Lattice& now = shown.displacement.axes == start.displacement.axes ? shown : start;
    const Press press =
        gesture_ ? gesture_->press
                 : Press{.decay = decay_, .radius = radius(*laid->placement), .mirror = mirror_};
    const glm::dvec3 uvw = gesture_ ? glm::dvec3(press.samples.back()) : at_->uvw;
    std::vector<glm::dvec3> centers;
    for (const glm::dvec3& place : places(press, uvw)) {
        centers.push_back(evaluate(start, place).value);
        if (!gesture_)
            paint_held_ball(theme, input, session.view.camera, centers.back(), press.radius);
    }
    // The control points that the ball holds, as large as it moves them.
    const int inside = held_by(press, start, centers, [&](const glm::ivec3& at, double weight) {
        const PicturePoint p = project(session.view.camera, control_point(now, at.x, at.y, at.z));
        if (p.depth_world <= 0) return;
        ui::paint_dot(input.rect.lo + glm::vec2(p.p_px),
                      static_cast<float>(1.5 + 3 * weight) * theme.scale, theme.color.lattice,
                      theme.color.halo, theme.scale);
    });
    const glm::vec2 mouse = input.rect.lo + glm::vec2(input.mouse);
    const glm::vec2 at = mouse + glm::vec2(theme.px(18), -theme.px(30));
    if (!gesture_) {
        if (inside == 0) ui::paint_chip(theme, at, {"holds no control point", theme.color.warn});
        return;
    }
    const Shaping* step = session.proposing() ? last_shaping(session, gesture_->object) : nullptr;
    if (!step) return;
    const bool short_of = step->would_fold;
    ui::paint_chip(theme, at,
                   {(step->asked < 0 ? "pulled " : "pressed ") + amount_words(step->done) +
                        (short_of ? ", would fold" : ""),
                    short_of ? theme.color.bad : ui::Color{0}});
}

void PressTool::options(Session& session, const ui::Theme& theme, float width)
{
    const EvaluatedObject* laid = selected_volume(session);
    const ui::NumberStyle length{.lo = 0, .hi = 1e6, .unit = "m", .zero = "auto"};
    std::vector<ui::Option> options;
    options.push_back(falloff_option(theme, decay_,
                                     "How the press falls off from the ball's middle to its rim."));
    double shown_radius = laid ? radius(*laid->placement) : radius_;
    options.push_back({"Radius", 88,
                       [&](float field) {
                           if (ui::number_field(theme, "radius", shown_radius, length, field) !=
                               ui::Edit::none)
                               radius_ = shown_radius;
                       },
                       "Radius of the ball; 0 follows the width of the volume. The wheel changes "
                       "it while you press."});
    options.push_back(ui::enum_option(
        ui::segments, theme, "Mode", 120, "by", by_, {"Drag", "Brush"},
        "Drag: the ball presses as deep as you drag; the other way it pulls. Brush: "
        "it presses wherever you draw; with Ctrl it pulls."));
    double shown_strength = laid ? strength(*laid->placement) : strength_;
    if (by_ == By::brush)
        options.push_back({"Strength", 88,
                           [&](float field) {
                               if (ui::number_field(theme, "strength", shown_strength, length,
                                                    field) != ui::Edit::none)
                                   strength_ = shown_strength;
                           },
                           "How deep the ball presses as it is drawn over its own radius."});
    options.push_back(ui::check_option(theme, "Mirror", "mirror", mirror_,
                                       "Mirrors the press to the other side of the middle."));
    options.push_back(ui::check_option(theme, "Guard", "guard", guard_,
                                       "Stops the press before the volume would fold."));
    options.push_back(ui::check_option(theme, "Into the scene", "into scene", into_scene_,
                                       "The model may be pulled into the surface it lies on."));
    ui::option_bar(theme, options, width);
}

std::vector<Hint> PressTool::hints(const Session& session) const
{
    if (gesture_) {
        std::vector<Hint> hints;
        if (typed_.open())
            hints.push_back(
                {{},
                 "Depth " + typed_.words(0, " m", amount_words(gesture_->press.samples.back().w))});
        hints.push_back({{"left"}, "Let go when done"});
        hints.push_back({{"wheel"}, "Radius"});
        if (gesture_->by == By::drag && !typed_.open())
            hints.push_back({{"0", "-", "9"}, "Type the depth"});
        hints.push_back({{"Esc", "/", "right"}, "Cancel"});
        return hints;
    }
    const Id selected = session.selected;
    const bool member = selected != 0 && session.document().objects.contains(selected) &&
                        lattice_of_member(session, selected) != 0;
    if (!selected_volume(session) && member)
        return {{{"left"}, "Drag on it to press the lattice that it is in"}, {{"Esc"}, "Select"}};
    if (!selected_volume(session))
        return {
            {{}, "Select a placed object or a lattice"}, {{"left"}, "Select"}, {{"Esc"}, "Select"}};
    std::vector<Hint> hints;
    if (by_ == By::drag)
        hints.push_back({{"left"}, "Drag in to press, out to pull"});
    else {
        hints.push_back({{"left"}, "Drag to press"});
        hints.push_back({{"Ctrl", "left"}, "Pull"});
    }
    hints.push_back({{"@Smaller tool", "@Larger tool"}, "Radius"});
    hints.push_back({{"middle"}, "Orbit"});
    hints.push_back({{"Esc"}, "Select"});
    return hints;
}

} // namespace trivar
