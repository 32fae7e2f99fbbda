// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/number_text.h"
#include "editor/hands/falloff_option.h"
#include "editor/hands/shown_tetrahedra.h"
#include "editor/hands/viewport_input.h"
#include "editor/tools/tetrahedra/tetrahedra.h"
#include "ui/option_bar.h"
#include "ui/widgets.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>

namespace trivar {
namespace {

const TetrahedraShape* selected_shape(const Session& session)
{
    return session.selected.size() == 1 ? tetrahedra_shape(session.document(), session.selected)
                                        : nullptr;
}

void paint_words(const ui::Theme& theme, float field, const std::string& words)
{
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ui::name_text(theme.font.body, ui::rect_at({at.x, at.y}, {field, theme.size.row}),
                  theme.color.text_2, words);
}

// Returns the word for how faces meet; the third degree has one more word in between.
const char* crease_word(int depth, int degree)
{
    if (depth == 0) return "Smooth";
    return depth == degree - 1 ? "Crease" : "Soft";
}

} // namespace

void TetrahedraTool::around_options(Session& session, const ui::Theme& theme, float width)
{
    std::vector<ui::Option> options;
    if (session.selected == 0) {
        options.push_back(
            {"Select a volume of tetrahedra, or objects to put one round", 1, [](float) {}});
        return ui::option_bar(theme, options, width);
    }
    options.push_back(ui::enum_option(
        ui::choice, theme, "Around", 104, "around", around_, {"Box", "Fitted", "Hull", "Cage"},
        "Tetrahedra bend objects as a lattice does, and can be fine in one place alone, have "
        "creases and open along cuts. A box; about 2,000 that follow the shape, or fill its "
        "convex "
        "hull; or those that fill the active object, a closed mesh, exactly."));
    options.push_back({"", 190,
                       [&](float field) {
                           if (ui::button(theme, tetrahedra_action, ui::ButtonKind::plain,
                                          {field, theme.size.row}))
                               put_tetrahedra_round_selection(session, around_);
                       },
                       "Puts tetrahedra round the selected objects that bend them."});
    ui::option_bar(theme, options, width);
}

void TetrahedraTool::add_layer_option(std::vector<ui::Option>& options, const ui::Theme& theme,
                                      const TetrahedraShape& shape)
{
    const auto refinements = std::ranges::count_if(
        shape.edits, [](const TetrahedraEdit& edit) { return edit.refinement.has_value(); });
    if (refinements == 0) return;
    options.push_back({"Of", 112,
                       [this, &theme, refinements](float field) {
                           std::vector<std::string> names{"Domain"};
                           for (int i = 1; i <= refinements; ++i)
                               names.push_back(fmt::format("Refinement {}", i));
                           int layer = points_.layer();
                           ui::choice(theme, "layer", layer, names, field);
                           points_.choose_layer(layer);
                       },
                       "Whose control points are shown."});
}

void TetrahedraTool::add_ball_options(std::vector<ui::Option>& options, const ui::Theme& theme,
                                      const Session& session)
{
    shown_radius_ = radius(session);
    options.push_back({"Radius", 88,
                       [&](float field) {
                           if (ui::number_field(theme, "radius", shown_radius_,
                                                {.lo = 0, .hi = 1e6, .unit = "m", .zero = "auto"},
                                                field) != ui::Edit::none)
                               ball_.radius = shown_radius_;
                       },
                       "Of the ball or the brush, metres in the volume. The wheel changes it while "
                       "you pull."});
    if (by_ != By::pull && by_ != By::points) return;
    options.push_back(falloff_option(theme, ball_.decay,
                                     "How the pull falls off from the ball's middle to its rim."));
}

void TetrahedraTool::options(Session& session, const ui::Theme& theme, float width)
{
    const TetrahedraShape* shape = selected_shape(session);
    if (!shape) return around_options(session, theme, width);
    std::vector<ui::Option> options;
    options.push_back(
        {"", 104,
         [&](float field) {
             int by = static_cast<int>(by_);
             ui::choice(theme, "by", by, {"Pull", "Points", "Crease", "Refine", "Knots"}, field);
             if (!busy()) by_ = static_cast<By>(by);
         },
         "Pull moves what the ball holds, Points the control points that you choose. "
         "Crease paints on faces how smoothly they meet, or cuts them. Refine lays "
         "smaller tetrahedra along a stroke. Knots moves those of a vertex."});
    if (by_ == By::points) {
        add_layer_option(options, theme, *shape);
        points_.add_proportional_option(options, theme);
    }
    if (by_ != By::knots && (by_ != By::points || *points_.proportional()))
        add_ball_options(options, theme, session);
    if (by_ == By::pull || by_ == By::points)
        options.push_back(ui::check_option(theme, "Guard", "guard", ball_.guard,
                                           "Stops the pull before the volume would fold."));
    if (by_ == By::points)
        options.push_back({"Selected", 96,
                           [&](float field) { paint_words(theme, field, points_.words()); },
                           "Control points, of those that can be moved."});
    if (by_ == By::crease)
        options.push_back({"Meet", 64 + 64 * static_cast<float>(shape->degree),
                           [&](float field) {
                               std::vector<std::string> names;
                               for (int depth = 0; depth < shape->degree; ++depth)
                                   names.push_back(crease_word(depth, shape->degree));
                               names.emplace_back("Cut");
                               int depth = std::min(depth_, shape->degree);
                               ui::segments(theme, "depth", depth, names, field);
                               depth_ = depth;
                           },
                           "Crease: faces meet with an edge. Cut: they part where you pull. Smooth "
                           "takes away creases and cuts."});
    if (const auto room = clouds_.room(); by_ == By::knots && room)
        options.push_back(
            {"Room", 56, [&, room](float field) { paint_words(theme, field, percent_text(*room)); },
             "What the knots here leave of the least tetrahedron, in shares of it. "
             "At 5 % a drag stops: at 0 the clouds cross."});
    ui::option_bar(theme, options, width);
}

void TetrahedraTool::overlay(const Session& session, const ui::Theme& theme,
                             const ViewportInput& input) const
{
    if (inner()) return inner()->overlay(session, theme, input);
    if (!at_ && !gesture_) return;
    const Camera& camera = session.view.camera;
    const glm::vec2 mouse = input.rect.lo + glm::vec2(input.mouse);
    if (!gesture_) {
        const PicturePoint at = project(camera, at_->world);
        const auto found = session.evaluated().objects.find(session.selected);
        if (at.depth_world <= 0 || found == session.evaluated().objects.end()) return;
        const double metres =
            radius(session) * glm::length(glm::dvec3(found->second->tetrahedra_to_world[0]));
        ui::paint_ball(mouse, static_cast<float>(metres / pixel_size_world(camera, at.depth_world)),
                       theme.color.sphere, theme.line(1.6f));
        return;
    }
    const glm::vec2 at = mouse + glm::vec2(theme.px(18), -theme.px(30));
    const TetrahedraOutcome* out =
        session.proposing() ? last_outcome(session, gesture_->object) : nullptr;
    if (!out) return;
    const TetrahedraEdit& edit = gesture_->edit;
    if (edit.pull) {
        const double metres = glm::length(edit.pull->by) * gesture_->carried * out->share;
        ui::paint_chip(theme, at,
                       {fmt::format("{} m", number_text(metres)) +
                            (out->share < 1 ? fmt::format(", held at {}: it would fold",
                                                          percent_text(out->share))
                                            : ""),
                        out->share < 1 ? theme.color.bad : ui::Color{0}});
    } else
        ui::paint_chip(
            theme, at,
            {words_of(edit, selected_shape(session) ? selected_shape(session)->degree : 2)});
}

std::vector<Hint> TetrahedraTool::hints(const Session& session) const
{
    if (gesture_)
        return {{{"left"}, "Let go when done"}, {{"wheel"}, "Radius"}, {{"Esc"}, "Cancel"}};
    if (selected_shape(session) && inner()) return inner()->hints(session);
    if (!selected_shape(session))
        return {{{"left"}, "Select tetrahedra, or what stands in them"}, {{"Esc"}, "Select"}};
    const char* const verb = by_ == By::pull     ? "Drag to pull"
                             : by_ == By::crease ? "Draw over faces"
                                                 : "Draw a stroke";
    return {{{"left"}, verb}, {{"middle"}, "Orbit"}, {{"Esc"}, "Select"}};
}

} // namespace trivar
