// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/shading.h"

#include "core/base/joined_sets.h"
#include "core/base/parallel.h"
#include "core/mesh/split_vertices.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

namespace trivar {
namespace {

template <class Otherwise> glm::vec3 unit_or_else(const glm::dvec3& sum, Otherwise otherwise)
{
    const double length = glm::length(sum);
    return length > 0 && std::isfinite(length) ? glm::vec3(sum / length) : otherwise();
}

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
          points_(mesh.points.empty() ? 0 : mesh.corners.size()),
          sums_(mesh.vertex_count() == 0 ? 0 : point_count(mesh), glm::dvec3(0)),
          edge_(sums_.size(), 0)
    {
        take_faces();
        if (!all_smooth_) take_edges();
        at_edges_.emplace(points(), sums_.size(), [&](std::uint32_t p) { return edge_[p] != 0; });
    }

    // The corners at each point where faces meet at more than the angle.
    const VertexCorners& at_edges() const { return *at_edges_; }

    // The mean of all faces at the point of a vertex.
    glm::vec3 mean(std::uint32_t vertex) const { return mean_at(mesh_.point(vertex)); }
    bool is_at_edge(std::uint32_t vertex) const { return edge_[mesh_.point(vertex)] != 0; }

    // Gives the normals of the corners at the points of a block.
    class Block {
    public:
        Block(const FaceNormals& faces, std::size_t first, std::size_t end)
            : faces_(&faces),
              first_(faces.at_edges()[first].data()),
              fans_(static_cast<std::size_t>(faces.at_edges()[end - 1].data() - first_) +
                    faces.at_edges()[end - 1].size())
        {
        }
        std::span<glm::vec3> operator()(std::size_t point)
        {
            const std::span<const std::uint32_t> corners = faces_->at_edges()[point];
            sides_.clear();
            for (std::uint32_t i = 0; i < corners.size(); ++i)
                for (const std::uint32_t other : faces_->beside(corners[i]))
                    sides_.push_back(std::uint64_t{other} << 32 | i);
            // An edge of more than two faces may be smooth between some of them. Of very many sides
            // only those near each other in their order are looked at.
            const std::size_t count = sides_.size();
            constexpr std::size_t few = 24, most = 4;
            if (count > few) std::ranges::sort(sides_);
            pairs_.resize(count * std::min(count, few) / 2 + 1);
            std::size_t pairs = 0; // found without branches, which could not be foreseen
            for (std::size_t i = 0; i < count; ++i)
                for (std::size_t k = i + 1; k < (count > few ? std::min(i + most, count) : count);
                     ++k) {
                    pairs_[pairs] = {static_cast<std::uint32_t>(sides_[i]),
                                     static_cast<std::uint32_t>(sides_[k])};
                    pairs += (sides_[i] ^ sides_[k]) >> 32 == 0 ? 1 : 0;
                }
            const auto before = static_cast<std::uint32_t>(corners.data() - first_);
            for (const auto& [a, b] : std::span(pairs_.data(), pairs))
                if (faces_->smooth(corners[a], corners[b])) fans_.join(before + a, before + b);
            sums_.assign(corners.size(), glm::dvec3(0));
            fan_.clear();
            for (std::uint32_t i = 0; i < corners.size(); ++i)
                sums_[fan_.emplace_back(fans_.root(before + i) - before)] +=
                    faces_->area_normals_[faces_->face_[corners[i]]];
            normals_.resize(corners.size());
            for (std::size_t i = 0; i < corners.size(); ++i)
                if (fan_[i] == i)
                    normals_[i] = unit_or_else(sums_[i], [&] { return faces_->mean_at(point); });
            for (std::size_t i = 0; i < corners.size(); ++i) normals_[i] = normals_[fan_[i]];
            return normals_;
        }

    private:
        const FaceNormals* faces_;
        const std::uint32_t* first_;
        JoinedSets fans_; // of the places of corners in the block
        // Scratch for the corners at a point.
        std::vector<std::uint64_t> sides_; // the other end, the corner's place in the list
        std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_; // corners at one edge
        std::vector<std::uint32_t> fan_;
        std::vector<glm::dvec3> sums_; // of each fan
        std::vector<glm::vec3> normals_;
    };

private:
    std::span<const std::uint32_t> points() const // of the corners
    {
        return points_.empty() ? mesh_.corners : points_;
    }

    void take_faces()
    {
        parallel_blocks(mesh_.face_count(), 1 << 14, [&](std::size_t first, std::size_t end) {
            for (std::size_t f = first; f < end; ++f) {
                area_normals_[f] = area_normal(mesh_, f);
                for (std::uint32_t c = mesh_.face_begin[f]; c < mesh_.face_begin[f + 1]; ++c) {
                    face_[c] = static_cast<std::uint32_t>(f);
                    if (!points_.empty()) points_[c] = mesh_.points[mesh_.corners[c]];
                }
            }
        });
        const std::span<const std::uint32_t> points = this->points();
        for (std::size_t c = 0; c < points.size(); ++c) sums_[points[c]] += area_normals_[face_[c]];
    }

