// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/split/split.h"

#include "core/base/rejected.h"
#include "core/base/rounded.h"
#include "core/document/parameters.h"
#include "editor/hands/helpers.h"
#include "editor/hands/select.h"
#include "editor/hands/viewport_input.h"
#include "editor/session/scene_names.h"
#include "editor/session/session.h"
#include "editor/session/topics.h"
#include "editor/tools/split/cut_picture.h"
#include "editor/tools/split/split_handles.h"
#include "editor/tools/split/split_picture.h"
#include "ui/option_bar.h"
#include "ui/widgets.h"

#include <algorithm>

namespace trivar {
namespace {

const EvaluatedObject* shown_object(const Session& session, Id id)
{
    const auto found = session.evaluated().objects.find(id);
    return found == session.evaluated().objects.end() ? nullptr : found->second.get();
}

// Shares of an object's size that suit it, where no number was typed.
constexpr double usual_gap = 0.05, usual_clearance = 3e-3, usual_tolerance = 5e-4;
double share_of_size(const Session& session, Id id, double share)
{
    const EvaluatedObject* shown = shown_object(session, id);
    const double size = shown && !shown->bounds->empty() ? glm::length(shown->bounds->size()) : 1;
    return std::max(rounded(share * size, 1), 1e-12);
}

// Returns the direction that stays upright while an obstacle parts something: the length of a bar,
// or else up.
glm::dvec3 upright_of(const glm::dvec3& size)
{
    constexpr double long_for_a_bar = 2.5; // times its other sides
    if (size.x > long_for_a_bar * std::max(size.y, size.z)) return {1, 0, 0};
    if (size.y > long_for_a_bar * std::max(size.x, size.z)) return {0, 1, 0};
    return {0, 0, 1};
}

// Returns how an object moves past another one from the first frame to the last; zero: it does not.
glm::dvec3 way_past(const Document& document, Id id, Id other)
{
    const auto apart = [&](int frame) {
        const Document then = document_at(document, frame);
        return glm::dvec3(to_world(then, id)[3]) - glm::dvec3(to_world(then, other)[3]);
    };
    return apart(document.time.last_frame) - apart(document.time.first_frame);
}

glm::dvec3 rounded_direction(const glm::dvec3& d)
{
    return {rounded(d.x, 4), rounded(d.y, 4), rounded(d.z, 4)};
}

// Sets the directions of an object that meets an obstacle.
void give_directions(const Session& session, Id id, Id obstacle, Splitting& splitting)
{
    const EvaluatedObject *own = shown_object(session, id),
                          *other = shown_object(session, obstacle);
    if (!own || !other) return;
    const glm::dvec3 upright = upright_of(other->bounds->size());
    const auto level = [&](const glm::dvec3& d) { return d - upright * glm::dot(upright, d); };
    const double size = glm::length(own->bounds->size());
    glm::dvec3 way = level(way_past(session.document(), id, obstacle));
    // An object that does not move goes toward the obstacle; one that stands in it, away from the
    // eye
    if (glm::length(way) < 1e-3 * size)
        way = level(other->bounds->center() - own->bounds->center());
    if (glm::length(way) < 0.05 * size)
        way = level(session.view.camera.target - session.view.camera.eye);
    if (glm::length(way) < 1e-9) way = glm::dvec3(upright.y, upright.z, upright.x);
    splitting.way = rounded_direction(glm::normalize(way));
    splitting.opening = rounded_direction(glm::normalize(glm::cross(way, upright)));
}

} // namespace

std::optional<Split> split_at(const Session& session, const std::vector<Id>& objects, Id obstacle,
                              std::string* why)
{
    if (objects.empty() || obstacle == 0) return {};
    Split out{objects, {}};
    const Object& first = object(session.document(), objects.front());
    if (first.splitting) {
        out.splitting = *first.splitting;
    } else {
        give_directions(session, objects.front(), obstacle, out.splitting);
        out.splitting.tolerance = share_of_size(session, objects.front(), usual_tolerance);
    }
    std::erase_if(out.splitting.obstacles,
                  [&](const ObstacleUse& each) { return each.object == obstacle; });
    out.splitting.obstacles.push_back(
        {.object = obstacle,
         .clearance = share_of_size(session, objects.front(), usual_clearance)});
    try {
        for (const Id id : objects) check_splitting(session.document(), id, out.splitting);
    } catch (const Rejected& error) {
        if (why) *why = error.what();
        return {};
    }
    return out;
}

ToolState SplitTool::state() const
{
    const bool handled = handles_.hovers() || handles_.busy();
    return {.busy = cut_.going() || handles_.busy(),
            .crosshair = at_ != SplitAt::obstacle && !handled,
            .mode = static_cast<int>(at_)};
}

std::vector<Id> SplitTool::chosen(const Session& session)
{
    std::vector<Id> out;
    for (const Id id : session.selected.ids())
        if (session.document().objects.contains(id) && kind_of(session.document(), id).has_surface)
            out.push_back(id);
    return out;
}

std::vector<Handle> SplitTool::handles(const Session& session, double scale) const
{
    return at_ == SplitAt::obstacle ? opening_handles(session, scale) : cut_handles(session, scale);
}

void SplitTool::use(Session& session, const ViewportInput& input)
{
    if (!cut_.going() && !rests(session, input) &&
        handles_.use(session, input, handles(session, input.scale))) {
        if (shown_ != 0) { // an obstacle behind the handle, before it
            shown_ = 0;
            if (!handles_.busy()) session.cancel();
        }
        return;
    }
    if (at_ == SplitAt::obstacle) return use_obstacles(session, input);
    if (!cut_.going()) {
        if (!input.pressed || session.committing()) return;
        if (!cut_.begin(session, input, at_ == SplitAt::plane))
            return select_by_click(session, input.under);
    }
    Cutting settings;
    settings.capped = settings_.closing != SplitClosing::open;
    settings.inside = settings_.inside;
    settings.tolerance = share_of_size(session, session.selected, usual_tolerance / 2);
    one_.gap = gap_.value_or(share_of_size(session, session.selected, usual_gap));
    cut_.go_on(session, input, one_, settings);
}

void SplitTool::use_obstacles(Session& session, const ViewportInput& input)
{
    if (session.committing()) return;
    const std::vector<Id> objects = chosen(session);
    const Id seen = input.hovered && input.seen_at ? input.seen_at(input.mouse) : Id{0};
    const bool other = seen != 0 && std::ranges::find(objects, seen) == objects.end();
    // The result is proposed while the mouse rests on an obstacle
    if (shown_ != 0 && (!other || seen != shown_) && !rests(session, input) && !input.pressed) {
        shown_ = 0;
        session.cancel();
    }
    const auto with_settings = [&](Split command) {
        ObstacleUse& last = command.splitting.obstacles.back();
        last = {last.object, clearance_.value_or(last.clearance), use_.reach, use_.kernel};
        command.splitting.closing = settings_.closing;
        command.splitting.inside = settings_.inside;
        return command;
    };
    if (input.pressed) {
        if (objects.empty() || !other) {
            cancel(session);
            select_by_click(session, input.under);
            return;
        }
        cancel(session);
        std::string why;
        const std::optional<Split> command = split_at(session, objects, seen, &why);
        if (!command)
            session.notices.say(ui::NoticeKind::warning, "This cannot part it", why, of_a_step);
        else if (session.propose(with_settings(*command)))
            session.commit();
        return;
    }
    if (shown_ != 0 || !other || objects.empty() || !session.up_to_date()) return;
    if (const std::optional<Split> command = split_at(session, objects, seen)) {
        shown_ = seen;
        shown_for_ = {input.mouse, session.view.camera};
        session.propose_quietly(with_settings(*command));
    }
}

void SplitTool::cancel(Session& session)
{
    cut_.cancel(session);
    handles_.cancel(session);
    if (shown_ == 0) return;
    shown_ = 0;
    session.cancel();
}

void SplitTool::overlay(const Session& session, const ui::Theme& theme,
                        const ViewportInput& input) const
{
    cut_.paint(theme, input);
    if (!cut_.going()) handles_.paint(theme, input, handles(session, input.scale));
}

Helpers SplitTool::helpers(const Session& session, const ui::Theme& theme) const
{
    Helpers out;
    const auto add = [&](std::vector<gpu::Line> lines, std::vector<gpu::Translucent> veils) {
        std::ranges::move(lines, std::back_inserter(out.lines));
        std::ranges::move(veils, std::back_inserter(out.veils));
    };
    const std::vector<Id> ids = chosen(session);
    for (const Id id : ids)
        if (const EvaluatedObject* each = shown_object(session, id); each && each->split_field)
            add(lines_of(*each->split_field, theme), walls_of(*each->split_field, theme));
    for (const Id id : ids) {
        const EvaluatedObject* each = shown_object(session, id);
        const std::optional<Cutting>& cutting = object(session.document(), id).cutting;
        if (at_ != SplitAt::obstacle && each && cutting)
            add(borders_of(*each, *cutting, theme), sheets_of(*each, *cutting, theme));
    }
    return out;
}

void SplitTool::set_at(Session& session, SplitAt at)
{
    if (at == at_) return;
    cancel(session);
    at_ = at;
}

void SplitTool::options(Session& session, const ui::Theme& theme, float width)
{
    std::vector<ui::Option> options;
    options.push_back({"At", 108,
                       [&](float field) {
                           int at = static_cast<int>(at_);
                           ui::choice(theme, "at", at, {"Obstacle", "Plane", "Stroke"}, field);
                           set_at(session, static_cast<SplitAt>(at));
                       },
                       "Split it round an obstacle, or cut it along a line or a stroke."});
    if (at_ == SplitAt::obstacle)
        add_obstacle_options(options, session, theme);
    else
        add_cut_options(options, session, theme);
    options.push_back(ui::enum_option(ui::choice, theme, "Inside", 84, "inside", settings_.inside,
                                      {"None", "Wood", "Flesh", "Metal"},
                                      "What fills it, seen where it opens."));
    ui::option_bar(theme, options, width);
}

void SplitTool::add_obstacle_options(std::vector<ui::Option>& options, const Session& session,
                                     const ui::Theme& theme)
{
    options.push_back({"Clearance", 84,
                       [&](float field) {
                           double clearance = clearance_.value_or(
                               share_of_size(session, session.selected, usual_clearance));
                           if (ui::number_field(theme, "clearance", clearance,
                                                {.lo = 0, .unit = "m"}, field) != ui::Edit::none)
                               clearance_ = clearance;
                       },
                       "How much stays free round the obstacle."});
    options.push_back({"Reach", 84,
                       [&](float field) {
                           ui::number_field(theme, "reach", use_.reach,
                                            {.lo = 0, .unit = "m", .zero = "as needed"}, field);
                       },
                       "Over what distance the opening fades away."});
    options.push_back(ui::enum_option(
        ui::choice, theme, "Falloff", 100, "fades", use_.kernel,
        {"Soft", "Smooth", "Sharp", "Linear"},
        "How the opening fades with the distance from the obstacle; linear needs the least "
        "room."));
    options.push_back(ui::enum_option(
        ui::choice, theme, "Closing", 100, "closing", settings_.closing,
        {"Open", "Capped", "Stitched"},
        "Cap both halves, so that they stay solid, or stitch the skin together beside the "
        "obstacle."));
}

void SplitTool::add_cut_options(std::vector<ui::Option>& options, const Session& session,
                                const ui::Theme& theme)
{
    options.push_back(ui::enum_option(
        ui::choice, theme, "Keep", 112, "keep", one_.keep, {"Both parts", "Above", "Below"},
        "Which part to keep; \"Above\" is the part above the line as drawn."));
    options.push_back(
        {"Gap", 84,
         [&](float field) {
             double gap = gap_.value_or(share_of_size(session, session.selected, usual_gap));
             if (ui::number_field(theme, "gap", gap, {.unit = "m"}, field) != ui::Edit::none)
                 gap_ = gap;
         },
         "How far both parts stand apart."});
    options.push_back({"Closed", 24,
                       [&](float) {
                           bool closed = settings_.closing != SplitClosing::open;
                           if (ui::check_box(theme, "closed", closed, "") != ui::Edit::none)
                               settings_.closing =
                                   closed ? SplitClosing::capped : SplitClosing::open;
                       },
                       "Close both halves, so that they stay solid."});
}

std::vector<Hint> SplitTool::hints(const Session& session) const
{
    if (cut_.going()) return {{{"left"}, "Let go when done"}, {{"Esc", "/", "right"}, "Cancel"}};
    if (handles_.busy() || handles_.hovers()) return handles_.hints();
    if (chosen(session).empty())
        return {{{"left"}, "Select the object to split"}, {{"Esc"}, "Select"}};
    const char* verb = at_ == SplitAt::obstacle ? "Click an obstacle"
                       : at_ == SplitAt::plane  ? "Drag a line across it"
                                                : "Draw across it";
    return {{{"left"}, verb}, {{"middle"}, "Orbit"}, {{"Esc"}, "Select"}};
}

} // namespace trivar
