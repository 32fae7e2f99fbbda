// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace trivar {

// What stands in a GLB file number for number, without the repairs of a reader: for checking what
// Trivar wrote itself.
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

// Lines are left out. Triangles must be indexed by 32 bits and all primitives of a mesh stand on
// the same vertices, as Trivar writes them. Throws Rejected where the file is no such GLB, its JSON
// is nested too deep or its nodes together want more than 16 times its bytes.
GlbContent glb_content_of(const std::string& bytes, const std::string& name);
// The extras alone, whatever else stands in the file; empty: none.
std::string glb_extras(const std::string& bytes, const std::string& name);

} // namespace trivar