    // Where a face differs from the mean by more than half of the angle: if none does, no two
    // differ by more than all of it.
    void take_edges()
    {
        const std::span<const std::uint32_t> points = this->points();
        parallel_blocks(points.size(), 1 << 15, [&](std::size_t first, std::size_t end) {
            for (std::size_t c = first; c < end; ++c) {
                const std::atomic_ref edge(edge_[points[c]]);
                if (edge.load(std::memory_order_relaxed) == 0 &&
                    !(smoothing_.empty() &&
                      within(area_normals_[face_[c]], sums_[points[c]], least_cosine_of_half_)))
                    edge.store(1, std::memory_order_relaxed);
            }
        });
    }

    glm::vec3 mean_at(std::size_t point) const
    {
        return unit_or_else(sums_[point], [] { return glm::vec3(0, 0, 1); });
    }

    // The points next to a corner in its face.
    std::array<std::uint32_t, 2> beside(std::uint32_t corner) const
    {
        const std::uint32_t f = face_[corner];
        const std::uint32_t begin = mesh_.face_begin[f], end = mesh_.face_begin[f + 1];
        const std::uint32_t next = corner + 1 == end ? begin : corner + 1;
        const std::uint32_t previous = corner == begin ? end - 1 : corner - 1;
        return {points()[next], points()[previous]};
    }

    // Whether an edge is smooth between the faces of two corners.
    bool smooth(std::uint32_t c, std::uint32_t d) const
    {
        if (!smoothing_.empty())
            return smoothing_[face_[c]] != 0 && smoothing_[face_[c]] == smoothing_[face_[d]];
        const glm::dvec3 &m = area_normals_[face_[c]], &n = area_normals_[face_[d]];
        return m != glm::dvec3(0) && n != glm::dvec3(0) && within(m, n, least_cosine_);
    }

    // Whether the cosine of the angle between two directions is at least that; true for zero ones.
    static bool within(const glm::dvec3& m, const glm::dvec3& n, double cosine)
    {
        const double along = glm::dot(m, n);
        return along * std::abs(along) >=
               cosine * std::abs(cosine) * glm::dot(m, m) * glm::dot(n, n);
    }

    const Mesh& mesh_;
    std::span<const std::uint32_t> smoothing_;
    bool all_smooth_;
    double angle_;
    double least_cosine_ = std::cos(angle_), least_cosine_of_half_ = std::cos(angle_ / 2);
    std::vector<glm::dvec3> area_normals_;     // #F
    std::vector<std::uint32_t> face_, points_; // #C; points empty: the vertices are
    std::vector<glm::dvec3> sums_;             // by point, of the area normals of its faces
    std::vector<std::uint8_t> edge_;           // by point
    std::optional<VertexCorners> at_edges_;
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
    for (const std::uint32_t v : mesh.corners)
        if (!faces.is_at_edge(v) && mesh.normals[v] != faces.mean(v)) return false;
    const VertexCorners& corners = faces.at_edges();
    std::atomic<bool> same{true};
    parallel_blocks(corners.size(), 1 << 13, [&](std::size_t first, std::size_t end) {
        FaceNormals::Block normals_at(faces, first, end);
        for (std::size_t p = first; p < end && same.load(std::memory_order_relaxed); ++p) {
            const std::span<const glm::vec3> normals = normals_at(p);
            for (std::size_t i = 0; i < normals.size(); ++i)
                if (mesh.normals[mesh.corners[corners[p][i]]] != normals[i])
                    same.store(false, std::memory_order_relaxed);
        }
    });
    return same;
}

} // namespace

Mesh with_normals_of_faces(Mesh mesh, float smooth_up_to_deg,
                           const std::vector<std::uint32_t>& smoothing)
{
    std::vector<char> given(mesh.vertex_count(), false);
    parallel_blocks(mesh.normals.size(), 1 << 14, [&](std::size_t first, std::size_t end) {
        for (std::size_t v = first; v < end; ++v) given[v] = is_given(mesh.normals[v]);
    });
    const auto count = std::ranges::count(given, char{true});
    const bool none = count == 0;
    if (!none && count == std::ssize(given)) return mesh;
    if (none) {
        mesh.tangents.clear();
        for (Mesh::MorphTarget& target : mesh.morph_targets)
            target.normals.clear(), target.tangents.clear();
    }
    const FaceNormals faces(mesh, smooth_up_to_deg, smoothing);
    const std::vector<glm::vec3> before = std::exchange(mesh.normals, {});
    const auto of_block = [&](std::size_t first, std::size_t end) {
        return [&, normals_at = FaceNormals::Block(faces, first, end)](std::size_t p) mutable {
            const std::span<glm::vec3> normals = normals_at(p);
            for (std::size_t i = 0; i < normals.size() && !none; ++i)
                if (const std::uint32_t v = mesh.corners[faces.at_edges()[p][i]]; given[v])
                    normals[i] = before[v];
            return normals;
        };
    };
    mesh.normals =
        split_vertices<glm::vec3>(mesh, faces.at_edges(), of_block, [&](std::uint32_t v) {
            return given[v] ? before[v] : faces.mean(v);
        });
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
