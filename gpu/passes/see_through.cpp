// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/passes/layers.h"

#include "core/base/finite.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <epoxy/gl.h>

namespace trivar::gpu {
namespace {

struct Point {
    glm::vec3 p, normal;
    glm::vec4 color;
};

glm::vec4 color_of(const Translucent& veil, std::size_t point)
{
    if (veil.colors.empty()) return {1, 1, 1, 0.1f};
    return veil.colors[std::min(point, veil.colors.size() - 1)];
}

bool see_through(const SceneItem& item, const MirroredMesh::Part& part)
{
    return item.see_through(part);
}

// Decides like ghost.frag.
bool shows_front_only(const SceneItem& item, const MirroredMesh::Part& part)
{
    return !item.material(part.material).double_sided;
}

bool has_see_through(const SceneItem& item)
{
    return std::ranges::any_of(item.mesh->parts(),
                               [&](const auto& part) { return item.see_through(part); });
}

} // namespace

SeeThroughPass::SeeThroughPass()
{
    points_.write({});
    const int stride = sizeof(Point);
    vertices_.attribute(0, points_, 3, stride, offsetof(Point, p));
    vertices_.attribute(1, points_, 3, stride, offsetof(Point, normal));
    vertices_.attribute(2, points_, 4, stride, offsetof(Point, color));
}

void SeeThroughPass::load(const std::vector<Translucent>& veils, const glm::dvec3& origin_world)
{
    std::vector<Point> points;
    std::vector<std::uint32_t> indices;
    corners_.clear();
    for (const Translucent& veil : veils) {
        const auto base = static_cast<std::uint32_t>(points.size());
        const bool curved = veil.normals.size() == veil.points.size();
        for (std::size_t i = 0; i < veil.points.size(); ++i)
            points.push_back({glm::dvec3(veil.points[i]) - origin_world,
                              curved ? veil.normals[i] : glm::vec3(0), color_of(veil, i)});
        for (std::size_t t = 0; t + 2 < veil.triangles.size(); t += 3) {
            const auto drawable = [&](std::uint32_t i) {
                return i < veil.points.size() && finite(points[base + i].p);
            };
            const auto corner = veil.triangles.begin() + static_cast<std::ptrdiff_t>(t);
            if (!std::all_of(corner, corner + 3, drawable)) continue;
            for (int k = 0; k < 3; ++k) {
                indices.push_back(base + corner[k]);
                corners_.push_back(points[base + corner[k]].p);
            }
        }
    }
    if (indices.empty()) return;
    points_.write(std::as_bytes(std::span(points)));
    indices_.write(std::as_bytes(std::span(indices)));
    vertices_.indices(indices_);
}

bool SeeThroughPass::any(const Scene& scene) const
{
    return !corners_.empty() || std::ranges::any_of(scene.items, has_see_through);
}

void SeeThroughPass::draw_materials(Tools& tools, const Targets& targets, const Frame& frame,
                                    const Scene& scene, const Quality& quality)
{
    std::vector<glm::vec3> points;
    for (const SceneItem& item : scene.items)
        for (int k = 0; has_see_through(item) && k < 8; ++k)
            points.emplace_back((k & 1 ? item.hi : item.lo).x, (k & 2 ? item.hi : item.lo).y,
                                (k & 4 ? item.hi : item.lo).z);
    if (points.empty()) return;
    const LayerBounds bounds = bounds_of_layers(frame, points);
    const LayerPass::Kind kind{.at_once = quality.layers_at_once};
    layers_.draw(tools, targets, bounds, kind, [&](const std::vector<std::string>& defines) {
        MeshPass pass;
        pass.fragment = "ghost";
        pass.defines = quality.ghost_defines(defines);
        pass.scene_to_clip = frame.view_clip;
        pass.wanted = see_through;
        pass.without_backs = shows_front_only;
        pass.prepare = [&](const Program& program, const SceneItem& item) {
            program.set("opacity", item.opacity);
            program.set("range", bounds.range_world);
            program.set("hidden_share", 0.0f);
        };
        tools.draw(scene.items, pass);
    });
    // The nearest layer is picked, and hides lines; previews stand in nobody's way.
    targets.to_ids.bind();
    set_state({.depth = DepthTest::less, .write_depth = true});
    MeshPass ids;
    ids.fragment = "ids";
    ids.scene_to_clip = frame.view_clip;
    ids.reads_material = false;
    ids.wanted = [](const SceneItem& item, const MirroredMesh::Part& part) {
        return (item.id != 0 || item.copies) && see_through(item, part);
    };
    ids.without_backs = shows_front_only;
    ids.prepare = [](const Program& program, const SceneItem& item) {
        program.set("id", static_cast<unsigned>(item.id));
    };
    tools.draw(scene.items, ids);
}

void SeeThroughPass::draw_helpers(Tools& tools, const Targets& targets, const Frame& frame)
{
    constexpr float hidden_share = 0.3f; // behind something solid
    if (corners_.empty()) return;
    if (targets.deep) encode_color(tools, targets);
    const LayerBounds bounds = bounds_of_layers(frame, corners_);
    layers_.draw(tools, targets, bounds, {.helpers = true},
                 [&](const std::vector<std::string>& defines) {
                     const Program& program = tools.use({"veil", "veil", defines});
                     program.set("range", bounds.range_world);
                     program.set("hidden_share", hidden_share);
                     vertices_.bind();
                     glDrawElements(GL_TRIANGLES, static_cast<int>(corners_.size()),
                                    GL_UNSIGNED_INT, nullptr);
                 });
    if (targets.deep) decode_color(tools, targets);
}

void SeeThroughPass::draw(Tools& tools, const Targets& targets, const Frame& frame,
                          const Scene& scene, const Quality& quality)
{
    draw_materials(tools, targets, frame, scene, quality);
    draw_helpers(tools, targets, frame);
}

} // namespace trivar::gpu
