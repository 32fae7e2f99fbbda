// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace trivar {

// GlbContent is the content of a GLB file number for number, without the repairs of a reader: for
// checking what Trivar wrote itself.
struct GlbContent {
    std::string extras; // JSON; empty: none
    struct Node {
        std::string name;
        glm::dmat4 to_file{1}; // with those of its parents; Y up
        std::vector<glm::vec3> positions;
        std::vector<std::uint32_t> corners; // three a triangle, primitive by primitive
        bool operator==(const Node&) const = default;
    };
    std::vector<Node> nodes;
};

// Lines are left out. Triangles must have 32-bit indices, and all primitives of a mesh must use the
// same vertices, as Trivar writes them. Throws Rejected where the file is no such GLB, its JSON is
// nested too deep, or its nodes together want more than 16 times its bytes.
GlbContent glb_content_of(const std::string& bytes, const std::string& name);
// The extras alone; the rest of the file is not checked. Empty: none.
std::string glb_extras(const std::string& bytes, const std::string& name);

} // namespace trivar
