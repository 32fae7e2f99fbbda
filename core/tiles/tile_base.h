// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/limit/surface_point.h"
#include "core/rays/ray_scene.h"

#include <array>
#include <optional>
#include <vector>

namespace trivar {

// A SurfacePlace is a point of a TileBase: a triangle, and weights of its corners with sum 1.
struct SurfacePlace {
    std::uint32_t triangle = 0;
    glm::dvec3 weights{1, 0, 0};
    bool operator==(const SurfacePlace&) const = default;
};

// The same place, moved into the triangle where it is a hair outside.
SurfacePlace inside(SurfacePlace at);

// A TileBase is the surface that tiles are painted on, at rest: the triangles of all its meshes,
// their neighbours and normals. Edges with other than two faces, which run along it in opposite
// directions, are borders. Building costs O(#triangles).
class TileBase {
public:
    struct Piece {
        Ref<RayMesh> mesh;
        glm::dmat4 to_model{1};
        // The face of each triangle, if faces are not those of the mesh; null: they are.
        Ref<std::vector<std::uint32_t>> faces = nullptr;
        bool operator==(const Piece&) const = default;
    };
    explicit TileBase(std::vector<Piece> pieces);

    static constexpr std::uint32_t none = 0xFFFFFFFF;
    const std::vector<Piece>& pieces() const { return pieces_; }
    std::size_t triangle_count() const { return triangles_.size(); }
    const glm::uvec3& triangle(std::uint32_t t) const { return triangles_[t]; } // of points
    const std::vector<glm::dvec3>& points() const { return points_; } // in the model's space
    // The side behind side e of triangle t, from corner e to e + 1, as 3 t' + e'; or none.
    std::uint32_t across(std::uint32_t t, int e) const { return across_[3 * t + e]; }
    const glm::dvec3& face_normal(std::uint32_t t) const { return face_normals_[t]; }
    std::uint32_t piece_of(std::uint32_t t) const;
    glm::uvec3 vertices(std::uint32_t t) const; // the corners in the mesh of its piece, in order
    std::uint32_t first_triangle(std::size_t piece) const { return first_[piece]; }
    std::uint32_t face_of(std::uint32_t t) const { return faces_[t]; } // a number for each face
    std::uint32_t material_of(std::uint32_t t) const { return materials_[t]; }

    std::array<glm::dvec3, 3> corners(std::uint32_t t) const; // in the model's space
    // The place of a point of the triangle's plane; outside, some of its weights are negative.
    SurfacePlace place(std::uint32_t t, const glm::dvec3& p) const;
    glm::dvec3 position(const SurfacePlace& at) const;
    // Unit; weighted by angle at the points, and linear between them.
    glm::dvec3 normal(const SurfacePlace& at) const;
    double area(std::uint32_t t) const;
    double area() const { return area_; } // of all triangles
    double diagonal() const { return diagonal_; }

    // The places of points: where a line through each along its normal meets the surface first,
    // at most `reach` away on either side. In parallel; about 2 microseconds each.
    std::vector<std::optional<SurfacePlace>> locate(std::span<const SurfacePoint> points,
                                                    double reach) const;

private:
    void add_faces(const Piece& piece);
    std::vector<Piece> pieces_;
    std::vector<std::uint32_t> first_; // triangle of each piece; one more at the end
    std::vector<glm::uvec3> triangles_;
    std::vector<glm::dvec3> points_, point_normals_, face_normals_;
    std::vector<std::uint32_t> across_, faces_, materials_;
    RayScene scene_;
    double area_ = 0, diagonal_ = 0;
};

// The normals of points as their triangles stand: weighted by angle, unit; (0, 0, 1) at a point
// without area round it. O(#triangles).
std::vector<glm::dvec3> angle_normals(std::span<const glm::dvec3> points,
                                      std::span<const glm::uvec3> triangles);

} // namespace trivar
