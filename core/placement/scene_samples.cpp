// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/scene_samples.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace trivar {
namespace {

constexpr std::size_t block = 8192;
constexpr double most_parts = 8;                  // of a step where the strip sags
constexpr std::size_t most_edge_samples = 100000; // of a block of edges: a bound for slivers

using Vertex = NearScene::Vertex;

// The part of a projected edge inside the rectangle round the strip, as shares of the edge in the
// picture. Empty: from > to.
struct Span {
    double from = 0, to = 1;
};

Span clipped(glm::dvec2 a, glm::dvec2 b, glm::dvec2 lo, glm::dvec2 hi)
{
    Span out;
    for (int axis = 0; axis < 2; ++axis) {
        const double d = b[axis] - a[axis];
        if (d == 0) {
            if (a[axis] < lo[axis] || a[axis] > hi[axis]) return {1, 0};
            continue;
        }
        const double s = (lo[axis] - a[axis]) / d, t = (hi[axis] - a[axis]) / d;
        out.from = std::max(out.from, std::min(s, t));
        out.to = std::min(out.to, std::max(s, t));
    }
    return out;
}

// An edge that begins behind the camera, cut off in front of it.
void cut_in_front(const View& view, Vertex& a, Vertex& b)
{
    const auto cut = [&](Vertex& behind, const Vertex& front) {
        const double depth = 1e-4 * front.at.depth_world;
        if (behind.at.depth_world >= depth) return;
        const double t =
            (front.at.depth_world - depth) / (front.at.depth_world - behind.at.depth_world);
        behind.p_world = glm::mix(front.p_world, behind.p_world, t);
        behind.at = view.project(behind.p_world);
    };
    cut(a, b);
    cut(b, a);
}

class EdgeSampler {
public:
    EdgeSampler(const View& view, const StripIndex& strip, double tolerance)
        : view_(view),
          strip_(strip),
          tolerance_(tolerance)
    {
    }

    // Points of the edge that the strip may cover, at most `step_px` apart.
    // Those with one end under the strip are given so, `a_covered` or `b_covered`.
    template <class Visit>
    void walk(Vertex a, Vertex b, bool a_covered, bool b_covered, double step_px,
              const Visit& visit) const
    {
        if (a.at.depth_world <= 0 && b.at.depth_world <= 0) return;
        cut_in_front(view_, a, b);
        const glm::dvec2 pa = a.at.p_px, pb = b.at.p_px;
        // A short one counts by its ends, and where the rim of the strip cuts it by that point.
        const bool is_short = std::max(std::abs(pb.x - pa.x), std::abs(pb.y - pa.y)) <= 4 * step_px;
        if (is_short && a_covered == b_covered) return;
        if (is_short) {
            at_rim(a, b, {0, 1}, a_covered, visit);
            return;
        }
        const Span span = clipped(pa, pb, strip_.lo_px(), strip_.hi_px());
        if (!(span.from <= span.to)) return;
        const double length = (span.to - span.from) * glm::length(pb - pa);
        const int steps = static_cast<int>(std::min(1e5, std::ceil(length / step_px))) + 1;
        const double stride = (span.to - span.from) / steps;
        bool was_covered = false;
        for (int i = 0; i <= steps; ++i) {
            const double begin = span.from + stride * i;
            const glm::dvec2 p_px = glm::mix(pa, pb, begin);
            const bool covered = !strip_.find(p_px).empty();
            if (i > 0 && covered != was_covered)
                at_rim(a, b, {begin - stride, begin}, was_covered, visit);
            was_covered = covered;
            if (!covered) continue;
            // What a surface sags between two points falls with the square of their distance.
            const int parts = static_cast<int>(
                std::clamp(std::sqrt(strip_.sag(p_px) / tolerance_), 1.0, most_parts));
            for (int part = 0; part < parts; ++part) {
                const double t = std::min(begin + stride * part / parts, span.to);
                visit(glm::mix(pa, pb, t), at(a, b, t));
            }
        }
    }

private:
    // The point between two of an edge where the rim of the strip cuts it.
    template <class Visit>
    void at_rim(const Vertex& a, const Vertex& b, Span cut, bool first_covered,
                const Visit& visit) const
    {
        for (int halving = 0; halving < 14; ++halving) {
            const double middle = (cut.from + cut.to) / 2;
            const bool covered = !strip_.find(glm::mix(a.at.p_px, b.at.p_px, middle)).empty();
            (covered == first_covered ? cut.from : cut.to) = middle;
        }
        const double t = first_covered ? cut.from : cut.to;
        visit(glm::mix(a.at.p_px, b.at.p_px, t), at(a, b, t));
    }
    // Equal steps in the picture are not equal steps in space.
    glm::dvec3 at(const Vertex& a, const Vertex& b, double t) const
    {
        const double za = a.at.depth_world, zb = b.at.depth_world;
        const double s = view_.perspective() ? t * za / (t * za + (1 - t) * zb) : t;
        return glm::mix(a.p_world, b.p_world, s);
    }
    const View& view_;
    const StripIndex& strip_;
    double tolerance_;
};

bool append(std::vector<SceneSample>& out, const StripIndex& strip, const glm::dvec2& p_px,
            const glm::dvec3& p_world)
{
    const std::vector<glm::dvec2> found = strip.find(p_px);
    for (const glm::dvec2& uv : found) out.push_back({p_world, uv});
    return !found.empty();
}

// The rectangle round the strip, a little larger: lifting in perspective moves it in the picture.
struct Frame {
    glm::dvec2 lo, hi;
    bool touches(const Vertex& a) const
    {
        return a.at.depth_world > 0 && glm::all(glm::greaterThanEqual(a.at.p_px, lo)) &&
               glm::all(glm::lessThanEqual(a.at.p_px, hi));
    }
    // An edge in front of the camera and all on one side of the frame does not meet it.
    bool touches(const Vertex& a, const Vertex& b) const
    {
        if (a.at.depth_world <= 0 || b.at.depth_world <= 0)
            return a.at.depth_world > 0 || b.at.depth_world > 0;
        return glm::all(glm::lessThanEqual(glm::min(a.at.p_px, b.at.p_px), hi)) &&
               glm::all(glm::greaterThanEqual(glm::max(a.at.p_px, b.at.p_px), lo));
    }
};

// In fixed blocks, so that the order of the result does not depend on the threads.
template <class T, class Body> std::vector<T> collected(std::size_t count, const Body& body)
{
    std::vector<std::vector<T>> parts((count + block - 1) / block);
    parallel_blocks(count, block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) body(i, parts[begin / block]);
    });
    std::vector<T> out;
    for (const auto& part : parts) out.insert(out.end(), part.begin(), part.end());
    return out;
}

} // namespace

