// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/limit/surface_point.h"
#include "core/rays/ray_scene.h"

#include <optional>
#include <span>
#include <vector>

namespace trivar {

// A SkinPlace is a point of a triangle of a SlitSkin.
struct SkinPlace {
    std::uint32_t triangle = 0;
    glm::dvec3 weights{1, 0, 0}; // of its corners; their sum is 1
};

// A SlitSkin is a mesh made ready to be cut: its triangles between points of the surface, the
// triangles round each, and rays. It is made once for a mesh; a cut then costs as much as its
// region. Side 3 t + i runs from corner i of triangle t to the next one. Triangles that repeat a
// point are left out. Building costs O(#C log valence).
class SlitSkin {
public:
    static constexpr std::uint32_t none = 0xFFFFFFFF;
    enum class Soundness : char { sound, border, tangled }; // tangled: not a disk round a point

    explicit SlitSkin(const Ref<RayMesh>& rays);

    const Ref<Mesh>& mesh() const { return mesh_; }
    std::uint32_t point_count() const { return static_cast<std::uint32_t>(positions_.size()); }
    std::size_t triangle_count() const { return triangles_.size(); }
    const glm::uvec3& triangle(std::uint32_t t) const { return triangles_[t]; } // of points
    const glm::uvec3& vertices(std::uint32_t t) const { return vertices_[t]; }  // of the mesh
    std::uint32_t face_of(std::uint32_t t) const { return faces_[t]; }          // of the mesh
    std::span<const std::uint32_t> faces() const { return faces_; }             // ascending

    std::uint32_t from(std::uint32_t side) const { return triangles_[side / 3][side % 3]; }
    std::uint32_t to(std::uint32_t side) const { return triangles_[side / 3][(side + 1) % 3]; }
    static std::uint32_t next(std::uint32_t side) { return side % 3 == 2 ? side - 2 : side + 1; }
    static std::uint32_t previous(std::uint32_t side)
    {
        return side % 3 == 0 ? side + 2 : side - 1;
    }
    std::uint32_t across(std::uint32_t side) const { return across_[side]; } // or none
    // The lower one of the two sides of an edge.
    std::uint32_t edge(std::uint32_t side) const { return std::min(side, across_[side]); }

    const glm::dvec3& position(std::uint32_t point) const { return positions_[point]; }
    // Unit; weighted by area. Zero at a point without area round it.
    const glm::dvec3& normal(std::uint32_t point) const { return normals_[point]; }
    glm::dvec3 area_normal(std::uint32_t t) const;
    Soundness soundness(std::uint32_t point) const { return soundness_[point]; }
    double usual_edge() const { return usual_edge_; } // the mean length of edges
    double diagonal() const { return diagonal_; }

    // Calls visit(side) with the sides that begin at a point, counter-clockwise if it is sound.
    template <class Visit> void around(std::uint32_t point, const Visit& visit) const
    {
        const std::uint32_t first = first_side_[point];
        if (first == none) return;
        std::uint32_t side = first;
        do {
            visit(side);
            side = across_[previous(side)];
        } while (side != none && side != first);
        if (side == first) return;
        for (side = across_[first]; side != none; side = across_[side]) {
            side = next(side);
            if (side == first) return;
            visit(side);
        }
    }

    // Finds, for each point, the place nearest to it where the line along its normal meets the
    // skin, at most `reach` away.
    std::vector<std::optional<SkinPlace>> locate(std::span<const SurfacePoint> points,
                                                 double reach) const;
    // Returns the thickness of the body along unit directions into it; infinite where it is open.
    std::vector<double> thickness(std::span<const Ray> rays) const;
    // An Opposite is the place where a ray into the body leaves it again.
    struct Opposite {
        SkinPlace place;
        double distance;
    };
    std::vector<std::optional<Opposite>> opposite(std::span<const Ray> rays) const;

private:
    void judge_points();
    std::vector<std::optional<Hit>> hits_below(std::span<const Ray> rays) const;
    std::uint32_t own_triangle(const Hit& hit) const; // or none
    Ref<Mesh> mesh_;
    RayScene scene_;
    std::vector<std::uint32_t> own_number_; // of a triangle of the rays; empty: the same
    std::vector<glm::uvec3> triangles_, vertices_;
    std::vector<std::uint32_t> faces_, across_, first_side_;
    std::vector<glm::dvec3> positions_, normals_;
    std::vector<Soundness> soundness_;
    double usual_edge_ = 0, diagonal_ = 0;
};

} // namespace trivar
