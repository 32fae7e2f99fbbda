// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/shading.h"

#include "core/base/joined_sets.h"
#include "core/base/parallel.h"
#include "core/mesh/split_vertices.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <span>

namespace trivar {
namespace {

// The normals of a mesh by its faces.
class FaceNormals {
public:
    FaceNormals(const Mesh& mesh, double smooth_up_to_deg,
                std::span<const std::uint32_t> smoothing = {})
        : mesh_(mesh),
          smoothing_(smoothing),
          all_smooth_(smoothing.empty()
                          ? smooth_up_to_deg >= 180
                          : smoothing[0] != 0 && std::ranges::count(smoothing, smoothing[0]) ==
                                                     std::ssize(smoothing)),
          // Coplanar faces are flat together though their normals are rounded.
          angle_(glm::radians(std::clamp(smooth_up_to_deg, 0.01, 180.0))),
          area_normals_(mesh.face_count()),
          face_(mesh.corners.size()),
          sums_(mesh.vertex_count() == 0 ? 0 : point_count(mesh), glm::dvec3(0))
    {
        parallel_blocks(mesh.face_count(), 1 << 14, [&](std::size_t first, std::size_t end) {
            for (std::size_t f = first; f < end; ++f) {
                area_normals_[f] = area_normal(mesh, f);
                for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c)
                    face_[c] = static_cast<std::uint32_t>(f);
            }
        });
        for (std::uint32_t c = 0; c < face_.size(); ++c) sums_[point(c)] += area_normals_[face_[c]];
    }

    // The mean of all faces at the point of a vertex.
    glm::vec3 mean(std::uint32_t vertex) const { return mean(sums_[mesh_.point(vertex)]); }

    // The corners at points where faces meet at more than the angle, in ascending order.
    std::vector<std::uint32_t> at_edges() const
    {
        std::vector<std::uint32_t> out;
        if (all_smooth_) return out;
        std::vector<std::uint8_t> edge(sums_.size(), 0); // by point
        parallel_blocks(face_.size(), 1 << 15, [&](std::size_t first, std::size_t end) {
            for (auto c = static_cast<std::uint32_t>(first); c < end; ++c)
                if (!near_mean(c))
                    std::atomic_ref(edge[point(c)]).store(1, std::memory_order_relaxed);
        });
        out.reserve(face_.size());
        for (std::uint32_t c = 0; c < face_.size(); ++c)
            if (edge[point(c)]) out.push_back(c);
        return out;
    }

    // The normals of these corners, which are all those at some points.
    std::vector<glm::vec3> of(const std::vector<std::uint32_t>& corners) const
    {
        std::vector<glm::vec3> out(corners.size());
        std::vector<std::uint32_t> points;
        points.reserve(corners.size());
        for (const std::uint32_t c : corners) points.push_back(point(c));
        const VertexCorners round(points, sums_.size());
        parallel_blocks(sums_.size(), 1 << 13, [&](std::size_t first, std::size_t end) {
            Fans fans;
            for (std::size_t p = first; p < end; ++p) {
                fans.corners.clear();
                for (const std::uint32_t i : round[p]) fans.corners.push_back(corners[i]);
                join(fans);
                for (std::size_t i = 0; i < fans.corners.size(); ++i)
                    out[round[p][i]] = unit_or(fans.sums[fans.of[i]], mean(sums_[p]));
            }
        });
        return out;
    }

private:
    // The corners at a point, which of them belong together, and the sum of each such fan.
    struct Fans {
        std::vector<std::uint32_t> corners, of;
        std::vector<glm::dvec3> sums;
        std::vector<std::uint64_t> sides; // the other end, the corner's place in the list
    };

    std::uint32_t point(std::uint32_t corner) const { return mesh_.point(mesh_.corners[corner]); }

    // Whether a face differs from the mean by no more than half of the angle: if all do, no two
    // differ by more than all of it.
    bool near_mean(std::uint32_t corner) const
    {
        const glm::dvec3 &n = area_normals_[face_[corner]], &mean = sums_[point(corner)];
        return smoothing_.empty() && within(n, mean, least_cosine_of_half_);
    }

    // Joins the corners at a point over smooth edges.
    void join(Fans& fans) const
    {
        const std::size_t count = fans.corners.size();
        fans.sides.clear();
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t c = fans.corners[i], f = face_[c];
            const std::uint32_t begin = mesh_.face_begin[f], end = mesh_.face_begin[f + 1];
            for (const std::uint32_t other :
                 {c + 1 == end ? begin : c + 1, c == begin ? end - 1 : c - 1})
                fans.sides.push_back(std::uint64_t{point(other)} << 32 | i);
        }
        JoinedSets joined(count);
        const auto join_if = [&](std::uint64_t side, std::uint64_t other) {
            const auto a = static_cast<std::uint32_t>(side), b = static_cast<std::uint32_t>(other);
            if (side >> 32 == other >> 32 && smooth(face_[fans.corners[a]], face_[fans.corners[b]]))
                joined.join(a, b);
        };
        // An edge of more than two faces may be smooth between some of them. Of very many sides
        // only those near each other in their order are looked at.
        const std::size_t sides = fans.sides.size();
        constexpr std::size_t few = 24, most = 4;
        if (sides > few) std::ranges::sort(fans.sides);
        for (std::size_t i = 0; i < sides; ++i)
            for (std::size_t k = i + 1; k < (sides > few ? std::min(i + most, sides) : sides); ++k)
                join_if(fans.sides[i], fans.sides[k]);
        fans.of.clear();
        fans.sums.assign(count, glm::dvec3(0));
        for (std::uint32_t i = 0; i < count; ++i) {
            fans.of.push_back(joined.root(i));
            fans.sums[fans.of[i]] += area_normals_[face_[fans.corners[i]]];
        }
    }

