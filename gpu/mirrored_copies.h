// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"
#include "gpu/copy.h"
#include "gpu/vertex_array.h"

#include <cstdint>
#include <memory>
#include <span>

namespace trivar::gpu {

class TilePatches;

// CopiesAt says where the copies of an instance stand together; see to_scene().
struct CopiesAt {
    glm::dmat4 to_world{1};
    glm::dvec3 mesh_origin{0}, scene_origin_world{0};
    bool operator==(const CopiesAt&) const = default;
};

// ChosenRows are rows of tiles that the GPU has written, and the commands that draw them: a draw
// takes from one of them how many there are. A level's rows begin at its number times the capacity.
struct ChosenRows {
    Buffer rows, commands;
    std::size_t capacity = 0;
};

// MirroredCopies are the copies of an instance on the GPU, for instanced draws.
struct MirroredCopies {
    Buffer rows;                   // one row per copy; the mirroring ones come last
    int upright = 0, mirrored = 0; // number of copies that do not turn faces round, and that do
    double scale = 1;              // mean size of a copy relative to the mesh
    bool valued = false;           // every copy has a value
    std::uint64_t serial = 0;      // unique for each upload
    // Not null: the copies are tiles, bent over these patches, and a row is the number of a tile.
    std::shared_ptr<const TilePatches> patches;
    bool footprints = false; // of the tiles: beyond the unit square they go on as they bend
    // Not null: the tiles are those of a level here, and their number is known on the GPU alone;
    // `upright` is the most that it can be. A command for each part of the level's mesh, then one
    // for its edges.
    std::shared_ptr<const ChosenRows> chosen;
    std::size_t level = 0, first_command = 0;

    // Binds the rows from `first` on to the attributes of place.glsl; if `shows_values`, their
    // values to those of values.glsl.
    void feed(const VertexArray& vertices, int first, bool shows_values) const;
    // Draws so many copies of a range of the bound indices, points, lines or triangles; where the
    // GPU has chosen them, by a command.
    void draw(unsigned primitive, int index_count, int first_index, int copies,
              std::size_t command) const;
};

// The rows of tiles, which patches and a serial then complete.
MirroredCopies uploaded(std::span<const std::uint32_t> tiles);
// Makes rows that were uploaded for `before` those of other tiles, and uploads no more than from
// the first to the last that differs.
void rewrite(MirroredCopies& copies, std::span<const std::uint32_t> before,
             std::span<const std::uint32_t> tiles);

// Leaves out copies whose matrix is not finite, as all functions here do.
MirroredCopies uploaded(std::span<const Copy> copies, const CopiesAt& at);

// The box of a transformed box.
Box transformed(const Box& box, const glm::dmat4& matrix);
// A box that holds all copies of a box's contents.
Box transformed(const Box& box, const glm::dmat4& to_world, std::span<const Copy> copies);
// The box of the copies of a mesh. O(#V + #copies) where few of them stand at the rim, at most O(#V
// #copies).
Box bounding_box(const Mesh& mesh, const glm::dmat4& to_world, std::span<const Copy> copies);

} // namespace trivar::gpu
