// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/incise/incise.h"

#include "core/base/rounded.h"
#include "editor/hands/select.h"
#include "editor/hands/usual_layers.h"
#include "editor/hands/viewport_input.h"
#include "editor/session/topics.h"
#include "editor/tools/incise/incision_handles.h"
#include "editor/tools/incise/incision_picture.h"
#include "ui/sentence.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace trivar {
namespace {

constexpr double cut_reach_px = 7; // of a cut under the mouse, at scale 1
// The sizes of a new incision unless they are chosen: shares of the model's diagonal, and at most
// so much of its length.
constexpr double usual_width = 0.035, usual_depth = 0.07;
constexpr double widest_of_length = 0.16, deepest_of_length = 0.35;

bool can_be_cut(const Session& session, Id id)
{
    const auto there = session.document().objects.find(id);
    const auto shown = session.evaluated().objects.find(id);
    return there != session.document().objects.end() &&
           shown != session.evaluated().objects.end() && kind_of(*there->second).has_surface &&
           !there->second->tiles && !shown->second->shape->meshes.empty() &&
           !locked(session.document(), id);
}

} // namespace

ToolState InciseTool::state() const
{
    return {.busy = gesture_ || in_air_ || handles_.busy() || finishing_,
            .crosshair = gesture_ || (over_ && !handles_.hovers() && !handles_.busy()),
            .takes_wheel = gesture_.has_value(),
            .mode = looks_};
}

const NamedIncision* InciseTool::chosen(const Session& session)
{
    return chosen_in(session.document(), session.selected, session.incision);
}

Id InciseTool::base_of(const Session& session, Id under)
{
    const auto there = session.document().objects.find(under);
    if (there == session.document().objects.end()) return 0;
    // Tiles are cut by cutting what carries them
    const Id base = there->second->tiles ? there->second->tiles->base : under;
    return can_be_cut(session, base) ? base : Id{0};
}

// Where a step has moved the chosen incision in the list, it stays the chosen one.
void InciseTool::keep_chosen(Session& session) const
{
    const NamedIncision* now = chosen(session);
    const auto index = static_cast<std::size_t>(session.incision.number) - 1;
    if (!known_ || known_of_ != session.selected || shown_chosen_ != session.incision ||
        session.incision.number < 1 || index >= known_->cuts.size())
        return;
    const std::vector<SurfacePoint>& stroke = known_->cuts[index].cut.stroke;
    if (now && now->cut.stroke == stroke) return;
    const auto there = session.document().objects.find(session.selected);
    if (there == session.document().objects.end() || !there->second->incising) return;
    const std::vector<NamedIncision>& cuts = there->second->incising->cuts;
    for (std::size_t i = 0; i < cuts.size(); ++i)
        if (cuts[i].cut.stroke == stroke) session.incision.number = static_cast<int>(i) + 1;
}

void InciseTool::look(const Session& session)
{
    const Id id = session.selected;
    const auto there = session.document().objects.find(id);
    if (there == session.document().objects.end() || !there->second->incising ||
        !can_be_cut(session, id)) {
        skin_ = {};
        known_.reset();
        known_shown_ = nullptr;
        cuts_.clear();
        crossings_.clear();
        return;
    }
    skin_.look(session, id);
    const Incising& incising = *there->second->incising;
    if (known_shown_ == skin_.shown() && known_ == incising) return;
    known_shown_ = skin_.shown();
    known_ = incising;
    known_of_ = id;
    const auto& told = skin_.shown()->incisions;
    const int number = session.incision.object == id ? session.incision.number : 0;
    cuts_.resize(incising.cuts.size());
    open_ = incising;
    for (std::size_t i = 0; i < std::min(told.size(), open_.cuts.size()); ++i)
        open_.cuts[i].opening.to = told[i].open_to;
    const auto see = [&](std::size_t i) {
        cuts_[i].reset();
        if (!incising.cuts[i].hidden)
            cuts_[i] = seen_incision(skin_, open_.cuts[i], i < told.size() ? &told[i] : nullptr);
    };
    const auto& held = handles_.key().numbers;               // of both that cross, or 0
    for (int i = 0; i < static_cast<int>(cuts_.size()); ++i) // in a drag only what is in the hand
        if (!handles_.busy() || i + 1 == number || i + 1 == held[0] || i + 1 == held[1])
            see(static_cast<std::size_t>(i));
    crossings_ = crossings_of(cuts_);
    looks_ = (looks_ + 1) % 4;
}

const SeenIncision* InciseTool::seen_chosen(const Session& session) const
{
    const auto number = static_cast<std::size_t>(session.incision.number);
    if (!chosen(session) || number > cuts_.size() || !cuts_[number - 1]) return nullptr;
    return &*cuts_[number - 1];
}

