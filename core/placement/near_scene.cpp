// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/near_scene.h"

#include "core/base/parallel.h"

#include <algorithm>

namespace trivar {
namespace {

constexpr std::size_t boxes_at_once = 64; // of blocks of triangles

using Vertex = NearScene::Vertex;
using Triangle = std::array<std::uint32_t, 3>;

// On which sides of the rectangle a point lies; a triangle with a side in common misses it.
// Of a point behind the camera only that is known.
enum Side : std::uint8_t { left = 1, right = 2, above = 4, below = 8, behind = 16 };

std::uint8_t sides(const Projected& at, glm::dvec2 lo, glm::dvec2 hi)
{
    if (!(at.depth_world > 0)) return behind;
    return static_cast<std::uint8_t>(
        (at.p_px.x < lo.x ? left : 0) | (at.p_px.x > hi.x ? right : 0) |
        (at.p_px.y < lo.y ? above : 0) | (at.p_px.y > hi.y ? below : 0));
}

// A triangle that reaches behind the camera, cut in front of it: one or two triangles are left.
void add_cut(NearScene& out, const View& view, const std::array<Vertex, 3>& corners)
{
    double deepest = 0;
    for (const Vertex& v : corners) deepest = std::max(deepest, v.at.depth_world);
    const double nearest = 1e-4 * deepest;
    std::vector<std::uint32_t> rim;
    const auto add = [&](const glm::dvec3& p) {
        rim.push_back(static_cast<std::uint32_t>(out.vertices.size()));
        out.vertices.push_back({p, view.project(p)});
    };
    for (std::size_t k = 0; k < 3; ++k) {
        const Vertex &a = corners[k], &b = corners[(k + 1) % 3];
        const double da = a.at.depth_world - nearest, db = b.at.depth_world - nearest;
        if (da >= 0) add(a.p_world);
        if ((da >= 0) != (db >= 0)) add(glm::mix(a.p_world, b.p_world, da / (da - db)));
    }
    for (std::size_t k = 2; k < rim.size(); ++k)
        out.triangles.push_back({rim[0], rim[k - 1], rim[k]});
}

void add_entry(NearScene& out, const RayScene::Entry& entry, const View& view, glm::dvec2 lo,
               glm::dvec2 hi, bool skip_back_faces)
{
    const auto& positions = entry.mesh->mesh().positions;
    const auto& triangles = entry.mesh->triangles();
    const auto& boxes = entry.mesh->block_boxes();
    const auto vertex = [&](std::uint32_t i) {
        const glm::dvec3 p(entry.to_world * glm::dvec4(positions[i], 1));
        return Vertex{p, view.project(p)};
    };
    const View from_object = view.of_object(entry.to_world);
    const auto side = [&](const glm::dvec3& p) { return sides(from_object.project(p), lo, hi); };
    const auto misses = [&](const Box& box) {
        std::uint8_t common = 0xff;
        for (int k = 0; k < 8 && common != 0; ++k)
            common &= side({(k & 1) != 0 ? box.lo.x : box.hi.x, (k & 2) != 0 ? box.lo.y : box.hi.y,
                            (k & 4) != 0 ? box.lo.z : box.hi.z});
        return common != 0;
    };
    const bool mirrored = glm::determinant(glm::dmat3(entry.to_world)) < 0;
    const auto front = [&](const glm::uvec3& t) {
        const glm::dvec3 a = vertex(t.x).p_world;
        const glm::dvec3 n = glm::cross(vertex(t.y).p_world - a, vertex(t.z).p_world - a);
        return (glm::dot(n, view.toward_eye(a)) > 0) != mirrored;
    };
    // In fixed blocks, so that the order of the result does not depend on the threads.
    struct Found {
        glm::uvec3 triangle;
        bool cut;
    };
    std::vector<std::vector<Found>> near((boxes.size() + boxes_at_once - 1) / boxes_at_once);
    parallel_blocks(boxes.size(), boxes_at_once, [&](std::size_t begin, std::size_t end) {
        std::vector<Found>& found = near[begin / boxes_at_once];
        for (std::size_t box = begin; box < end; ++box) {
            if (misses(boxes[box])) continue;
            const std::size_t last = std::min(triangles.size(), (box + 1) * RayMesh::block);
            for (std::size_t i = box * RayMesh::block; i < last; ++i) {
                const glm::uvec3& t = triangles[i];
                const std::uint8_t a = side(glm::dvec3(positions[t.x])),
                                   b = side(glm::dvec3(positions[t.y])),
                                   c = side(glm::dvec3(positions[t.z]));
                if ((a & b & c) != 0 || (skip_back_faces && !front(t))) continue;
                found.push_back({t, ((a | b | c) & behind) != 0});
            }
        }
    });

    const std::size_t before = out.vertices.size();
    std::vector<std::uint32_t> kept(positions.size(), 0); // one more than the new index
    std::vector<std::uint32_t> wanted;
    const auto index = [&](std::uint32_t i) {
        if (kept[i] == 0) {
            wanted.push_back(i);
            kept[i] = static_cast<std::uint32_t>(before + wanted.size());
        }
        return kept[i] - 1;
    };
    for (const auto& part : near)
        for (const auto& [t, cut] : part)
            if (!cut) out.triangles.push_back({index(t.x), index(t.y), index(t.z)});
    out.vertices.resize(before + wanted.size());
    parallel_blocks(wanted.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) out.vertices[before + i] = vertex(wanted[i]);
    });
    for (const auto& part : near)
        for (const auto& [t, cut] : part)
            if (cut) add_cut(out, view, {vertex(t.x), vertex(t.y), vertex(t.z)});
}

} // namespace

NearScene near_scene(const RayScene& scene, const View& view, const StripIndex& strip,
                     bool skip_back_faces)
{
    // A little larger: lifting in perspective moves the strip in the picture.
    const glm::dvec2 border(4 * strip.quad_px());
    NearScene out;
    for (const RayScene::Entry& entry : scene.entries())
        add_entry(out, entry, view, strip.lo_px() - border, strip.hi_px() + border,
                  skip_back_faces);
    return out;
}

} // namespace trivar
