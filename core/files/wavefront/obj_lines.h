// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/file_lines.h"
#include "core/files/wavefront/obj_corners.h"

namespace trivar {

// ObjLines are the lines of all blocks, as numbers of the file's v.
struct ObjLines {
    FileLines lines;    // without their materials
    ObjAbsent left_out; // lines that name fewer than two vertices, or a missing one
};

// Moves the lines out of the blocks; ObjBlock::lines_left_out then tells which are gone. Lines may
// come before the vertices that they name.
ObjLines lines_of(std::vector<ObjBlock>& blocks, std::size_t v_count);

} // namespace trivar
