// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/viewport/viewport.h"

#include "core/base/mistake.h"
#include "editor/picture/limit_colors.h"
#include "editor/picture/picture.h"
#include "editor/session/volume_levels.h"
#include "editor/viewport/picture_selection.h"
#include "editor/viewport/viewport_drawn.h"
#include "gpu/context.h"
#include "ui/camera_control.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <imgui.h>
#include <iterator>
#include <utility>

namespace trivar {
namespace {

glm::dvec2 mouse_in(const ui::Rect& rect)
{
    const ImVec2 p = ImGui::GetIO().MousePos;
    return glm::dvec2(p.x, p.y) - glm::dvec2(rect.lo);
}

// The picture may be older than the document.
bool can_be_picked(const Document& document, Id id)
{
    return document.objects.contains(id) && !locked(document, id);
}

void shade(gpu::Picture& picture, const ViewportStyle& style)
{
    constexpr float unseen = 0.003f; // picked, though less than what is drawn
    constexpr float glassy = 0.35f;
    const Shading& s = style.shading;
    picture.settings.wire = picture.settings.wire || s.edges || s.wireframe;
    if (s.wireframe) picture.edges = {style.edge_color, true};
    if (s.wireframe || s.see_through)
        for (gpu::Instance& instance : picture.instances)
            instance.opacity = s.wireframe ? unseen : glassy;
}

gpu::Picture picture_of(const Session& session, const Evaluation& seen, gpu::Level level,
                        const ViewportStyle& style, ShownValues& values)
{
    gpu::Picture picture =
        picture_of(seen, session.document(), session.view.camera, values, style.deform_by);
    gpu::set_level(picture, level);
    if (style.at_limits != 0) color_by_limits(picture, style.at_limits);
    leave_out(picture, session.hidden_here);
    outline_selected(picture, Members(session.document(), session.selected.ids()));
    for (gpu::Curve& curve : picture.curves) // the colours of levels stay as they are
        if (volume_of(session.document(), curve.id)) curve.highlighted = false;
    shade(picture, style);
    return picture;
}

// Returns the present sentence if it is not the one told before.
std::optional<std::string> news(std::string& said, const std::string& now)
{
    if (std::exchange(said, now) == now) return std::nullopt;
    return now;
}

DraftPace pace_of(double draft_ms)
{
    if (gpu::is_software()) return {draft_ms > 0 ? draft_ms : 60, gpu::Level::draft, 0.85};
    return {draft_ms > 0 ? draft_ms : 16, gpu::Level::standard};
}

} // namespace

Viewport::Viewport() : drawn_(std::make_unique<ViewportDrawn>()) {}
Viewport::~Viewport() = default;

unsigned Viewport::texture() const
{
    return drawn_->renderer ? drawn_->renderer->texture() : 0;
}
WayComparison& Viewport::ways()
{
    return drawn_->ways;
}
RefinedView& Viewport::refined()
{
    return drawn_->refined;
}
const LinesAtRest& Viewport::lines_at_rest() const
{
    return drawn_->lines_at_rest;
}
VolumeFacts& Viewport::volume_facts()
{
    return drawn_->volume_facts;
}
const ui::TimingHistory& Viewport::drafts() const
{
    return drawn_->drafts;
}
double Viewport::draft_scale() const
{
    return drawn_->pace ? drawn_->pace->scale() : 1;
}
const Timings& Viewport::full_timings() const
{
    return drawn_->full_timings;
}
const gpu::Renderer* Viewport::renderer() const
{
    return drawn_->renderer.get();
}
long Viewport::pictures() const
{
    return drawn_->pictures;
}

ViewportInput Viewport::take_input(Session& session, const ui::Frame& frame, const ui::Rect& rect,
                                   const Tool& tool)
{
    ViewportInput input;
    input.rect = rect;
    input.scale = frame.theme.scale;
    input.mouse = mouse_in(rect);
    input.hovered = ImGui::IsItemHovered();
    const glm::dvec2 drag = input.mouse - last_mouse_;
    last_mouse_ = input.mouse;
    const glm::dvec2 size_px(rect.size());
    if (session.view.go_to) {
        session.view.camera =
            ui::reshaped(*std::exchange(session.view.go_to, std::nullopt), size_px);
        session.view.follows.reset();
    }
    session.view.camera = followed(session.view.follows, session.document(), session.view.camera,
                                   size_px, session.view.picture_px);

    const ToolState at_work = tool.state();
    const bool moves_camera = emulates_middle() && !at_work.busy;
    if (ImGui::IsItemActive() && ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !moves_camera) {
        left_down_ = input.pressed = true;
        constexpr double curve_reach_px = 6; // beside which a thin line is still meant
        if (drawn_->renderer && drawn_->shown)
            input.under = drawn_->renderer->pick_near(glm::ivec2(input.mouse),
                                                      curve_reach_px * frame.theme.scale);
        if (!can_be_picked(session.document(), input.under)) input.under = 0;
    }
    input.seen_at = [this, &session](glm::dvec2 p_px) { // the picture may be behind the document
        const Id id = drawn_->renderer && drawn_->shown
                          ? drawn_->renderer->pick(glm::ivec2(glm::floor(p_px)))
                          : 0;
        return session.document().objects.contains(id) ? id : 0;
    };
    input.seen_in = [this, &session](glm::dvec2 lo, glm::dvec2 hi) {
        if (!drawn_->renderer || !drawn_->shown) return std::vector<Id>{};
        const glm::ivec2 first(glm::floor(lo)), last(glm::floor(hi));
        std::vector<Id> seen = drawn_->renderer->pick_in(first, last + 1);
        std::erase_if(seen, [&](Id id) { return !can_be_picked(session.document(), id); });
        return seen;
    };
    const bool was_down = left_down_;
    if (left_down_ && !ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
        left_down_ = false;
        input.released = true;
    }
    input.down = left_down_;
    input.double_clicked = input.pressed && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    for (const ui::Event& event : frame.events) {
        const bool move = event.kind == ui::Event::Kind::move;
        if ((move || event.kind == ui::Event::Kind::button) && event.time_s >= 0)
            hand_s_ = event.time_s;
        if (move && was_down && !input.pressed)
            input.moves.push_back({glm::dvec2(event.at) - glm::dvec2(rect.lo), event.time_s, 1});
    }
    if (input.pressed) input.moves.push_back({input.mouse, hand_s_, 1});
    input.wheel = static_cast<double>(ImGui::GetIO().MouseWheel);
    navigate(session, input, drag);
    if (!at_work.takes_wheel) scroll(session, frame, input);
    return input;
}

void Viewport::forget_gpu()
{
    drawn_->renderer.reset();
    drawn_->ways.forget_gpu();
    drawn_->pace.reset();
    drawn_->shown.reset();
    drawn_->begun.reset();
}

unsigned Viewport::draw(const Session& session, ui::Frame& frame, glm::ivec2 size_px, bool moving,
                        int state, const std::function<Helpers()>& helpers)
{
    constexpr double rest_s = 0.3; // so long nothing moves before a full picture is begun
    if (shader_folder_) {
        shaders_ = shader_folder_->texts(frame.time_s);
        frame.again_in(gpu::ShaderFolder::look_every_s);
    }
    drawn_->lines_at_rest.follow(
        {drawn_->refined.seen(), session.document(), session.view.camera, session.hidden_here},
        moving || move_ != Move::none, frame.time_s, drawn_->values.lines);
    if (const std::optional<double> soon = drawn_->lines_at_rest.again_in_s())
        frame.again_in(*soon);
    PictureInputs wanted{session.view.camera,
                         drawn_->refined.number(),
                         drawn_->lines_at_rest.number(),
                         session.selected,
                         session.hidden_here,
                         size_px,
                         state,
                         false,
                         session.shown().render.get(),
                         style_,
                         shaders_};
    const bool held = moving; // what ends that makes a frame of its own
    if (drawn_->shown) {      // what was drawn as a draft is compared without that
        PictureInputs before = *drawn_->shown;
        before.draft = false;
        before.lines = wanted.lines; // which come while all rests
        if (before != wanted) moving = true;
    }
    if (moving || move_ != Move::none) drawn_->moved_s = frame.time_s;
    wanted.draft = !drawn_->shown || frame.time_s - drawn_->moved_s < rest_s;
    if (wanted.draft && !held) frame.again_in(rest_s - (frame.time_s - drawn_->moved_s) + 0.01);
    // A full picture of the same thing does for a draft.
    PictureInputs as_full = wanted;
    as_full.draft = false;
    if (drawn_->shown && (*drawn_->shown == wanted || *drawn_->shown == as_full)) return texture();

    try {
        drawn_->trouble.clear();
        draw_wanted(wanted, session, frame, helpers);
    } catch (const std::exception& error) {
        drawn_->begun.reset();
        drawn_->shown = wanted; // it is not tried again till something is another
        if (is_mistake(error)) throw;
        drawn_->trouble = words_of(error);
    }
    return texture();
}

void Viewport::draw_wanted(const PictureInputs& wanted, const Session& session, ui::Frame& frame,
                           const std::function<Helpers()>& helpers)
{
    constexpr double budget_ms = 40; // in one frame, of a full picture: the mouse must not wait
    if (!drawn_->renderer) {
        drawn_->renderer = std::make_unique<gpu::Renderer>();
        drawn_->pace.reset();
    }
    if (!drawn_->pace) drawn_->pace = pace_of(style_.draft_ms);
    if (wanted.draft || drawn_->begun != wanted) {
        gpu::Picture picture =
            picture_of(session, drawn_->refined.seen(),
                       wanted.draft ? std::min(drawn_->pace->level(), style_.level) : style_.level,
                       style_, drawn_->values);
        picture.backdrop = style_.backdrop;
        picture.grid = style_.backdrop.has_value() && style_.grid;
        picture.outline = outline_for(picture, style_.outline);
        picture.shaders = shaders_;
        Helpers shown = helpers();
        std::ranges::move(shown.lines, std::back_inserter(picture.lines));
        std::ranges::move(shown.veils, std::back_inserter(picture.translucent));
        ++drawn_->pictures;
        drawn_->begun.reset();
        if (wanted.draft) {
            if (picture.draft) picture.scale = drawn_->pace->scale();
            drawn_->renderer->draw(picture, wanted.size_px);
            const bool first = std::exchange(drawn_->timed_evaluation, session.evaluation()) !=
                               session.evaluation();
            drawn_->drafts.add(
                {first ? session.evaluated().timings : Timings{}, drawn_->renderer->timings()});
            drawn_->pace->drew(ui::total_ms(drawn_->renderer->timings()), frame.time_s);
            drawn_->shown = wanted;
            return;
        }
        drawn_->renderer->begin(picture, wanted.size_px);
        drawn_->begun = wanted;
    }
    if (drawn_->renderer->advance(budget_ms)) {
        drawn_->full_timings = drawn_->renderer->timings();
        drawn_->begun.reset();
        drawn_->shown = wanted;
    } else {
        frame.again_in(0);
    }
}

void Viewport::set_style(const ViewportStyle& style)
{
    if (style.draft_ms != style_.draft_ms) drawn_->pace.reset();
    style_ = style;
}

std::string Viewport::new_notice()
{
    const std::string now = drawn_->renderer ? drawn_->renderer->notice() : "";
    return std::exchange(drawn_->said, now) == now ? "" : now;
}

std::optional<std::string> Viewport::new_trouble()
{
    return news(drawn_->said_of_trouble, drawn_->trouble);
}

std::optional<std::string> Viewport::new_shader_trouble()
{
    return news(drawn_->said_of_shaders,
                drawn_->renderer ? drawn_->renderer->shader_trouble() : "");
}

} // namespace trivar
