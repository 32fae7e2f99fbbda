// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/tetrahedra.h"
#include "ui/option_bar.h"
#include "ui/widgets.h"

#include <fmt/format.h>
#include <imgui.h>

namespace trivar {
namespace {

const TetrahedraShape* selected_shape(const Session& session)
{
    if (session.selected.size() != 1) return nullptr;
    const auto found = session.document().objects.find(session.selected);
    return found == session.document().objects.end()
               ? nullptr
               : std::get_if<TetrahedraShape>(&found->second->source);
}

// What came of the last edit; null: nothing did.
const TetrahedraOutcome* last_outcome(const Session& session, Id id)
{
    const auto found = session.evaluated().objects.find(id);
    if (found == session.evaluated().objects.end() || !found->second->tetrahedra ||
        found->second->tetrahedra->outcomes.empty())
        return nullptr;
    return &found->second->tetrahedra->outcomes.back();
}

} // namespace

void TetrahedraTool::options(Session& session, const ui::Theme& theme, float width)
{
    const TetrahedraShape* shape = selected_shape(session);
    if (!shape) {
        ui::option_bar(
            theme, {{"Select a volume of tetrahedra, or put one round objects", 1, [](float) {}}},
            width);
        return;
    }
    std::vector<ui::Option> options;
    options.push_back({"", 204,
                       [&](float field) {
                           int by = static_cast<int>(by_);
                           ui::segments(theme, "by", by, {"Pull", "Crease", "Refine"}, field);
                           by_ = static_cast<By>(by);
                       },
                       "Pull moves what the ball holds. Crease paints on faces between "
                       "tetrahedra how smoothly they meet, or cuts them. Refine lays smaller "
                       "tetrahedra along a stroke; the shape stays."});
    double shown_radius = radius(session);
    options.push_back({"Radius", 88,
                       [&](float field) {
                           if (ui::number_field(theme, "radius", shown_radius,
                                                {.lo = 0, .hi = 1e6, .unit = "m", .zero = "auto"},
                                                field) != ui::Edit::none)
                               radius_ = shown_radius;
                       },
                       "Of the ball or the brush, metres in the volume. The wheel changes it while "
                       "you pull."});
    if (by_ == By::pull) {
        options.push_back(
            {"Falloff", 104,
             [&](float field) {
                 int kind = static_cast<int>(decay_);
                 ui::choice(theme, "decay", kind, {"Gaussian", "Hat", "Box", "Smooth"}, field);
                 decay_ = static_cast<Decay>(kind);
             },
             "How the pull falls off from the ball's middle to its rim."});
        options.push_back({"Guard", 20, [&](float) { ui::check_box(theme, "guard", guard_, ""); },
                           "Stops the pull before the volume would fold."});
    }
    if (by_ == By::crease)
        options.push_back({"Meet", 88 + 44 * static_cast<float>(shape->degree),
                           [&](float field) {
                               std::vector<std::string> names;
                               for (int depth = 1; depth < shape->degree; ++depth)
                                   names.push_back(fmt::format("C{}", shape->degree - 1 - depth));
                               names.emplace_back("Cut");
                               int at = std::min(depth_, shape->degree) - 1;
                               ui::segments(theme, "depth", at, names, field);
                               depth_ = at + 1;
                           },
                           "C0: faces meet with a crease. Cut: they part where you pull."});
    ui::option_bar(theme, options, width);
}

void TetrahedraTool::overlay(const Session& session, const ui::Theme& theme,
                             const ViewportInput& input) const
{
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
        const double metres = glm::length(edit.pull->by) * out->share;
        ui::paint_chip(theme, at,
                       {fmt::format("{:.3g} m", metres) +
                            (out->share < 1 ? fmt::format(", held at {:.0f} %: it would fold",
                                                          100 * out->share)
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
    if (!selected_shape(session))
        return {{{"left"}, "Select tetrahedra, or what stands in them"}, {{"Esc"}, "Select"}};
    const char* const verbs[]{"Drag to pull", "Draw over faces", "Draw a stroke"};
    return {{{"left"}, verbs[static_cast<int>(by_)]}, {{"middle"}, "Orbit"}, {{"Esc"}, "Select"}};
}

} // namespace trivar