    bool smooth(std::uint32_t f, std::uint32_t g) const
    {
        if (!smoothing_.empty()) return smoothing_[f] != 0 && smoothing_[f] == smoothing_[g];
        const glm::dvec3 &m = area_normals_[f], &n = area_normals_[g];
        return m != glm::dvec3(0) && n != glm::dvec3(0) && within(m, n, least_cosine_);
    }

    // Whether the cosine of the angle between two directions is at least that; true for zero ones.
    static bool within(const glm::dvec3& m, const glm::dvec3& n, double cosine)
    {
        const double along = glm::dot(m, n);
        return along * std::abs(along) >=
               cosine * std::abs(cosine) * glm::dot(m, m) * glm::dot(n, n);
    }

    static glm::vec3 mean(const glm::dvec3& sum) { return unit_or(sum, {0, 0, 1}); }
    static glm::vec3 unit_or(const glm::dvec3& sum, const glm::vec3& otherwise)
    {
        const double length = glm::length(sum);
        return length > 0 && std::isfinite(length) ? glm::vec3(sum / length) : otherwise;
    }

    const Mesh& mesh_;
    std::span<const std::uint32_t> smoothing_;
    bool all_smooth_;
    double angle_;
    double least_cosine_ = std::cos(angle_), least_cosine_of_half_ = std::cos(angle_ / 2);
    std::vector<glm::dvec3> area_normals_; // #F
    std::vector<std::uint32_t> face_;      // #C
    std::vector<glm::dvec3> sums_;         // by point, of the area normals of its faces
};

// Whether a normal says a direction; made unit then.
bool is_given(glm::vec3& normal)
{
    const double length = glm::length(glm::dvec3(normal));
    if (!(length > 0) || !std::isfinite(length)) return false;
    normal = glm::vec3(glm::dvec3(normal) / length);
    return true;
}

bool shows(const Mesh& mesh, const FaceNormals& faces)
{
    const std::vector<std::uint32_t> corners = faces.at_edges();
    const std::vector<glm::vec3> normals = faces.of(corners);
    std::vector<bool> at_edge(mesh.vertex_count(), false);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::uint32_t v = mesh.corners[corners[i]];
        if (normals[i] != mesh.normals[v]) return false;
        at_edge[v] = true;
    }
    for (const std::uint32_t v : mesh.corners)
        if (!at_edge[v] && mesh.normals[v] != faces.mean(v)) return false;
    return true;
}

} // namespace

Mesh with_normals_of_faces(Mesh mesh, float smooth_up_to_deg,
                           const std::vector<std::uint32_t>& smoothing)
{
    std::vector<bool> given(mesh.vertex_count(), false);
    for (std::size_t v = 0; v < mesh.normals.size(); ++v) given[v] = is_given(mesh.normals[v]);
    const auto count = std::ranges::count(given, true);
    const bool none = count == 0;
    if (!none && count == std::ssize(given)) return mesh;
    if (none) {
        mesh.tangents.clear();
        for (Mesh::MorphTarget& target : mesh.morph_targets)
            target.normals.clear(), target.tangents.clear();
    }
    const FaceNormals faces(mesh, smooth_up_to_deg, smoothing);
    std::vector<glm::vec3> normals;
    normals.reserve(mesh.vertex_count());
    for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v)
        normals.push_back(given[v] ? mesh.normals[v] : faces.mean(v));
    const std::vector<std::uint32_t> corners = faces.at_edges();
    std::vector<glm::vec3> at_corners = faces.of(corners);
    for (std::size_t i = 0; i < corners.size() && !none; ++i)
        if (const std::uint32_t v = mesh.corners[corners[i]]; given[v]) at_corners[i] = normals[v];
    mesh.normals.clear();
    mesh.normals = split_vertices(mesh, std::move(normals), corners, at_corners);
    return mesh;
}

Mesh shaded(Mesh mesh, float smooth_up_to_deg)
{
    mesh.normals.clear();
    return with_normals_of_faces(std::move(mesh), smooth_up_to_deg);
}

std::optional<float> shading_of(const Mesh& mesh)
{
    if (mesh.normals.empty() || mesh.points.empty()) return {}; // no vertex is split
    std::vector<std::uint32_t> first(mesh.vertex_count(), ~0u); // by point
    bool edges = false;
    for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v)
        if (std::uint32_t& other = first[mesh.points[v]]; other == ~0u)
            other = v;
        else
            edges |= mesh.normals[v] != mesh.normals[other];
    if (!edges) return {};
    for (const float angle : {0.0f, usual_edge_deg}) {
        if (shows(mesh, FaceNormals(mesh, angle))) return angle;
    }
    return {};
}

bool looks_smooth(const Mesh& mesh)
{
    constexpr std::size_t many = 2000; // faces
    if (mesh.face_count() < many || mesh.normals.empty() || !shows(mesh, FaceNormals(mesh, 0)))
        return false;
    const std::vector<glm::vec3> smooth = smooth_normals(mesh);
    std::size_t bent = 0, far = 0; // corners: off the plane of their neighbours, and far off
    for (const std::uint32_t v : mesh.corners) {
        const float cosine = glm::dot(mesh.normals[v], smooth[v]);
        bent += cosine < 0.9999f;
        far += cosine < 0.95f; // 18 degrees, half of the usual edge
    }
    return bent > mesh.corners.size() / 2 && far < mesh.corners.size() / 10;
}

} // namespace trivar
