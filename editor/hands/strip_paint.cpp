// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/strip_paint.h"

#include "core/base/number_text.h"
#include "editor/hands/viewport_input.h"
#include "gpu/picture.h"
#include "ui/paint.h"
#include "ui/theme.h"

#include <algorithm>
#include <array>
#include <map>

namespace trivar {
namespace {

enum class NodeState { touches, bridges, missed, uneven, folds };
constexpr double uneven = 1.5; // times the area asked for, or that part of it: seen in a pattern

NodeState state_of(const StripNode& node)
{
    if (node.folds) return NodeState::folds;
    if (node.contact == Contact::missed) return NodeState::missed;
    if (node.spread > uneven || node.spread < 1 / uneven) return NodeState::uneven;
    return node.contact == Contact::touches ? NodeState::touches : NodeState::bridges;
}

struct NodeLook {
    const char* words;
    ui::Color color;
    float share; // of the light
};
NodeLook shown(const ui::Theme& theme, NodeState state)
{
    const ui::Palette& c = theme.color;
    switch (state) {
    case NodeState::touches: return {"in contact", c.stroke, 0.15f};
    case NodeState::bridges: return {"bridged", c.free_node, 0.1f};
    case NodeState::missed: return {"unsupported", c.axis_z, 0.3f};
    case NodeState::uneven: return {"stretched or squeezed", c.bad, 0.25f};
    case NodeState::folds: return {"folded", c.bad_fill, 0.8f};
    }
    return {"", 0, 0};
}

} // namespace

gpu::Translucent strip_veil(const Placement& placement, const ui::Theme& theme)
{
    constexpr double over = 0.02; // of the height, so that the scene does not show through
    gpu::Translucent veil;
    const auto columns = static_cast<std::uint32_t>(placement.node_columns);
    if (columns < 2) return veil;
    const std::array<Knots, 2>& axes = placement.contact.axes;
    for (std::uint32_t k = 0; k < placement.nodes.size(); ++k) {
        const std::uint32_t i = k / columns, j = k % columns;
        const glm::dvec3 uvw(axes[0].greville(static_cast<int>(i)),
                             axes[1].greville(static_cast<int>(j)), placement.ground + over);
        veil.points.emplace_back(evaluate(placement.volume, uvw).value);
        const NodeLook state = shown(theme, state_of(placement.nodes[k]));
        veil.colors.push_back(ui::linear_light(ui::faded(state.color, state.share)));
        if (i == 0 || j == 0) continue;
        const std::uint32_t a = k - columns - 1, b = k - 1, c = k - columns;
        veil.triangles.insert(veil.triangles.end(), {a, b, k, a, k, c});
    }
    return veil;
}

void paint_nodes(const ui::Theme& theme, const ViewportInput& input, const Camera& camera,
                 const Placement& placement, Nodes which)
{
    constexpr float apart_px = 14; // closer dots would hide the model
    const int columns = placement.node_columns;
    if (columns < 1) return;
    const float px = theme.scale;
    std::map<int, glm::vec2> last; // dot of a column
    for (std::size_t k = 0; k < placement.nodes.size(); ++k) {
        const int column = static_cast<int>(k) % columns;
        const StripNode& node = placement.nodes[k];
        // The rims and the middle say enough; all of them would hide the model.
        const bool middle = column == columns / 2;
        if (column != 0 && column != columns - 1 && !middle && !node.folds) continue;
        const PicturePoint p = project(camera, node.p_world);
        if (p.depth_world <= 0) continue;
        const glm::vec2 at = input.rect.lo + glm::vec2(p.p_px);
        if (!node.folds) {
            if (which == Nodes::trouble && node.contact != Contact::missed) continue;
            const auto [before, first] = last.try_emplace(column, at);
            if (!first && glm::distance(before->second, at) < apart_px * px) continue;
            before->second = at;
        }
        if (node.folds) {
            for (const glm::vec2 arm : {glm::vec2(4, 4), {4, -4}}) {
                ui::paint_line(at - arm * px, at + arm * px, theme.color.halo, 4 * px);
                ui::paint_line(at - arm * px, at + arm * px, theme.color.bad, 2 * px);
            }
        } else if (node.contact == Contact::touches)
            ui::paint_dot(at, 2.2f * px, theme.color.stroke);
        else
            ui::paint_dot(at, 2.6f * px, theme.color.halo,
                          node.contact == Contact::bridges ? theme.color.free_node
                                                           : theme.color.text_3,
                          1.3f * px);
    }
}

glm::vec2 strip_legend_at(const ui::Theme& theme, const ui::Rect& picture)
{
    // Under the buttons of navigation: below are notices, at the left what can be adjusted.
    return {picture.hi.x - theme.px(196), picture.lo.y + theme.px(188)};
}

void paint_strip_legend(const ui::Theme& theme, const ui::Rect& picture, const Placement& placement)
{
    std::array<std::size_t, 5> count{};
    for (const StripNode& node : placement.nodes)
        ++count.at(static_cast<std::size_t>(state_of(node)));
    glm::vec2 at = strip_legend_at(theme, picture);
    for (std::size_t i = count.size(); i-- > 0;) {
        if (count.at(i) == 0) continue;
        const NodeLook state = shown(theme, static_cast<NodeState>(i));
        const double share =
            static_cast<double>(count.at(i)) / static_cast<double>(placement.nodes.size());
        ui::paint_chip(theme, at,
                       {percent_text(std::max(0.01, share)) + " " + state.words, state.color});
        at.y += theme.px(28);
    }
}

} // namespace trivar