NearScene::NearScene(const RayScene& scene, const View& view, const StripIndex& strip,
                     bool skip_back_faces)
    : view_(view)
{
    const glm::dvec2 border(4 * strip.quad_px());
    const Frame frame{strip.lo_px() - border, strip.hi_px() + border};
    for (const RayScene::Entry& entry : scene.entries()) {
        const auto& positions = entry.mesh->mesh().positions;
        const auto& triangles = entry.mesh->triangles();
        std::vector<Vertex> all(positions.size());
        parallel_blocks(positions.size(), block, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                all[i].p_world = glm::dvec3(entry.to_world * glm::dvec4(positions[i], 1));
                all[i].at = view.project(all[i].p_world);
            }
        });
        const bool mirrored = glm::determinant(glm::dmat3(entry.to_world)) < 0;
        const auto front = [&](const glm::uvec3& t) {
            const glm::dvec3 a = all[t.x].p_world;
            const glm::dvec3 n = glm::cross(all[t.y].p_world - a, all[t.z].p_world - a);
            return (glm::dot(n, view.toward_eye(a)) > 0) != mirrored;
        };
        using Edge = std::array<std::uint32_t, 2>;
        std::vector<Edge> edges =
            collected<Edge>(triangles.size(), [&](std::size_t i, std::vector<Edge>& out) {
                const glm::uvec3& t = triangles[i];
                for (int k = 0; k < 3; ++k) {
                    const Edge e{std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])};
                    if (!frame.touches(all[e[0]], all[e[1]])) continue;
                    if (!skip_back_faces || front(t)) out.push_back(e);
                }
            });
        std::sort(edges.begin(), edges.end());
        edges.erase(std::unique(edges.begin(), edges.end()), edges.end());

        // Keep the vertices that edges here use; a vertex without an edge is no part of a surface.
        std::vector<std::uint32_t> kept(positions.size(), 0);
        for (Edge& e : edges)
            for (std::uint32_t& v : e) {
                if (kept[v] == 0) {
                    vertices_.push_back(all[v]);
                    kept[v] = static_cast<std::uint32_t>(vertices_.size());
                }
                v = kept[v] - 1;
            }
        edges_.insert(edges_.end(), edges.begin(), edges.end());
    }
}

std::vector<SceneSample> NearScene::samples(const StripIndex& strip, double tolerance) const
{
    std::vector<char> covered(vertices_.size(), 0);
    std::vector<SceneSample> out =
        collected<SceneSample>(vertices_.size(), [&](std::size_t i, std::vector<SceneSample>& to) {
            if (vertices_[i].at.depth_world > 0)
                covered[i] = append(to, strip, vertices_[i].at.p_px, vertices_[i].p_world);
        });
    const EdgeSampler sampler(view_, strip, tolerance);
    const auto on_edges = [&](double step) {
        return collected<SceneSample>(
            edges_.size(), [&](std::size_t i, std::vector<SceneSample>& to) {
                const auto [a, b] = edges_[i];
                if (to.size() > most_edge_samples) return;
                sampler.walk(vertices_[a], vertices_[b], covered[a], covered[b], step,
                             [&](const glm::dvec2& p_px, const glm::dvec3& p_world) {
                                 append(to, strip, p_px, p_world);
                             });
            });
    };
    const std::vector<SceneSample> edges = on_edges(strip.quad_px() / 2);
    out.insert(out.end(), edges.begin(), edges.end());
    return out;
}

} // namespace trivar