std::vector<Handle> InciseTool::handles(const Session& session, double scale) const
{
    const SeenIncision* seen = seen_chosen(session);
    if (!seen || !known_) return {};
    const int number = session.incision.number;
    const Camera& camera = session.view.camera;
    const auto take = [this, &session, number]() -> std::optional<TakenIncision> {
        const SeenIncision* now = seen_chosen(session);
        if (!now) return {};
        return TakenIncision{session.selected, number, session.document(), *now, skin_,
                             snaps_but(number)};
    };
    const bool holds_crossing = handles_.busy() && handles_.key().numbers[0] != 0;
    const glm::dvec2 near_px =
        holds_crossing ? project(camera, handles_.held_at()).p_px : mouse_px_;
    std::vector<Handle> out =
        crossing_handles({open_, cuts_, crossings_}, number, camera, near_px, scale, take);
    std::vector<double> crossed;
    for (const IncisionCrossing& each : crossings_)
        if (each.first == number || each.second == number) crossed.push_back(each.share_of(number));
    std::ranges::move(incision_handles(open_.cuts[static_cast<std::size_t>(number) - 1],
                                       *chosen(session), *seen, camera, scale, crossed, take),
                      std::back_inserter(out));
    return out;
}

IncisionSnaps InciseTool::snaps_but(int number) const
{
    IncisionSnaps out;
    for (std::size_t i = 0; i < cuts_.size() && snaps_; ++i)
        if (static_cast<int>(i) + 1 != number && cuts_[i])
            add_snaps(out, *cuts_[i], known_->cuts[i].cut.stroke);
    for (const IncisionCrossing& each : crossings_)
        if (snaps_ && each.first != number && each.second != number)
            out.ends.push_back({each.at.at_rest, each.at.p_world, false, true});
    return out;
}

void InciseTool::use(Session& session, const ViewportInput& input)
{
    if (finishing_) return tell_how_it_ended(session);
    if (gesture_) return go_on(session, input);
    if (in_air_) return come_from_air(session, input);
    mouse_px_ = input.mouse;
    keep_chosen(session);
    look(session);
    if (shown_chosen_ != session.incision) looks_ = (looks_ + 1) % 4;
    shown_chosen_ = session.incision;
    const bool dragged = handles_.busy();
    if (dragged && !chosen(session)) return cancel(session);
    const bool draws = !dragged && ImGui::GetIO().KeyShift; // a stroke begins even on a handle
    const bool on_handle =
        handles_.use(session, input, draws ? std::vector<Handle>{} : handles(session, input.scale));
    if (dragged) return;
    hover(session, input);
    if (session.committing() || (on_handle && input.pressed)) return;
    if (input.pressed)
        press(session, input);
    else if (input.hovered)
        drag_by_key(session, input);
}

void InciseTool::hover(Session& session, const ViewportInput& input)
{
    hovered_snap_.reset();
    hovered_cut_ = 0;
    over_ = 0;
    if (!input.hovered && !input.pressed) return;
    const Camera& camera = session.view.camera;
    double nearest = cut_reach_px * input.scale;
    for (std::size_t i = 0; i < cuts_.size(); ++i)
        if (const auto near = cuts_[i] ? near_cut(*cuts_[i], camera, input.mouse) : std::nullopt;
            near && near->away_px < nearest) {
            nearest = near->away_px;
            hovered_cut_ = static_cast<int>(i) + 1;
            hovered_at_ = near->share;
        }
    over_ = base_of(session, input.seen_at ? input.seen_at(input.mouse) : Id{0});
    if (!handles_.hovers() && over_ != 0 && over_ == session.selected)
        hovered_snap_ = snap_near(snaps_but(0), camera, input.mouse, input.scale);
}

NamedIncision InciseTool::drawn(const Gesture& g) const
{
    NamedIncision out = settings_;
    out.cut.stroke = g.stroke.points();
    const double length = length_of(out.cut.stroke), scale = g.stroke.scale();
    const double diagonal = g.stroke.skin().diagonal();
    const std::optional<double> typed = typed_.value(0, Measure::length);
    const double wish = typed && *typed > 0 ? *typed / g.factor : width_world_;
    const double width =
        wish > 0 ? wish / scale : std::min(usual_width * diagonal, widest_of_length * length);
    const double depth = depth_world_ > 0
                             ? depth_world_ / scale
                             : std::min(usual_depth * diagonal, deepest_of_length * length);
    out.cut.width = rounded(g.factor * width, 3);
    out.cut.depth = rounded(depth, 3);
    out.opening.share = opens_ ? 1 : 0;
    return out;
}

