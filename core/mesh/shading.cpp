// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/shading.h"

#include "core/base/joined_sets.h"
#include "core/base/parallel.h"
#include "core/mesh/split_vertices.h"

#include <cmath>
#include <functional>
#include <iterator>

namespace trivar {
namespace {

// Finds the normals of corners at one point of a mesh after another.
class CornerNormals {
public:
    CornerNormals(const Mesh& mesh, double smooth_up_to_deg,
                  const std::vector<std::uint32_t>& smoothing = {})
        : mesh_(mesh),
          smoothing_(smoothing),
          all_smooth_(smooth_up_to_deg >= 180 && smoothing.empty()),
          // Coplanar faces are flat together though their normals are rounded.
          least_cosine_(std::cos(glm::radians(std::max(smooth_up_to_deg, 0.01))))
    {
        for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
            area_normals_.push_back(area_normal(mesh, f));
            face_.resize(mesh.face_begin[f + 1], f);
        }
        for (const std::uint32_t v : mesh.corners) points_.push_back(mesh.point(v));
    }

    std::vector<glm::vec3> all() const // #C
    {
        std::vector<glm::vec3> out(mesh_.corners.size());
        const VertexCorners round(points_, mesh_.vertex_count());
        parallel_blocks(mesh_.vertex_count(), 1 << 13, [&](std::size_t first, std::size_t end) {
            for (std::size_t p = first; p < end; ++p) take(round[p], out);
        });
        return out;
    }

private:
    void take(std::span<const std::uint32_t> corners, std::vector<glm::vec3>& out) const
    {
        glm::dvec3 whole(0);
        for (const std::uint32_t c : corners) whole += area_normals_[face_[c]];
        const glm::vec3 mean = unit_or(whole, {0, 0, 1});
        if (all_smooth_) {
            for (const std::uint32_t c : corners) out[c] = mean;
            return;
        }
        JoinedSets fans = joined(corners);
        std::vector<glm::dvec3> sums(corners.size(), glm::dvec3(0));
        for (std::uint32_t i = 0; i < corners.size(); ++i)
            sums[fans.root(i)] += area_normals_[face_[corners[i]]];
        for (std::uint32_t i = 0; i < corners.size(); ++i)
            out[corners[i]] = unit_or(sums[fans.root(i)], mean);
    }

    // Joins the corners at a point, by their place in the list, over smooth edges.
    JoinedSets joined(std::span<const std::uint32_t> corners) const
    {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> sides; // the other end, the place
        for (std::uint32_t i = 0; i < corners.size(); ++i) {
            const std::uint32_t c = corners[i], f = face_[c];
            const std::uint32_t begin = mesh_.face_begin[f], end = mesh_.face_begin[f + 1];
            sides.emplace_back(points_[c + 1 == end ? begin : c + 1], i);
            sides.emplace_back(points_[c == begin ? end - 1 : c - 1], i);
        }
        std::ranges::sort(sides);
        JoinedSets out(corners.size());
        // An edge of more than two faces may be smooth between some of them; of very many a few are
        // looked at.
        constexpr std::size_t most = 4;
        for (std::size_t i = 0; i < sides.size(); ++i)
            for (std::size_t k = i + 1; k < std::min(i + most, sides.size()); ++k) {
                const auto& [here, a] = sides[i];
                const auto& [there, b] = sides[k];
                if (here == there && smooth(face_[corners[a]], face_[corners[b]])) out.join(a, b);
            }
        return out;
    }

    bool smooth(std::uint32_t f, std::uint32_t g) const
    {
        if (!smoothing_.empty()) return smoothing_[f] != 0 && smoothing_[f] == smoothing_[g];
        const glm::dvec3 &m = area_normals_[f], &n = area_normals_[g];
        const double lengths = glm::length(m) * glm::length(n);
        return lengths > 0 && glm::dot(m, n) >= least_cosine_ * lengths;
    }

    static glm::vec3 unit_or(const glm::dvec3& sum, const glm::vec3& otherwise)
    {
        const double length = glm::length(sum);
        return length > 0 && std::isfinite(length) ? glm::vec3(sum / length) : otherwise;
    }

    const Mesh& mesh_;
    const std::vector<std::uint32_t>& smoothing_;
    bool all_smooth_;
    double least_cosine_;
    std::vector<glm::dvec3> area_normals_;     // #F
    std::vector<std::uint32_t> face_, points_; // #C
};

// Whether a normal says a direction; made unit then.
bool is_given(glm::vec3& normal)
{
    const double length = glm::length(glm::dvec3(normal));
    if (!(length > 0) || !std::isfinite(length)) return false;
    normal = glm::vec3(glm::dvec3(normal) / length);
    return true;
}

} // namespace

Mesh with_normals_of_faces(Mesh mesh, float smooth_up_to_deg,
                           const std::vector<std::uint32_t>& smoothing)
{
    std::vector<bool> given;
    for (glm::vec3& normal : mesh.normals) given.push_back(is_given(normal));
    const bool none = std::ranges::none_of(given, std::identity());
    if (!none && std::ranges::all_of(given, std::identity())) return mesh;
    if (none) {
        mesh.tangents.clear();
        for (Mesh::MorphTarget& target : mesh.morph_targets)
            target.normals.clear(), target.tangents.clear();
    }
    std::vector<glm::vec3> at_corners = CornerNormals(mesh, smooth_up_to_deg, smoothing).all();
    for (std::size_t c = 0; c < at_corners.size() && !none; ++c)
        if (given[mesh.corners[c]]) at_corners[c] = mesh.normals[mesh.corners[c]];
    mesh.normals.clear();
    mesh.normals = split_vertices(mesh, at_corners, glm::vec3(0, 0, 1));
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
        const std::vector<glm::vec3> normals = CornerNormals(mesh, angle).all();
        const auto same = [&](const glm::vec3& normal) {
            return normal == mesh.normals[mesh.corners[std::size_t(&normal - normals.data())]];
        };
        if (std::ranges::all_of(normals, same)) return angle;
    }
    return {};
}

bool looks_smooth(const Mesh& mesh)
{
    constexpr std::size_t many = 2000; // faces
    if (mesh.face_count() < many || shading_of(mesh) != 0.0f) return false;
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
