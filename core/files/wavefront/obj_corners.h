// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/wavefront/obj_blocks.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace trivar {

// ObjAbsent counts the missing things that faces (or lines) name, and gives the first such face by
// its block and its number in the block.
struct ObjAbsent {
    std::size_t count = 0, block = 0, face = 0;
};
void count_absent(ObjAbsent& absent, std::size_t block, std::size_t face);

// The index from 0, or ObjCorner::none, or ObjCorner::absent where it is not below `count`;
// `before` is the number of elements before the index's block.
std::int32_t absolute_index(std::int32_t index, std::size_t before, std::size_t count);

// ObjFaces are the faces of all blocks, with indices from 0, or below 0: none.
struct ObjFaces {
    std::vector<ObjCorner> corners;
    std::vector<std::uint32_t> begin{0}; // #F + 1 to corner
    ObjAbsent left_out;                  // faces that name a missing vertex
    ObjAbsent details;                   // corners that name a missing vt or vn
};

// Moves the faces out of the blocks; ObjBlock::left_out then tells which are gone. Faces may come
// before the things that they name. A vt or vn that begins with NaN was unreadable and counts as
// not given.
ObjFaces faces_of(std::vector<ObjBlock>& blocks, std::size_t v_count,
                  const std::vector<glm::vec2>& vt, const std::vector<glm::vec3>& vn);

// ObjVertices makes every different (v, vt, vn) one vertex of the mesh, in the order of the file's
// v.
struct ObjVertices {
    std::vector<ObjCorner> of;           // #V
    std::vector<std::uint32_t> corners;  // #C to vertex
    std::vector<std::uint32_t> first_of; // #v + 1: the first vertex at each v
};
ObjVertices unified(const std::vector<ObjCorner>& corners, std::size_t v_count);

} // namespace trivar