Command InciseTool::command_of(const Gesture& g) const
{
    if (!g.redrawn) {
        Incise out{g.object, drawn(g)};
        out.layers = usual_layers(out.incision.cut.depth); // of the first one
        return out;
    }
    EditIncision out{g.object, g.clicked, *g.redrawn};
    // The part between where the hand began and the place of the cut that is nearest to where it
    // is; the rest of the cut, where that is far away
    const std::vector<SurfacePoint> old = g.redrawn->cut.stroke, drawn = g.stroke.points();
    const std::vector<SurfacePoint> even = at_equal_steps(old, SeenIncision::steps);
    double nearest = 0.05 * length_of(old), to = -1;
    for (std::size_t i = 0; i < even.size(); ++i)
        if (const double away = glm::distance(even[i].p, drawn.back().p); away < nearest) {
            nearest = away;
            to = static_cast<double>(i) / static_cast<double>(SeenIncision::steps);
        }
    std::vector<SurfacePoint>& stroke = out.incision.cut.stroke;
    stroke.clear();
    const auto add = [&](std::vector<SurfacePoint> points) {
        stroke.insert(stroke.end(), points.begin(), points.end());
    };
    std::vector<SurfacePoint> between = drawn;
    if (to >= 0 && to < g.from) { // it was drawn from the end to the start
        std::ranges::reverse(between);
        if (to > 0) add(part_of(old, 0, to));
        add(between);
        if (g.from < 1) add(part_of(old, g.from, 1));
    } else {
        if (g.from > 0) add(part_of(old, 0, g.from));
        add(between);
        if (to >= 0 && to < 1) add(part_of(old, to, 1));
    }
    for (SurfacePoint& each : stroke) each = handy(each);
    return out;
}

void InciseTool::go_on(Session& session, const ViewportInput& input)
{
    Gesture& g = *gesture_;
    if (!session.document().objects.contains(g.object)) return cancel(session);
    if (input.wheel != 0) {
        g.factor *= std::pow(1.1, input.wheel);
        g.changed = true;
    }
    const IncisionStroke::HeldKeys keys{ImGui::GetIO().KeyShift || way_ == Way::straight,
                                        way_ == Way::uv, input.scale};
    g.changed = g.stroke.take(session.view.camera, input.moves, keys) || g.changed;
    if (input.released || !input.down) return finish(session);
    // One proposal at a time: the next waits until the last one can be seen.
    if (!g.changed || g.stroke.is_click() || g.stroke.points().size() < 2 || !session.up_to_date())
        return;
    if (session.propose_quietly(command_of(g))) g.changed = false;
}

void InciseTool::finish(Session& session)
{
    const Gesture g = std::move(*gesture_);
    gesture_.reset();
    if (g.stroke.is_click()) {
        session.cancel();
        if (g.clicked == 0) select_by_click(session, g.under);
        session.incision = g.clicked == 0 ? ChosenIncision{} : ChosenIncision{g.object, g.clicked};
        return;
    }
    if (g.stroke.points().size() < 2) return session.cancel();
    const std::optional<Incising>& before = object(session.committed(), g.object).incising;
    const int number =
        g.redrawn ? g.clicked : static_cast<int>(before ? before->cuts.size() : 0) + 1;
    if (!session.propose(command_of(g))) return session.cancel();
    typed_ = {};
    finishing_ = Finishing{g.object, number};
    tell_how_it_ended(session);
}

void InciseTool::tell_how_it_ended(Session& session)
{
    if (!session.up_to_date()) return;
    const Finishing f = *finishing_;
    finishing_.reset();
    if (!session.proposing()) return;
    const auto shown = session.evaluated().objects.find(f.object);
    const auto index = static_cast<std::size_t>(f.number) - 1;
    if (shown != session.evaluated().objects.end() && index < shown->second->incisions.size())
        if (const std::string& why = shown->second->incisions[index].refusal; !why.empty()) {
            session.cancel();
            session.notices.say(ui::NoticeKind::warning, "This cannot be cut", ui::sentence(why),
                                of_a_step);
            return;
        }
    session.commit();
    session.selected = f.object;
    session.incision = {f.object, f.number};
}

void InciseTool::cancel(Session& session)
{
    if (finishing_) { // the hand was done with it
        finishing_.reset();
        session.commit();
        return;
    }
    in_air_.reset();
    handles_.cancel(session);
    if (!gesture_) return;
    gesture_.reset();
    typed_ = {};
    session.cancel();
}

bool InciseTool::resize(Session& session, double factor)
{
    if (gesture_) {
        gesture_->factor *= factor;
        gesture_->changed = true;
        return true;
    }
    if (width_world_ == 0) {
        const auto shown = session.evaluated().objects.find(session.selected);
        if (shown == session.evaluated().objects.end()) return false;
        width_world_ = usual_width * glm::length(shown->second->bounds->size());
    }
    width_world_ = rounded(width_world_ * factor, 3);
    return true;
}

std::optional<std::vector<std::string>> InciseTool::numbers(const Session& session) const
{
    if (!chosen(session)) return {};
    const std::string of = fmt::format("incising.cuts.{}.", session.incision.number - 1);
    std::vector out{of + "opening", of + "from", of + "to"};
    const std::vector<PeeledFlap>& flaps =
        object(session.document(), session.selected).incising->flaps;
    for (std::size_t k = 0; k < flaps.size(); ++k)
        if (flaps[k].first == session.incision.number || flaps[k].second == session.incision.number)
            out.push_back(fmt::format("incising.flaps.{}.lift", k));
    return out;
}

bool InciseTool::choose(Session& session, PartChoice choice)
{
    if (choice != PartChoice::none || !chosen(session)) return false;
    session.incision = {};
    return true;
}

bool InciseTool::remove(Session& session)
{
    if (!chosen(session)) return false;
    session.run(RemoveIncision{session.selected, session.incision.number});
    session.incision = {};
    return true;
}

} // namespace trivar
