// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/formats.h"
#include "core/files/plain_text.h"
#include "core/files/wavefront/obj_blocks.h"

#include <cstdint>
#include <vector>

namespace trivar {

// Adds the content of an OBJ's statements between its faces: materials with their libraries, groups
// and creases. `first_of` is that of ObjVertices, `plain` the text of the blocks.
struct ObjAttributes {
    std::vector<std::uint32_t> line_material; // for Curves::material
    std::vector<std::uint32_t> smoothing;     // as of ObjModel
};
ObjAttributes add_obj_statements(Model& model, Mesh& mesh, const std::vector<ObjBlock>& blocks,
                                 const std::vector<std::uint32_t>& first_of, const FileText& file,
                                 const PlainText& plain);

} // namespace trivar
