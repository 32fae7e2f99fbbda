// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/tiles/mask.h"

#include "core/base/rounded.h"
#include "editor/hands/select.h"
#include "editor/hands/viewport_input.h"
#include "editor/session/scene_facts.h"
#include "editor/session/topics.h"
#include "ui/option_bar.h"
#include "ui/widgets.h"

#include <algorithm>
#include <imgui.h>

namespace trivar {
namespace {

glm::dvec3 rounded_point(const glm::dvec3& p)
{
    return {rounded(p.x, 4), rounded(p.y, 4), rounded(p.z, 4)};
}

} // namespace

double usual_reach(const Session& session, Id layer)
{
    constexpr double share = 0.25;
    const auto shown =
        session.evaluated().objects.find(object(session.document(), layer).tiles->base);
    if (shown == session.evaluated().objects.end()) return TileMask{}.stop;
    const glm::dvec3 size = shown->second->bounds->size();
    return rounded(share * std::max({size.x, size.y, size.z, 1e-6}), 2);
}

std::vector<Id> curve_objects(const Session& session)
{
    std::vector<Id> out;
    for (const auto& [id, each] : session.document().objects) {
        const auto shown = session.evaluated().objects.find(id);
        const bool lines = shown != session.evaluated().objects.end() &&
                           !shown->second->curves.empty() && !each->tiles;
        if (each->stroke || lines) out.push_back(id);
    }
    return out;
}

Id MaskTool::layer(const Session& session)
{
    const Id selected = session.selected;
    return is_tile_layer(session.document(), selected) ? selected : Id{0};
}

std::optional<SurfaceHit> MaskTool::hit(const Session& session, Id layer, const Ray& ray)
{
    if (!is_tile_layer(session.document(), layer)) return {};
    const Id base = object(session.document(), layer).tiles->base;
    if (session.evaluated().objects.contains(base)) return surface_.hit(session, base, ray);
    std::optional<SurfaceHit> on_tiles = surface_.hit(session, layer, ray);
    if (!on_tiles || !session.document().objects.contains(base)) return {};
    const glm::dmat4 to_model = glm::inverse(to_world(session.document(), base));
    on_tiles->at_rest.p = glm::dvec3(to_model * glm::dvec4(on_tiles->p_world, 1));
    return on_tiles;
}

MaskTiles MaskTool::command_for(const Session& session) const
{
    MaskTiles command{layer(session), 0, settings_};
    const std::vector<TileMask>& masks = object(session.document(), command.object).tiles->masks;
    for (std::size_t k = 0; k < masks.size(); ++k)
        if (masks[k].from != MaskFrom::image && masks[k].drives == settings_.drives)
            command.number = static_cast<int>(k) + 1;
    return command;
}

void MaskTool::lay_round_curve(Session& session, const ViewportInput& input)
{
    const Id seen = input.seen_at ? input.seen_at(input.mouse) : Id{0};
    const std::vector<Id> curves = curve_objects(session);
    if (std::ranges::find(curves, seen) == curves.end()) {
        session.notices.say(ui::NoticeKind::warning, "There is no curve here",
                            "Click an object that lies on a stroke, or a model with lines.",
                            of_a_step);
        return;
    }
    MaskTiles command = command_for(session);
    command.mask.curve = seen;
    command.mask.start = 0;
    command.mask.stop = usual_reach(session, command.object);
    const Id of = command.object;
    if (session.run(command)) session.selected = of;
}

void MaskTool::use(Session& session, const ViewportInput& input)
{
    if (gesture_) return go_on(session, input);
    hit_.reset();
    if (input.pressed && !session.committing() && layer(session) == 0)
        select_by_click(session, input.under); // a layer that is dragged over is masked at once
    const Id of = layer(session);
    const bool seen = input.hovered || input.pressed, curve = settings_.from == MaskFrom::curve;
    if (of != 0 && seen && !curve)
        hit_ = hit(session, of, // where the button went down, in a frame that took long
                   ray_through(session.view.camera, input.pressed && !input.moves.empty()
                                                        ? input.moves.front().p_px
                                                        : input.mouse));
    if (!input.pressed || session.committing() || of == 0) return;
    if (curve) return lay_round_curve(session, input);
    if (hit_)
        begin(session, input);
    else
        select_by_click(session, input.under);
}

void MaskTool::begin(Session& session, const ViewportInput& input)
{
    gesture_ = Gesture{command_for(session), *hit_, {}};
    session.notices.forget(of_a_step);
    go_on(session, input);
}

void MaskTool::go_on(Session& session, const ViewportInput& input)
{
    Gesture& g = *gesture_;
    for (const StrokeSample& move : input.moves)
        if (const auto there =
                hit(session, g.command.object, ray_through(session.view.camera, move.p_px)))
            g.to = hit_ = there;
    const bool over = input.released || !input.down;
    const double way = g.to ? glm::distance(g.to->at_rest.p, g.from.at_rest.p) : 0;
    if (way > 0) {
        TileMask& mask = g.command.mask;
        mask.begin = rounded_point(g.from.at_rest.p);
        mask.end = rounded_point(g.to->at_rest.p);
        mask.start = 0;
        mask.stop = rounded(way, 4);
    }
    if (!over) {
        if (way > 0 && session.up_to_date()) session.propose_quietly(g.command);
        return;
    }
    const MaskTiles command = g.command;
    gesture_.reset();
    if (way > 0 && session.propose(command))
        session.commit();
    else
        session.cancel();
}

void MaskTool::cancel(Session& session)
{
    if (!gesture_) return;
    gesture_.reset();
    session.cancel();
}

void MaskTool::overlay(const Session& session, const ui::Theme& theme,
                       const ViewportInput& input) const
{
    const auto on_screen = [&](const glm::dvec3& p) -> std::optional<glm::vec2> {
        const PicturePoint at = project(session.view.camera, p);
        if (at.depth_world <= 0) return {};
        return input.rect.lo + glm::vec2(at.p_px);
    };
    if (!gesture_ || !gesture_->to) return;
    const auto a = on_screen(gesture_->from.p_world), b = on_screen(gesture_->to->p_world);
    if (!a || !b) return;
    ui::paint_path({*a, *b}, theme.color.halo, theme.line(3.5f));
    ui::paint_path({*a, *b}, theme.color.stroke, theme.line(1.6f));
    const bool line = settings_.from == MaskFrom::line;
    const double low = settings_.low, high = settings_.high;
    const auto chip = [&](glm::vec2 at, double factor) {
        ui::paint_chip(theme, at + glm::vec2(theme.px(10), -theme.px(26)),
                       {ui::short_number(factor) + " x", theme.color.text});
    };
    chip(*a, line ? low : high);
    chip(*b, line ? high : low);
}

void MaskTool::options(Session&, const ui::Theme& theme, float width)
{
    std::vector<ui::Option> options;
    options.push_back(ui::enum_option(
        ui::choice, theme, "Drives", 96, "drives", settings_.drives,
        {"Density", "Scale", "Height", "Morph"},
        "What of the tiles fades. Another gradient for the same replaces the first one."));
    options.push_back(
        {"Gradient", 112,
         [&](float field) {
             int from = static_cast<int>(settings_.from) - 1; // without images
             ui::choice(theme, "gradient", from, {"Along a line", "Round a point", "Round a curve"},
                        field);
             settings_.from = static_cast<MaskFrom>(from + 1);
         },
         "Drag over the tiles along a line or away from a point, or click an object with a "
         "curve."});
    const auto factor = [&](const char* words, double& value, const char* help) {
        options.push_back({words, 72,
                           [&theme, words, &value](float field) {
                               ui::number_field(theme, words, value,
                                                {.lo = 0, .hi = 100, .unit = "x"}, field);
                           },
                           help});
    };
    const bool line = settings_.from == MaskFrom::line;
    factor(line ? "From" : "Far", settings_.low,
           line ? "The factor where the drag begins." : "The factor away from it.");
    factor(line ? "To" : "Near", settings_.high,
           line ? "The factor where the drag ends." : "The factor at it.");
    options.push_back(ui::enum_option(ui::choice, theme, "Easing", 96, "easing", settings_.easing,
                                      {"Even", "Smooth", "Slow start", "Slow end"},
                                      "How it goes from one to the other."));
    ui::option_bar(theme, options, width);
}

std::vector<Hint> MaskTool::hints(const Session& session) const
{
    if (gesture_) return {{{"left"}, "Let go when done"}, {{"Esc", "/", "right"}, "Cancel"}};
    if (layer(session) == 0)
        return {{{}, "Select a layer of tiles first"}, {{"left"}, "Select"}, {{"Esc"}, "Select"}};
    if (settings_.from == MaskFrom::curve)
        return {{{"left"}, "Click an object with a curve"}, {{"Esc"}, "Select"}};
    return {{{"left"},
             settings_.from == MaskFrom::line ? "Drag from few tiles to many"
                                              : "Drag from the middle to the rim"},
            {{"middle"}, "Orbit"},
            {{"Esc"}, "Select"}};
}

} // namespace trivar
