// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/near_scene.h"

#include "core/base/parallel.h"

#include <algorithm>

namespace trivar {
namespace {

constexpr std::size_t boxes_at_once = 64; // number of blocks of triangles

using Vertex = NearScene::Vertex;
using Triangle = std::array<std::uint32_t, 3>;

// A Place says whether the hull of points may be near the strip, and whether some are behind the
// camera.
struct Place {
    bool near = false, behind = false;
};

template <std::size_t N>
Place place_of(const std::array<glm::dvec3, N>& points, const View& view,
               const StripIndex::Surroundings& strip)
{
    glm::dvec2 lo(1e300), hi(-1e300);
    std::size_t behind = 0;
    for (const glm::dvec3& p : points) {
        const PicturePoint at = view.project(p);
        behind += !(at.depth_world > 0);
        lo = glm::min(lo, at.p_px);
        hi = glm::max(hi, at.p_px);
    }
    return {behind > 0 ? behind < N : strip.may_touch(lo, hi), behind > 0};
}

// Cuts a triangle that reaches behind the camera, which leaves one or two triangles.
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

void add_entry(NearScene& out, const RayScene::Entry& entry, const View& view,
               const StripIndex::Surroundings& strip, bool skip_back_faces)
{
    const auto& positions = entry.mesh->mesh().positions;
    const auto& triangles = entry.mesh->triangles();
    const auto& boxes = entry.mesh->block_boxes();
    const auto vertex = [&](std::uint32_t i) {
        const glm::dvec3 p(entry.to_world * glm::dvec4(positions[i], 1));
        return Vertex{p, view.project(p)};
    };
    const View from_object = view.of_object(entry.to_world);
    const auto near_box = [&](const Box& box) {
        std::array<glm::dvec3, 8> corners;
        for (std::size_t k = 0; k < 8; ++k)
            corners[k] = {(k & 1) != 0 ? box.lo.x : box.hi.x, (k & 2) != 0 ? box.lo.y : box.hi.y,
                          (k & 4) != 0 ? box.lo.z : box.hi.z};
        return place_of(corners, from_object, strip).near;
    };
    const bool mirrored = glm::determinant(glm::dmat3(entry.to_world)) < 0;
    const auto front = [&](const glm::uvec3& t) {
        const glm::dvec3 a = vertex(t.x).p_world;
        const glm::dvec3 n = glm::cross(vertex(t.y).p_world - a, vertex(t.z).p_world - a);
        return (glm::dot(n, view.toward_eye(a)) > 0) != mirrored;
    };
    // In fixed blocks, so that the order of the result does not depend on the threads.
    struct FoundTriangle {
        glm::uvec3 triangle;
        bool cut;
    };
    std::vector<std::vector<FoundTriangle>> near((boxes.size() + boxes_at_once - 1) /
                                                 boxes_at_once);
    parallel_blocks(boxes.size(), boxes_at_once, [&](std::size_t begin, std::size_t end) {
        std::vector<FoundTriangle>& found = near[begin / boxes_at_once];
        for (std::size_t box = begin; box < end; ++box) {
            if (!near_box(boxes[box])) continue;
            const std::size_t last = std::min(triangles.size(), (box + 1) * RayMesh::block);
            for (std::size_t i = box * RayMesh::block; i < last; ++i) {
                const glm::uvec3& t = triangles[i];
                const std::array<glm::dvec3, 3> corners{positions[t.x], positions[t.y],
                                                        positions[t.z]};
                const Place at = place_of(corners, from_object, strip);
                if (at.near && (!skip_back_faces || front(t))) found.push_back({t, at.behind});
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
    // Adds a margin: lifting in perspective moves the strip in the picture, although its control
    // points stay in place there.
    const StripIndex::Surroundings around(strip, strip.quad_px());
    NearScene out;
    for (const RayScene::Entry& entry : scene.entries())
        add_entry(out, entry, view, around, skip_back_faces);
    return out;
}

} // namespace trivar
