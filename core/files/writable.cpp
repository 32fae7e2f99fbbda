// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/writable.h"

#include "core/base/rejected.h"
#include "core/files/file_bytes.h"
#include "core/files/flattened.h"

#include <glm/gtc/matrix_transform.hpp>

namespace trivar {
namespace {

// Says whether a triangle of the face, triangulated as writers do, has three different positions.
bool has_a_triangle(const Mesh& mesh, std::size_t face, const glm::dmat4& matrix)
{
    Mesh alone;
    for (std::uint32_t c = mesh.face_begin[face]; c < mesh.face_begin[face + 1]; ++c) {
        alone.corners.push_back(static_cast<std::uint32_t>(alone.positions.size()));
        alone.positions.emplace_back(matrix * glm::dvec4(mesh.positions[mesh.corners[c]], 1));
    }
    alone.face_begin.push_back(static_cast<std::uint32_t>(alone.corners.size()));
    for (const glm::uvec3& t : triangles(alone)) {
        const glm::vec3 &a = alone.positions[t.x], &b = alone.positions[t.y],
                        &c = alone.positions[t.z];
        if (a != b && b != c && c != a) return true;
    }
    return false;
}

bool has_a_face(const Mesh& mesh, const glm::dmat4& matrix)
{
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        if (has_a_triangle(mesh, f, matrix)) return true;
    return false;
}

} // namespace

bool holds_curves(const std::string& path)
{
    const std::string extension = extension_of(path);
    return extension == ".glb" || extension == ".obj";
}

void check_writable(const Model& model, const std::string& path)
{
    if (holds_curves(path) && line_count(model) > 0) return;
    // A GLB stores nodes separately from meshes; the other formats store transformed meshes.
    const std::string extension = extension_of(path);
    const bool in_place = extension != ".glb";
    const glm::dvec3 origin = !in_place || extension == ".stl" ? glm::dvec3(0) : far_origin(model);
    const glm::dmat4 to_origin = glm::translate(glm::dmat4(1), -origin);
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        const int mesh = model.nodes[n].mesh;
        const glm::dmat4 matrix =
            in_place ? to_origin * node_to_model(model, static_cast<int>(n)) : glm::dmat4(1);
        if (mesh >= 0 && has_a_face(*model.meshes[static_cast<std::size_t>(mesh)], matrix)) return;
    }
    throw Rejected(path + ": no face has three different corners, so nothing is written");
}

} // namespace trivar
