// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/flattened.h"

#include "core/mesh/far_origin.h"
#include "core/mesh/pose.h"

#include <glm/gtc/matrix_transform.hpp>

namespace trivar {
namespace {

template <class T>
void append(std::vector<T>& all, std::size_t before, const std::vector<T>& more,
            std::size_t more_count, T neutral)
{
    if (all.empty() && more.empty()) return;
    all.resize(before, neutral);
    if (more.empty())
        all.resize(before + more_count, neutral);
    else
        all.insert(all.end(), more.begin(), more.end());
}

} // namespace

glm::dvec3 far_origin(const Model& model)
{
    return far_origin(bounding_box(model));
}

Mesh flattened(const Model& model, const glm::dvec3& origin)
{
    Mesh all;
    const glm::dmat4 to_origin = glm::translate(glm::dmat4(1), -origin);
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        if (model.nodes[n].mesh < 0) continue;
        Mesh mesh = transformed(*model.meshes.at(static_cast<std::size_t>(model.nodes[n].mesh)),
                                to_origin * node_to_model(model, static_cast<int>(n)));
        if (mesh.normals.empty()) mesh.normals = smooth_normals(mesh);
        const std::size_t before = all.vertex_count(), count = mesh.vertex_count();
        const auto first_corner = all.face_begin.back();
        append(all.positions, before, mesh.positions, count, glm::vec3(0));
        append(all.normals, before, mesh.normals, count, glm::vec3(0, 0, 1));
        append(all.colors, before, mesh.colors, count, glm::vec4(1));
        if (all.uvs.empty() && !mesh.uvs.empty()) all.uvs.emplace_back();
        if (!all.uvs.empty())
            append(all.uvs[0], before, mesh.uvs.empty() ? std::vector<glm::vec2>() : mesh.uvs[0],
                   count, glm::vec2(0));
        for (const std::uint32_t v : mesh.corners)
            all.corners.push_back(static_cast<std::uint32_t>(before) + v);
        for (std::size_t f = 1; f < mesh.face_begin.size(); ++f)
            all.face_begin.push_back(first_corner + mesh.face_begin[f]);
    }
    return all;
}

void add_place(fmt::memory_buffer& text, const glm::vec3& p, const glm::dvec3& origin)
{
    const auto to = std::back_inserter(text);
    const glm::dvec3 far = origin + glm::dvec3(p);
    if (origin == glm::dvec3(0))
        fmt::format_to(to, "{} {} {}", p.x, p.y, p.z);
    else
        fmt::format_to(to, "{} {} {}", far.x, far.y, far.z);
}

} // namespace trivar
