// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field/scalar_field.h"

namespace trivar {

// The distance of the vertices of a level from it: `exact` is 5e-5 voxels at 256 samples an axis,
// the limit of single precision; `quick` is one Newton step, for a level that is being dragged.
enum class LevelAccuracy : std::uint8_t { quick, exact };

// A LevelMesh is the surface D = level of a field as triangles, for all views: one vertex on each
// lattice edge that changes sides, at the root of the spline there. All edges have two triangles,
// or one in a face of the grid, so it is a closed manifold within the grid, and as vertices stay on
// their lattice edges it does not run through itself. Its normals point to where D is greater.
struct LevelMesh {
    // Vertices and triangles of 8 x 8 x 8 samples, which follow each other.
    struct Brick {
        std::uint32_t first_vertex, vertex_end, first_triangle, triangle_end;
        std::uint32_t first_run;
        glm::vec3 middle;
        std::array<std::uint32_t, 8> owners; // bricks with vertices of these triangles, this first
        std::uint32_t owner_count;
    };
    // A corner of a triangle: the number of its vertex within a brick, and above these twelve bits
    // which of Brick::owners that is. A brick has at most 7 x 8 x 8 x 8 vertices.
    using Corner = std::uint16_t;
    static constexpr unsigned owner_shift = 12;
    // The bounds of (n, -<p - middle, n>) over the corners of a run of triangles of one brick.
    struct Run {
        std::array<float, 4> least, greatest;
    };
    static constexpr std::uint32_t run_length = 32; // triangles
    static constexpr float half_brick = 4;          // voxels from its middle to its sides

    float level = 0;
    std::vector<glm::vec3> positions;                // voxels
    std::vector<float> normal_x, normal_y, normal_z; // unit, 0 where the gradient is
    std::vector<Corner> corners;                     // three per triangle, of its brick
    std::vector<Brick> bricks;
    std::vector<Run> runs;

    std::size_t triangle_count() const { return corners.size() / 3; }
    std::uint32_t vertex(const Brick& brick, Corner corner) const
    {
        return bricks[brick.owners[corner >> owner_shift]].first_vertex +
               (corner & ((1u << owner_shift) - 1));
    }
    // The vertices of a triangle of a brick.
    std::array<std::uint32_t, 3> vertices(const Brick& brick, std::size_t triangle) const
    {
        const Corner* c = corners.data() + 3 * triangle;
        return {vertex(brick, c[0]), vertex(brick, c[1]), vertex(brick, c[2])};
    }
    // The vertices of all triangles, three each.
    std::vector<std::uint32_t> triangles() const;
    // -<p, n>: of (n, offset) and a view of four numbers, one product tells the side of a vertex.
    float offset(std::size_t v) const
    {
        return -(positions[v].x * normal_x[v] + positions[v].y * normal_y[v] +
                 positions[v].z * normal_z[v]);
    }
    std::size_t bytes() const;
};

// Finds the level of a field.
//   samples      the field's values at the points of its lattice: its own samples if it goes
//                through them, else lattice_values()
//   level        in samples; beyond all of them the mesh is empty
//   first_slice  a multiple of 8: with the samples of only some slices from there on, the result is
//                the part of the mesh there, with its numbers of vertices and triangles
// Cost: about 0.3 us per vertex; the same for any number of threads.
template <class Sample>
LevelMesh level_mesh(const ScalarField<float>& field, std::span<const Sample> samples, float level,
                     LevelAccuracy accuracy = LevelAccuracy::exact, int first_slice = 0);

// The values of a field at the points of its lattice, of those slices that it holds, x fastest.
std::vector<float> lattice_values(const ScalarField<float>& field);

} // namespace trivar
