// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"

namespace trivar {

// KeptVertices are the remaining vertices of a mesh, some of them several times with different
// normals.
class KeptVertices {
public:
    explicit KeptVertices(const Mesh& mesh) : mesh_(mesh), list_(mesh.vertex_count(), none) {}

    // A number for the pair, in the order of first use. The normal is ignored where the mesh has
    // none.
    std::uint32_t number(std::uint32_t vertex, const glm::vec3& normal);

    // Writes all values by vertex, in the order of the old vertices, into a mesh whose corners are
    // such numbers. `numbers` are mapped as the corners are.
    void write(Mesh& out, std::vector<std::uint32_t>& numbers) const;

private:
    static constexpr std::uint32_t none = ~0u;
    struct MadeVertex {
        std::uint32_t vertex;
        glm::vec3 normal;
        std::uint32_t next; // of the same old vertex
    };
    void write_points(Mesh& out, const std::vector<std::uint32_t>& order) const;

    const Mesh& mesh_;
    std::vector<std::uint32_t> list_; // by old vertex: the first entry made from it
    std::vector<MadeVertex> made_;
};

} // namespace trivar
