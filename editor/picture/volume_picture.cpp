// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/picture/volume_picture.h"

#include "core/mesh/primitives.h"
#include "editor/picture/volume_facts.h"
#include "editor/picture/volume_surface.h"

#include <algorithm>
#include <iterator>

namespace trivar {

std::vector<gpu::Line> placement_lines(const Placement& placement, const ui::Palette& color,
                                       float line_px)
{
    std::vector<gpu::Line> lines;
    // Along the twelve edges of the volume, and every tenth of the way round it.
    const auto add = [&](glm::dvec3 from, glm::dvec3 to, int steps, float alpha, float width) {
        gpu::Line line{{}, ui::linear_light(ui::faded(color.lattice, alpha)), width * line_px};
        for (int i = 0; i <= steps; ++i) {
            const glm::dvec3 uvw = glm::mix(from, to, static_cast<double>(i) / steps);
            line.points.emplace_back(evaluate(placement.volume, uvw).value);
        }
        lines.push_back(std::move(line));
    };
    for (const glm::dvec2 vw : {glm::dvec2(0, 0), {1, 0}, {0, 1}, {1, 1}})
        add({0, vw.x, vw.y}, {1, vw.x, vw.y}, 96, 0.95f, 1.6f);
    constexpr int ribs = 10;
    for (int i = 0; i <= ribs; ++i) {
        const double u = static_cast<double>(i) / ribs;
        const bool end = i == 0 || i == ribs;
        const float alpha = end ? 0.95f : 0.32f, width = end ? 1.6f : 1.0f;
        add({u, 0, 0}, {u, 1, 0}, 12, alpha, width);
        add({u, 0, 1}, {u, 1, 1}, 12, alpha, width);
        add({u, 0, 0}, {u, 0, 1}, 8, alpha, width);
        add({u, 1, 0}, {u, 1, 1}, 8, alpha, width);
    }
    if (placement.strip.empty()) return lines;
    gpu::Line stroke{{}, ui::linear_light(color.stroke), 2 * line_px};
    stroke.points.assign(placement.strip.front().begin(), placement.strip.front().end());
    lines.push_back(std::move(stroke));
    return lines;
}

std::vector<gpu::Line> shell_lines(const Lattice& volume, ui::Color color, float line_px,
                                   const ShellLook& look)
{
    std::vector<gpu::Line> out;
    const std::array<Knots, 3>& axes = volume.displacement.axes;
    const glm::ivec3 n(axes[0].count(), axes[1].count(), axes[2].count());
    const auto at_end = [](int i, int count) { return i == 0 || i == count - 1; };
    const auto add = [&](int along, glm::ivec3 at, float alpha, float width) {
        if (alpha <= 0) return;
        gpu::Line line{{}, ui::linear_light(ui::faded(color, alpha)), width * line_px};
        for (int k = 0; k < n[along]; ++k) {
            at[along] = k;
            line.points.emplace_back(control_point(volume, at.x, at.y, at.z));
        }
        out.push_back(std::move(line));
    };
    for (int along = 0; along < 3; ++along) {
        const int s = (along + 1) % 3, t = (along + 2) % 3;
        for (int i = 0; i < n[s]; ++i)
            for (int j = 0; j < n[t]; ++j) {
                glm::ivec3 at(0);
                at[s] = i;
                at[t] = j;
                if (at_end(i, n[s]) && at_end(j, n[t]))
                    add(along, at, look.edges, 1.5f);
                else if (at_end(i, n[s]) || at_end(j, n[t]))
                    add(along, at, look.sides, 1);
            }
    }
    return out;
}

gpu::Translucent shell_veil(const Lattice& volume, const ui::Palette& color)
{
    return veil_of(volume_surface(volume), ui::faded(color.lattice_fill, 0.25f));
}

gpu::Translucent placement_veil(const Placement& placement, const ui::Palette& color)
{
    return veil_of(volume_surface(placement.volume), color.lattice_fill);
}

namespace {

void add_ball(gpu::Translucent& veil, const Mesh& ball, const glm::dvec3& center, double radius)
{
    const auto first = static_cast<std::uint32_t>(veil.points.size());
    veil.normals.insert(veil.normals.end(), ball.normals.begin(), ball.normals.end());
    for (const glm::vec3& p : ball.positions)
        veil.points.emplace_back(center + radius * glm::dvec3(p));
    for (std::size_t f = 0; f + 1 < ball.face_begin.size(); ++f)
        for (std::uint32_t c = ball.face_begin[f] + 2; c < ball.face_begin[f + 1]; ++c)
            for (const std::uint32_t corner :
                 {ball.corners[ball.face_begin[f]], ball.corners[c - 1], ball.corners[c]})
                veil.triangles.push_back(first + corner);
}

// The control points of the outer faces, as small balls.
gpu::Translucent shell_points(const Lattice& volume, const ui::Palette& color)
{
    static const Mesh ball = sphere_mesh(1, 12, 6);
    constexpr double share = 0.006; // of the box
    const double radius = share * glm::length(glm::dvec3(glm::dmat3(volume.rest) * glm::dvec3(1)));
    const std::array<Knots, 3>& axes = volume.displacement.axes;
    const glm::ivec3 last = glm::ivec3(axes[0].count(), axes[1].count(), axes[2].count()) - 1;
    gpu::Translucent veil;
    veil.colors = {ui::linear_light(color.lattice)};
    for (int i = 0; i <= last.x; ++i)
        for (int j = 0; j <= last.y; ++j)
            for (int k = 0; k <= last.z; ++k)
                if (i % last.x == 0 || j % last.y == 0 || k % last.z == 0)
                    add_ball(veil, ball, control_point(volume, i, j, k), radius);
    return veil;
}

} // namespace

gpu::Translucent ball_veil(const glm::dvec3& center, double radius, const ui::Palette& color)
{
    static const Mesh ball = sphere_mesh(1, 48, 24);
    gpu::Translucent veil;
    veil.colors = {ui::linear_light(ui::faded(color.sphere, 0.36f))};
    add_ball(veil, ball, center, radius);
    return veil;
}

std::vector<gpu::Translucent> balls_of(const Press& press, const Lattice& volume,
                                       const ui::Palette& color)
{
    const glm::dvec3 uvw(press.samples.back());
    std::vector<gpu::Translucent> out{ball_veil(evaluate(volume, uvw).value, press.radius, color)};
    if (press.mirror)
        out.push_back(
            ball_veil(evaluate(volume, {uvw.x, 1 - uvw.y, uvw.z}).value, press.radius, color));
    return out;
}

void add_volumes(gpu::Picture& picture, const Evaluation& evaluated, const Document& document,
                 TetrahedraLines& tetrahedra, const ui::Palette& color, float line_px)
{
    std::vector<const Lattice*> drawn;
    for (const auto& [id, each] : evaluated.objects) {
        std::ranges::copy(tetrahedra(*each, color, line_px, true),
                          std::back_inserter(picture.lines));
        const auto own = document.objects.find(id);
        if (!each->placement || own == document.objects.end()) continue; // or deleted since
        const Lattice& volume = each->placement->volume;
        // Objects that lie in one volume, one behind the other, show it once.
        if (std::ranges::any_of(drawn, [&](const Lattice* other) { return *other == volume; }))
            continue;
        drawn.push_back(&volume);
        const bool box = is_lattice(document, id);
        const Ref<Lattice> cage = each->seen_cage();
        std::ranges::move(box ? shell_lines(*cage, color.lattice, line_px)
                              : placement_lines(*each->placement, color, line_px),
                          std::back_inserter(picture.lines));
        picture.translucent.push_back(box ? shell_veil(*cage, color)
                                          : placement_veil(*each->placement, color));
        if (box) picture.translucent.push_back(shell_points(*cage, color));
        std::ranges::move(fold_veils(*each, color), std::back_inserter(picture.translucent));
        const std::vector<Ref<VolumeEdit>>& steps = own->second->shaping;
        if (!steps.empty() && steps.back()->press)
            std::ranges::move(balls_of(*steps.back()->press, volume, color),
                              std::back_inserter(picture.translucent));
    }
}

} // namespace trivar
