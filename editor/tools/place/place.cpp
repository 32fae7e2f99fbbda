// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/place/place.h"

#include "core/base/rounded.h"
#include "core/commands/placement/place.h"
#include "core/placement/embed.h"
#include "core/placement/redraw.h"
#include "core/steps/laying/attaching.h"
#include "core/steps/laying/ground_plane.h"
#include "editor/hands/helpers.h"
#include "editor/hands/selected_placement.h"
#include "editor/hands/strip_paint.h"
#include "editor/hands/viewport_input.h"
#include "editor/session/scene_facts.h"
#include "editor/session/session_facts.h"
#include "editor/session/topics.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace trivar {
namespace {

constexpr double near_line_px = 7; // of the old stroke, at scale 1: a new one redraws it
constexpr double rejoin_px = 16;   // in the old stroke's picture: a piece that ends so near rejoins

const Placement* placement_of(const Session& session, Id id)
{
    const auto found = session.evaluated().objects.find(id);
    return found == session.evaluated().objects.end() ? nullptr
                                                      : found->second->stroke_placement().get();
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

// Whether an object carries a laid model: a node of that touches the scene there. The object is
// furniture, though it was never placed itself.
bool carries(const EvaluatedObject& furniture, const Evaluation& evaluated)
{
    const Box& bounds = *furniture.bounds;
    const double slack = 0.01 * glm::length(bounds.size());
    return std::ranges::any_of(evaluated.objects, [&](const auto& entry) {
        const Ref<Placement>& placement = entry.second->stroke_placement();
        return placement && std::ranges::any_of(placement->nodes, [&](const StripNode& node) {
                   return node.contact == Contact::touches &&
                          bounds.distance(node.p_world) <= slack;
               });
    });
}

// A Refusal says why no stroke can begin anywhere, and what would help; nothing: it can.
struct Refusal {
    const char *what, *remedy;
};
std::optional<Refusal> refusal(const Session& session, Id model, bool on_ground)
{
    if (model == 0)
        return Refusal{"There is no model to place",
                       "Drop a model into the window, then draw the stroke again."};
    if (session.document().objects.size() < 2 && !on_ground)
        return Refusal{"Placing needs a second object or the ground",
                       "Begin the stroke on the ground beside the model, or add a second object to "
                       "place it on."};
    if (!session.hidden_here.empty() && bases_for_stroke(session, model).empty())
        return Refusal{"All objects it could lie on are hidden",
                       "Show the other objects, then draw the stroke again."};
    return {};
}

// Whether the mouse is on the ground that is seen, where no object is. What stands alone cannot be
// meant, so that it hides nothing.
bool over_ground(const Session& session, const ViewportInput& input)
{
    constexpr double seen = 20; // times the way to what the view turns about: beyond is the horizon
    if (input.seen_at(input.mouse) != 0 && session.document().objects.size() > 1) return false;
    const Camera& camera = session.view.camera;
    const auto distance = distance_to_ground(ray_through(camera, input.mouse));
    return distance && *distance < seen * glm::distance(camera.eye, camera.target);
}

// Paints a ring with a bar across: nothing can be done here.
void paint_no(const ui::Theme& theme, glm::vec2 at)
{
    const float radius = theme.px(7), slope = radius * 0.7f;
    const glm::vec2 bar(slope, slope);
    for (const auto& [color, wider] :
         {std::pair(theme.color.halo, 2.0f), {theme.color.stroke, 0.0f}}) {
        const float width = (1.8f + wider) * theme.scale;
        ui::paint_dot(at, radius, 0, color, width);
        ui::paint_line(at - bar, at + bar, color, width);
    }
}

} // namespace

bool can_be_placed(const Document& document, Id id)
{
    const auto found = document.objects.find(id);
    return found != document.objects.end() && kind_of(*found->second).has_shape;
}

std::vector<Id> bases_for_stroke(const Session& session, Id model)
{
    if (session.hidden_here.empty()) return {};
    std::vector<Id> bases = possible_bases(session.committed(), model);
    std::erase_if(bases,
                  [&](Id id) { return std::ranges::binary_search(session.hidden_here, id); });
    return bases;
}

Id model_to_place(const Session& session, Id chosen)
{
    const Document& document = session.document();
    if (can_be_placed(document, chosen)) return chosen;
    // The oldest is what the others are laid on: only what came later is meant, even where a click
    // selected the oldest.
    Id oldest = 0, newest = 0, newest_loose = 0, newest_laid = 0;
    for (const auto& [id, each] : document.objects) {
        if (!can_be_placed(document, id) || each->hidden || locked(document, id)) continue;
        if (oldest == 0) oldest = id;
        newest = id;
        if (each->stroke) newest_laid = id;
        if (id == oldest || each->stroke) continue;
        const auto shown = session.evaluated().objects.find(id);
        if (shown != session.evaluated().objects.end() &&
            carries(*shown->second, session.evaluated()))
            continue;
        newest_loose = id;
    }
    if (session.selected != oldest && can_be_placed(document, session.selected) &&
        !locked(document, session.selected))
        return session.selected;
    if (newest_loose != 0) return newest_loose;
    return newest_laid != 0 ? newest_laid : newest;
}

ToolState PlaceTool::state() const
{
    return {.busy = drawing_ || handles_.busy(),
            .crosshair = !handles_.hovers() && !handles_.busy(),
            .takes_wheel = drawing_,
            .shows_volume_at_work = !drawing_};
}

void PlaceTool::take_up(Session& session, Id object)
{
    session.selected = object;
    chosen_ = model_to_place(session, 0) == object ? 0 : object;
}

bool PlaceTool::copies(const Session& session) const
{
    const auto& objects = session.committed().objects;
    const auto model = objects.find(drawing_ ? model_ : model_to_place(session, chosen_));
    if (redrawing_ || model == objects.end() || !model->second->stroke) return false;
    return (new_stroke_ == NewStroke::copies) != other_;
}

const EvaluatedObject* PlaceTool::handled(const Session& session) const
{
    return *choice_ == HandleChoice::none ? nullptr : selected_placement(session);
}

Id PlaceTool::laid(const Session& session) const
{
    return copies(session) ? session.committed().next_id : model_;
}

Command PlaceTool::command(const Session& session) const
{
    const Object& model = object(session.committed(), model_);
    const Sketch& drawn = stroke_.sketch();
    if (!model.stroke) {
        PlacementParameters parameters = lengthwise(parameters_, stands_);
        if (width_ > 0) parameters.width = width_;
        parameters.width_profile = brush_profile(drawn.samples, brush_);
        parameters.on_ground = on_ground_;
        parameters.bridge_jumps = true;
        return Place{model_, drawn, std::move(parameters), bases_for_stroke(session, model_)};
    }
    // A new stroke for what was placed before keeps how it lies.
    EditPlacement edit{model_, model.stroke->parameters, drawn, bases_for_stroke(session, model_)};
    edit.parameters.bridge_jumps = true;
    const auto laid = session.evaluated().objects.find(model_);
    const bool lies = laid != session.evaluated().objects.end() && laid->second->lies_on;
    if (!redrawing_) {
        const bool copy = copies(session);
        edit.parameters = carried(std::move(edit.parameters), start_.to_world);
        if (width_ > 0) edit.parameters.width = width_;
        if (brush_ != Brush::even)
            edit.parameters.width_profile = brush_profile(drawn.samples, brush_);
        edit.parameters.on_ground = on_ground_;
        if (copy) return Place{model_, drawn, edit.parameters, *edit.onto, {}, copy};
        return edit;
    }
    edit.onto.reset();
    if (!lies) return edit;
    // In the space of the stroke, which its hosts have carried along since.
    const glm::dmat4 from_world = glm::inverse(start_.to_world);
    const Sketch& old = start_.sketch;
    if (width_ > 0) edit.parameters.width = width_ * glm::length(glm::dvec3(from_world[0]));
    edit.sketch = redrawn(old,
                          seen_from(old.camera, carried(drawn.camera, from_world), drawn.samples,
                                    *laid->second->lies_on),
                          rejoin_px);
    edit.attach = start_.hosts;
    return edit;
}

void PlaceTool::begin(Session& session, const ViewportInput& input)
{
    redrawing_ = on_line_;
    model_ = redrawing_ ? session.selected : model_to_place(session, chosen_);
    if (const auto no = refusal(session, model_, on_ground_)) {
        session.notices.say(ui::NoticeKind::warning, no->what, no->remedy, of_a_step);
        return;
    }
    start_ = {};
    const auto laid = session.evaluated().objects.find(model_);
    if (const auto& step = object(session.document(), model_).stroke;
        step && laid != session.evaluated().objects.end())
        start_ = {stroke_now(*laid->second, *step), stroke_to_world(*laid->second),
                  hosts_now(*laid->second, *step)};
    drawing_ = true;
    other_ = false;
    stands_ = bounds_of(session, model_);
    width_ = 0;
    typed_ = {};
    pressure_ = 0.5;
    stroke_.begin(session.view.camera, input.moves.empty() ? 0 : input.moves.front().time_s);
}

void PlaceTool::use(Session& session, const ViewportInput& input)
{
    if (!drawing_ &&
        handles_.use(session, input, placement_handles(session, *choice_, input.scale))) {
        on_line_ = false;
        return;
    }
    if (!drawing_) {
        const EvaluatedObject* laid = handled(session);
        on_line_ = laid && (input.hovered || input.pressed) &&
                   nearest_on_line(*laid->stroke_placement(), session.view.camera, input.mouse)
                           .distance_px < near_line_px * input.scale;
        const Id model = on_line_ ? 0 : model_to_place(session, chosen_);
        why_not_.clear();
        if (!on_line_ && (input.hovered || input.pressed)) on_ground_ = over_ground(session, input);
        if (!on_line_ && input.hovered) {
            if (const auto no = refusal(session, model, on_ground_))
                why_not_ = no->what;
            else if (!on_ground_ && input.seen_at(input.mouse) == 0)
                why_not_ = "Nothing under the pointer to place on";
        }
        if (input.pressed && !session.committing()) begin(session, input);
    }
    if (!drawing_) return;
    const ImGuiIO& io = ImGui::GetIO();
    retyped_ = retyped_ || other_ != io.KeyAlt;
    other_ = io.KeyAlt;
    if (input.wheel != 0 && brush_ == Brush::pressure)
        pressure_ = std::clamp(pressure_ * std::pow(1.15, input.wheel), 0.05, 1.0);
    else if (input.wheel != 0)
        if (const Placement* now = placement_of(session, laid(session)))
            width_ = rounded(
                (width_ > 0 ? width_ : now->report.width_world) * std::pow(1.1, input.wheel), 3);
    if (input.wheel != 0) typed_ = {};
    const bool grown =
        stroke_.take(input.moves, {.straight = io.KeyShift,
                                   .close = io.KeyCtrl && !redrawing_,
                                   .pressure = brush_ == Brush::pressure ? pressure_ : 1,
                                   .scale = input.scale});
    constexpr std::size_t enough_to_show = 3;
    if (input.released)
        finish(session);
    else if ((grown || input.wheel != 0 || retyped_) &&
             stroke_.sketch().samples.size() >= enough_to_show && session.up_to_date())
        // One proposal at a time: the next piece waits until the last one can be seen.
        retyped_ = !session.propose_quietly(command(session));
}

void PlaceTool::take_keys(Session& session)
{
    (void)session;
    handles_.take_keys();
    if (!drawing_ || !typed_.take_letters()) return;
    constexpr double widest = 1e6; // as in the options bar
    width_ = std::clamp(typed_.value(0, Measure::length).value_or(0), 0.0, widest);
    retyped_ = true;
}

void PlaceTool::finish(Session& session)
{
    const Id laying = laid(session); // before it is there
    if (stroke_.is_click()) {
        drawing_ = false;
        session.cancel();
        session.notices.say(ui::NoticeKind::warning, "Nothing was placed",
                            "Draw a line across the scene before you let go.", of_a_step);
        return;
    }
    const Command done = command(session);
    drawing_ = other_ = false;
    if (session.propose(done))
        session.commit_if_placed(laying);
    else
        session.cancel();
    const auto& objects = session.document().objects;
    if (const auto it = objects.find(laying); it != objects.end() && it->second->stroke)
        session.selected = laying;
}

void PlaceTool::cancel(Session& session)
{
    handles_.cancel(session);
    if (!drawing_) return;
    drawing_ = false;
    session.cancel();
}

Helpers PlaceTool::helpers(const Session& session, const ui::Theme& theme) const
{
    const EvaluatedObject* held = handled(session);
    const Placement* placement = drawing_ ? placement_of(session, laid(session))
                                 : held   ? held->stroke_placement().get()
                                          : nullptr;
    if (!placement) return {};
    Helpers out{{}, {strip_veil(*placement, theme)}};
    if (!drawing_) return out;
    for (const std::vector<glm::dvec3>& curve : placement->strip) {
        gpu::Line line;
        line.points.assign(curve.begin(), curve.end());
        line.color = ui::linear_light(theme.color.stroke);
        line.width_px = theme.line(out.lines.empty() ? 3.0f : 1.4f);
        out.lines.push_back(std::move(line));
    }
    return out;
}

void PlaceTool::overlay(const Session& session, const ui::Theme& theme,
                        const ViewportInput& input) const
{
    if (drawing_) return paint_stroke(session, theme, input);
    if (const EvaluatedObject* laid = handled(session)) {
        paint_nodes(theme, input, session.view.camera, *laid->stroke_placement(), Nodes::trouble);
        paint_strip_legend(theme, input.rect, *laid->stroke_placement());
    }
    handles_.paint(theme, input, placement_handles(session, *choice_, input.scale),
                   end_of_words(theme, input));
    if (!input.hovered || handles_.hovers() || handles_.busy()) return;
    const glm::vec2 mouse = input.rect.lo + glm::vec2(input.mouse);
    if (!why_not_.empty()) return paint_no(theme, mouse);
    ui::paint_dot(mouse, theme.px(5), ui::faded(theme.color.stroke, 0.35f), theme.color.stroke,
                  1.4f * theme.scale);
    const char* where = on_line_ ? "redraw" : on_ground_ ? "on the ground" : nullptr;
    if (where) ui::paint_chip(theme, mouse + glm::vec2(theme.px(18), -theme.px(30)), {where});
}

void PlaceTool::paint_stroke(const Session& session, const ui::Theme& theme,
                             const ViewportInput& input) const
{
    const glm::vec2 mouse = input.rect.lo + glm::vec2(input.mouse);
    const Placement* placement = placement_of(session, laid(session));
    std::vector<glm::vec2> path;
    for (const StrokeSample& sample : stroke_.sketch().samples)
        path.push_back(input.rect.lo + glm::vec2(sample.p_px));
    double radius_px = theme.px(6);
    // A band of the strip's width shows at once where the model will lie.
    if (placement && path.size() > 1) {
        const auto& strip = placement->strip; // none: the box of a lattice that is not laid yet
        const glm::dvec3 end = strip.empty() || strip.front().empty() ? session.view.camera.target
                                                                      : strip.front().back();
        const double depth = std::max(1e-6, project(session.view.camera, end).depth_world);
        const double width = width_ > 0 ? width_ : placement->report.width_world;
        const double width_px = width / pixel_size_world(session.view.camera, depth);
        ui::paint_path(path, ui::faded(theme.color.stroke, 0.16f),
                       static_cast<float>(std::clamp(width_px, 2.0, 400.0)));
        const double share = brush_ == Brush::pressure ? 2 * pressure_ : 1;
        radius_px = std::clamp(width_px / 2 * share, radius_px, 200.0);
        paint_nodes(theme, input, session.view.camera, *placement, Nodes::all);
        paint_strip_legend(theme, input.rect, *placement);
    }
    ui::paint_path(path, theme.color.halo, theme.line(5));
    ui::paint_path(path, theme.color.stroke, theme.line(3));
    // The brush, and its middle.
    ui::paint_dot(mouse, static_cast<float>(radius_px), 0, theme.color.halo, 3 * theme.scale);
    ui::paint_dot(mouse, static_cast<float>(radius_px), 0, theme.color.stroke, 1.5f * theme.scale);
    ui::paint_dot(mouse, theme.px(5), theme.color.stroke, theme.color.halo, 1.5f * theme.scale);
    if (stroke_.is_ring())
        ui::paint_dot(path.front(), theme.px(9), 0, theme.color.free_node, 2 * theme.scale);
    measure_chips(theme, mouse, placement);
}

} // namespace trivar
