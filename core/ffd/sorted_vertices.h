// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/axis_cells.h"
#include "core/ffd/embedding.h"
#include "core/mesh/mesh.h"
#include "core/spline/knots.h"

namespace trivar {

// SortedVertices holds the vertices of a mesh in the order in which their deformation is computed.
// The mesh is divided into chunks of consecutive vertices, so that the results of a chunk stay in a
// processor's cache while they are put back in the order of the mesh. Inside of a chunk vertices
// are sorted by cell, so that a whole SIMD register shares one polynomial.
struct SortedVertices {
    // A CellKey is a cell by its places on the three axes. Bit a of `mirrored` says that axis a
    // runs backwards, because the vertex lies an odd number of turns round a twisted axis.
    struct CellKey {
        std::array<std::uint32_t, 3> cell{};
        std::uint32_t mirrored = 0;
        auto operator<=>(const CellKey&) const = default;
    };
    struct Run { // a range of sorted vertices in one cell
        std::uint32_t begin, end;
        std::uint32_t cell; // in `cells`
    };

    std::vector<CellKey> cells; // the occupied ones, ascending
    std::vector<Run> runs;
    std::vector<std::uint32_t> chunk_begin; // #chunks + 1, to runs

    std::vector<std::uint32_t> place; // #V, the place of each vertex in the order

    // These arrays are by place in the order. `slack` unused elements follow, so that a register
    // may be loaded from any place.
    static constexpr std::size_t slack = 64;
    std::array<std::vector<float>, 3> t;               // in the cell, -1/2..1/2
    std::array<std::vector<float>, 3> rest;            // to_rest(p)
    std::array<std::vector<float>, 3> normal, tangent; // the mesh's, or empty
};

// Sorts the vertices of a mesh. `cells` must be those of `axes`. Any vertex may lie anywhere; a
// position that is not a number gives results that are not numbers. O(#V + #cells of an axis) per
// chunk.
SortedVertices sort_by_cell(const Mesh& mesh, const Embedding& embedding,
                            const std::array<Knots, 3>& axes,
                            const std::array<AxisCells, 3>& cells);

} // namespace trivar
