// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/lattice_points.h"

#include "editor/picture/volume_picture.h"

#include "core/commands/edits.h"
#include "editor/tools/gesture_keys.h"
#include "editor/tools/last_shaping.h"
#include "editor/tools/lattice_round.h"
#include "editor/tools/placement_handles.h"
#include "editor/tools/select.h"
#include "ui/icons.h"
#include "ui/option_bar.h"
#include "ui/widgets.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>
#include <limits>

namespace trivar {
namespace {

constexpr double point_reach_px = 10;     // of the mouse, at scale 1
constexpr std::size_t most_shown = 20000; // at once, of all; of more those round the mouse
constexpr double shown_reach_px = 90;     // of it, at scale 1

glm::ivec3 size_of(const Lattice& volume)
{
    const std::array<Knots, 3>& axes = volume.displacement.axes;
    return {axes[0].count(), axes[1].count(), axes[2].count()};
}

bool all_are_shown(const Lattice& volume)
{
    return volume.displacement.points.size() <= most_shown;
}

// Calls visit(index, pixel) for each control point before the eye.
void each_point(const Lattice& volume, const Camera& camera, auto&& visit)
{
    const glm::ivec3 n = size_of(volume);
    for (int i = 0; i < n.x; ++i)
        for (int j = 0; j < n.y; ++j)
            for (int k = 0; k < n.z; ++k) {
                const Projected p = project(camera, control_point(volume, i, j, k));
                if (p.depth_world > 0) visit(glm::ivec3(i, j, k), p.p_px);
            }
}

glm::dvec3 middle_of(const Lattice& volume, const std::vector<glm::ivec3>& points)
{
    glm::dvec3 sum(0);
    for (const glm::ivec3& p : points) sum += control_point(volume, p.x, p.y, p.z);
    return sum / static_cast<double>(points.size());
}

// The handles stand in the middle, along the directions at the first point.
MotionFrame frame_of(const Lattice& volume, const std::vector<glm::ivec3>& points)
{
    const VolumeDirections at = volume_directions(volume, greville(volume, points.front()));
    return {middle_of(volume, points), glm::dmat3(at.along, at.across, at.up)};
}

// Which of a volume's control points are among those, by their index.
std::vector<char> flags_of(const Lattice& volume, const std::vector<glm::ivec3>& points)
{
    std::vector<char> out(volume.displacement.points.size());
    for (const glm::ivec3& p : points) out[volume.displacement.index(p.x, p.y, p.z)] = 1;
    return out;
}

// Those within are fainter, so that the box reads as one.
bool on_shell(const Lattice& volume, const glm::ivec3& p)
{
    const glm::ivec3 last = size_of(volume) - 1;
    return glm::any(glm::equal(p, glm::ivec3(0))) || glm::any(glm::equal(p, last));
}

// A dot on a dark one, so that it stands out on any ground.
void paint_point(const ui::Theme& theme, glm::vec2 at, float radius, ui::Color color)
{
    const float alpha = static_cast<float>(color >> 24) / 255;
    ui::paint_dot(at, theme.scale * (radius + 1.25f), ui::faded(theme.color.halo, alpha), 0, 0);
    ui::paint_dot(at, theme.scale * radius, color, 0, 0);
}

bool has(const std::vector<glm::ivec3>& points, const glm::ivec3& point)
{
    return std::ranges::find(points, point) != points.end();
}

} // namespace

const char* LatticePointsTool::icon() const
{
    return ui::icon::volume;
}

Command LatticePointsTool::command() const
{
    return MovePoints{object_, {chosen_, shown_, mirror_, guard_, of_}};
}

void LatticePointsTool::keep_what_is_there(const Session& session)
{
    const EvaluatedObject* laid = selected_volume(session);
    if (!laid || laid->id != object_) chosen_.clear();
    object_ = laid ? laid->id : 0;
    if (!laid) return;
    const glm::ivec3 n = size_of(laid->placement->volume);
    std::erase_if(chosen_,
                  [&](const glm::ivec3& p) { return p.x >= n.x || p.y >= n.y || p.z >= n.z; });
}

std::optional<glm::ivec3> LatticePointsTool::point_at(const Session& session,
                                                      const ViewportInput& input) const
{
    std::optional<glm::ivec3> nearest;
    double distance = point_reach_px * input.scale;
    each_point(selected_volume(session)->placement->volume, session.view.camera,
               [&](const glm::ivec3& p, glm::dvec2 at) {
                   const double far = glm::distance(at, input.mouse);
                   if (far >= distance) return;
                   distance = far;
                   nearest = p;
               });
    return nearest;
}

bool LatticePointsTool::grab(Session& session)
{
    keep_what_is_there(session);
    grabbing_ = !chosen_.empty() && !session.committing();
    return grabbing_;
}

void LatticePointsTool::use(Session& session, const ViewportInput& input)
{
    tell(session);
    outside_ = !input.hovered;
    if (gesture_) {
        if (!selected_volume(session)) return cancel(session);
        return go_on(session, input);
    }
    keep_what_is_there(session);
    hovered_.reset();
    hovered_handle_ = {};
    if (object_ == 0) {
        box_px_.reset();
        if (input.pressed) select_by_click(session, input.under);
        return;
    }
    const Lattice& volume = selected_volume(session)->placement->volume;
    if (box_px_) {
        if (!input.released && input.down) return;
        if (glm::distance(*box_px_, input.mouse) >= click_slip_px)
            choose_in_box(session, input);
        else if (input.under != 0 && input.under != object_)
            select_by_click(session, input.under);
        else if (!ImGui::GetIO().KeyCtrl)
            chosen_.clear();
        box_px_.reset();
        return;
    }
    if (std::exchange(grabbing_, false) && !chosen_.empty()) {
        begin(session, input, {});
        by_key_ = true;
        return;
    }
    if (!input.hovered && !input.pressed) return;
    if (!chosen_.empty())
        hovered_handle_ = handle_at(gizmo_shapes(MotionKind::move, session.view.camera,
                                                 frame_of(volume, chosen_), input.scale),
                                    glm::vec2(input.mouse), input.scale);
    // The middle of the handles covers a single chosen point: both move it.
    if (hovered_handle_.grip == Grip::none) hovered_ = point_at(session, input);
    if (hovered_ || hovered_handle_.grip != Grip::none)
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (!input.pressed || session.committing()) return;
    if (hovered_handle_.grip != Grip::none)
        begin(session, input, hovered_handle_);
    else if (hovered_)
        choose(session, input);
    else
        box_px_ = input.mouse;
}

void LatticePointsTool::choose(const Session& session, const ViewportInput& input)
{
    const glm::ivec3 point = *hovered_;
    if (ImGui::GetIO().KeyCtrl) {
        if (std::erase(chosen_, point) == 0) chosen_.push_back(point);
        return;
    }
    if (!has(chosen_, point)) chosen_ = {point};
    begin(session, input, {Grip::center, 0});
}

void LatticePointsTool::choose_in_box(const Session& session, const ViewportInput& input)
{
    const glm::dvec2 lo = glm::min(*box_px_, input.mouse), hi = glm::max(*box_px_, input.mouse);
    if (!ImGui::GetIO().KeyCtrl) chosen_.clear();
    const Lattice& volume = selected_volume(session)->placement->volume;
    const std::vector<char> before = flags_of(volume, chosen_);
    each_point(volume, session.view.camera, [&](const glm::ivec3& p, glm::dvec2 at) {
        const bool inside =
            glm::all(glm::greaterThanEqual(at, lo)) && glm::all(glm::lessThanEqual(at, hi));
        if (inside && before[volume.displacement.index(p.x, p.y, p.z)] == 0) chosen_.push_back(p);
    });
}

void LatticePointsTool::begin(const Session& session, const ViewportInput& input,
                              const Handle& handle)
{
    const Lattice& volume = selected_volume(session)->placement->volume;
    const MotionFrame frame = frame_of(volume, chosen_);
    of_ = size_of(volume);
    by_key_ = false;
    // The gesture is that of an object which stands there, turned as the volume is.
    const Stand stand{object_,
                      {.translation = frame.pivot,
                       .rotation_deg = decomposed(glm::dmat4(frame.axes)).rotation_deg},
                      glm::dmat4(1)};
    gesture_.emplace(MotionKind::move, std::vector<Stand>{stand}, object_,
                     TransformChoices{.orientation = Orientation::local, .step_m = 0.01},
                     session.view.camera, Grasp{frame.pivot, handle, input.mouse, input.scale});
    shown_ = glm::dvec3(0);
}

void LatticePointsTool::go_on(Session& session, const ViewportInput& input)
{
    const ImGuiIO& io = ImGui::GetIO();
    gesture_->move_hand(session.view.camera, input.mouse,
                        {.snap = io.KeyCtrl, .fine = io.KeyShift});
    if (by_key_ ? input.pressed : input.released || !input.down) return finish(session);
    if (!by_key_ && !gesture_->typed().open() && gesture_->travelled_px() < click_slip_px) return;
    const glm::dvec3 wanted = gesture_->motion().offset;
    // One proposal at a time: the next waits until the last one can be seen.
    if (wanted == shown_ || !session.up_to_date()) return;
    shown_ = wanted;
    session.propose_quietly(command());
}

void LatticePointsTool::finish(Session& session)
{
    shown_ = gesture_->motion().offset;
    const bool meant =
        by_key_ || gesture_->travelled_px() >= click_slip_px || gesture_->typed().open();
    gesture_.reset();
    if (meant && shown_ != glm::dvec3(0) && session.propose(command())) {
        told_of_ = object_;
        session.commit();
    } else
        session.cancel();
}

void LatticePointsTool::tell(Session& session)
{
    if (told_of_ == 0 || gesture_ || !session.up_to_date()) return;
    const Shaping* last = last_shaping(session, std::exchange(told_of_, 0));
    if (last && last->would_fold)
        tell_where_it_stopped(session, *last, "The control points", "Move their neighbours too",
                              object_, held_parts(session));
}

std::vector<VolumePart> LatticePointsTool::held_parts(const Session& session) const
{
    const EvaluatedObject* laid = selected_volume(session);
    if (!laid || laid->id != object_ || chosen_.empty()) return {};
    return with_mirrored(bent_by(laid->placement->volume, chosen_), mirror_);
}

void LatticePointsTool::cancel(Session& session)
{
    box_px_.reset();
    if (!gesture_) return;
    gesture_.reset();
    session.cancel();
}

void LatticePointsTool::take_keys(Session& session)
{
    if (!gesture_) return;
    const bool ended = take_gesture_keys(*gesture_);
    // A click elsewhere in the window ends it too, before the panel there sees the click.
    const bool elsewhere = by_key_ && outside_ && ImGui::IsMouseClicked(ImGuiMouseButton_Left);
    if (ended || elsewhere) finish(session);
}

std::vector<gpu::Line> LatticePointsTool::lines(const Session& session,
                                                const ui::Theme& theme) const
{
    const EvaluatedObject* laid = selected_volume(session);
    if (!laid || !all_are_shown(laid->placement->volume)) return {};
    if (is_lattice(session.document(), laid->id)) return {}; // its net is shown anyway
    return shell_lines(laid->placement->volume, theme.color.lattice, theme.line(1),
                       {.edges = 0.26f});
}

void LatticePointsTool::overlay(const Session& session, const ui::Theme& theme,
                                const ViewportInput& input) const
{
    const EvaluatedObject* laid = selected_volume(session);
    if (!laid) return;
    const Lattice& volume = laid->placement->volume;
    const std::vector<char> flags = flags_of(volume, chosen_);
    const double reach_px = all_are_shown(volume) ? std::numeric_limits<double>::infinity()
                                                  : shown_reach_px * input.scale;
    std::size_t shown = 0;
    each_point(volume, session.view.camera, [&](const glm::ivec3& p, glm::dvec2 at) {
        const bool chosen = flags[volume.displacement.index(p.x, p.y, p.z)] != 0,
                   lit = hovered_ && *hovered_ == p;
        if (!lit && !chosen && glm::distance(at, input.mouse) > reach_px) return;
        if (!lit && ++shown > most_shown) return;
        const glm::vec2 at_window = input.rect.lo + glm::vec2(at);
        if (lit || chosen)
            paint_point(theme, at_window, lit ? 5.5f : 4.5f, theme.color.selected);
        else
            paint_point(theme, at_window, 3,
                        on_shell(volume, p) ? theme.color.lattice
                                            : ui::faded(theme.color.lattice, 0.45f));
    });
    if (box_px_ && glm::distance(*box_px_, input.mouse) >= click_slip_px)
        paint_choice_box(theme, input, *box_px_);
    if (chosen_.empty() || box_px_) return;
    paint_gizmo(
        theme, input.rect.lo,
        gizmo_shapes(MotionKind::move, session.view.camera, frame_of(volume, chosen_), input.scale),
        gesture_ ? gesture_->constraint() : hovered_handle_);
    const Shaping* step =
        gesture_ && session.proposing() ? last_shaping(session, object_) : nullptr;
    if (!step) return;
    const bool short_of = step->would_fold;
    ui::paint_chip(theme,
                   input.rect.lo + glm::vec2(input.mouse) + glm::vec2(theme.px(18), -theme.px(30)),
                   {amount_words(step->done) + (short_of ? ", would fold" : ""),
                    short_of ? theme.color.bad : ui::Color{0}});
}

void LatticePointsTool::options(Session& session, const ui::Theme& theme, float width)
{
    const EvaluatedObject* laid = selected_volume(session);
    std::vector<ui::Option> options;
    if (!laid && session.selected != 0) {
        options.push_back({"", 190,
                           [&](float field) {
                               if (ui::button(theme, lattice_action, ui::ButtonKind::plain,
                                              {field, theme.size.row}))
                                   put_lattice_round_selection(session);
                           },
                           "What is selected bends with the control points of a box round it."});
        return ui::option_bar(theme, options, width);
    }
    options.push_back({"Mirror", 20, [&](float) { ui::check_box(theme, "mirror", mirror_, ""); },
                       "Points on the other side of the middle go the other way across."});
    options.push_back({"Guard", 20, [&](float) { ui::check_box(theme, "guard", guard_, ""); },
                       "No further than is proven not to fold the volume."});
    if (laid) {
        const glm::ivec3 n = size_of(laid->placement->volume);
        const std::string words = fmt::format("{} of {} x {} x {}", chosen_.size(), n.x, n.y, n.z);
        options.push_back({"Points", 128,
                           [&theme, words](float field) {
                               const ImVec2 at = ImGui::GetCursorScreenPos();
                               ui::name_text(theme.font.body,
                                             ui::rect_at({at.x, at.y}, {field, theme.size.row}),
                                             theme.color.text_2, words);
                           },
                           "Control points that are chosen, of those along, across and up."});
        if (!chosen_.empty())
            options.push_back({"", 150,
                               [&](float field) {
                                   if (ui::button(theme, allow_folds_action, ui::ButtonKind::plain,
                                                  {field, theme.size.row}))
                                       allow_folds(session, object_, held_parts(session));
                               },
                               "All that bends with the chosen points may fold from then on."});
    }
    ui::option_bar(theme, options, width);
}

std::vector<Hint> LatticePointsTool::hints(const Session& session) const
{
    if (gesture_)
        return {{{}, gesture_->words()},
                {{"left"}, by_key_ ? "Done" : "Let go when done"},
                {{"X", "Y", "Z"}, "Along, across, up"},
                {{"0", "-", "9"}, "Type it"},
                {{"Ctrl"}, "Snap"},
                {{"Shift"}, "Fine"},
                {{"Esc", "/", "right"}, "Cancel"}};
    const EvaluatedObject* laid = selected_volume(session);
    if (!laid)
        return {{{}, "Select a placed object or a lattice, or put one round what is selected"},
                {{"left"}, "Select"},
                {{"Esc"}, "Select"}};
    std::vector<Hint> hints{
        {{"left"}, chosen_.empty() ? "Choose a point" : "Drag a point or handle"},
        {{"Ctrl", "left"}, "Add or remove"},
        {{"left"}, "Drag a box"},
        {{"middle"}, "Orbit"},
        {{"Esc"}, "Select"}};
    if (!chosen_.empty()) hints.insert(hints.begin() + 1, {{"@Move"}, "Move with the mouse"});
    if (!all_are_shown(laid->placement->volume))
        hints.insert(hints.begin(), {{}, "There are many: those round the mouse are shown"});
    return hints;
}

} // namespace trivar
