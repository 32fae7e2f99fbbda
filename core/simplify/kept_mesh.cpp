// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplify/kept_mesh.h"

#include "core/base/unit.h"
#include "core/simplify/kept_vertices.h"

#include <algorithm>

namespace trivar {
namespace {

glm::dvec3 area_normal_of(const Mesh& mesh, const glm::uvec3& v)
{
    const glm::dvec3 p(mesh.positions[v.x]);
    return glm::cross(glm::dvec3(mesh.positions[v.y]) - p, glm::dvec3(mesh.positions[v.z]) - p);
}

// Returns the normals of the corners of triangles, #T by 3; empty if the mesh has none.
std::vector<std::array<glm::vec3, 3>> corner_normals(const Mesh& mesh, const Fans& fans,
                                                     const Decimation& left)
{
    if (mesh.normals.empty()) return {};
    std::vector<glm::dvec3> sums(fans.vertex.size(), glm::dvec3(0));
    std::vector<bool> touched(fans.vertex.size(), false);
    for (std::size_t t = 0; t < fans.triangles.size(); ++t) {
        if (fans.nodes[t].x == Fans::none) continue;
        for (int i = 0; i < 3; ++i)
            if (left.changed[t]) touched[fans.nodes[t][i]] = true;
        if (left.nodes[t].x == Fans::none) continue;
        const glm::dvec3 normal = area_normal_of(mesh, left.triangles[t]);
        for (int i = 0; i < 3; ++i) {
            sums[left.nodes[t][i]] += normal;
            if (left.changed[t]) touched[left.nodes[t][i]] = true;
        }
    }
    std::vector<std::array<glm::vec3, 3>> out(fans.triangles.size());
    for (std::size_t t = 0; t < out.size(); ++t)
        for (int i = 0; i < 3; ++i) {
            glm::vec3& normal = out[t][static_cast<std::size_t>(i)];
            normal = mesh.normals[left.triangles[t][i]];
            const std::uint32_t node = left.nodes[t][i];
            if (left.nodes[t].x == Fans::none) continue;
            if (fans.faceted[t]) {
                if (left.changed[t])
                    normal = glm::vec3(
                        unit_or(area_normal_of(mesh, left.triangles[t]), glm::dvec3(normal)));
            } else if (touched[node] && !fans.hard[node]) {
                normal = glm::vec3(unit_or(sums[node], glm::dvec3(normal)));
            }
        }
    return out;
}

class KeptFaces {
public:
    KeptFaces(const Mesh& mesh, const Fans& fans, const Decimation& left)
        : mesh_(mesh),
          fans_(fans),
          left_(left),
          normals_(corner_normals(mesh, fans, left)),
          vertices_(mesh)
    {
    }

    Mesh built()
    {
        std::vector<std::uint32_t> polygon;
        for (std::size_t t = 0, end; t < fans_.face.size(); t = end) {
            bool whole = true;
            for (end = t; end < fans_.face.size() && fans_.face[end] == fans_.face[t]; ++end)
                whole &= !left_.changed[end];
            if (whole && end - t > 1) {
                polygon.clear();
                take_outline(t, end, polygon);
                add(fans_.face[t], polygon);
                continue;
            }
            for (std::size_t i = t; i < end; ++i)
                if (!is_gone(fans_, left_, i))
                    add(fans_.face[i], std::array{number(i, 0), number(i, 1), number(i, 2)});
        }
        out_.group_names = mesh_.group_names;
        take_creases();
        return std::move(out_);
    }

private:
    std::uint32_t number(std::size_t t, int i)
    {
        return vertices_.number(left_.triangles[t][i],
                                normals_.empty() ? glm::vec3(0)
                                                 : normals_[t][static_cast<std::size_t>(i)]);
    }

    void add(std::uint32_t face, std::span<const std::uint32_t> corners)
    {
        add_face(out_, corners);
        if (!mesh_.face_material.empty()) out_.face_material.push_back(mesh_.face_material[face]);
        if (!mesh_.face_group.empty()) out_.face_group.push_back(mesh_.face_group[face]);
    }

    // Finds the corners of a polygon from those of its triangles.
    void take_outline(std::size_t first, std::size_t end, std::vector<std::uint32_t>& polygon)
    {
        known_.clear();
        for (std::size_t t = first; t < end; ++t)
            for (int i = 0; i < 3; ++i) known_.emplace_back(left_.triangles[t][i], number(t, i));
        std::ranges::sort(known_);
        const std::uint32_t face = fans_.face[first];
        for (std::uint32_t c = mesh_.face_begin[face]; c < mesh_.face_begin[face + 1]; ++c) {
            const std::uint32_t vertex = fans_.first_equal[mesh_.corners[c]];
            polygon.push_back(std::ranges::lower_bound(known_, std::pair(vertex, 0u))->second);
        }
    }

    void take_creases()
    {
        std::vector<std::uint32_t> at_node(fans_.vertex.size(), 0), at_point, ends;
        if (!fans_.kept_creases.empty()) at_point.assign(point_count(mesh_), Fans::none);
        for (std::size_t t = 0; t < fans_.triangles.size(); ++t)
            for (int i = 0; i < 3 && !is_gone(fans_, left_, t); ++i) {
                if (fans_.nodes[t].x != Fans::none) at_node[left_.nodes[t][i]] = number(t, i);
                if (!at_point.empty()) at_point[mesh_.point(left_.triangles[t][i])] = number(t, i);
            }
        const auto add_crease = [&](std::uint32_t a, std::uint32_t b, float sharpness) {
            if (a == Fans::none || b == Fans::none) return;
            ends.insert(ends.end(), {a, b});
            out_.creases.push_back({0, 0, sharpness});
        };
        for (const Fans::Rail& rail : left_.creases)
            add_crease(at_node[rail.a], at_node[rail.b], rail.sharpness);
        for (const Mesh::Crease& crease : fans_.kept_creases)
            add_crease(at_point[mesh_.point(crease.a)], at_point[mesh_.point(crease.b)],
                       crease.sharpness);
        vertices_.write(out_, ends);
        for (std::size_t i = 0; i < out_.creases.size(); ++i)
            out_.creases[i].a = ends[2 * i], out_.creases[i].b = ends[2 * i + 1];
    }

    const Mesh& mesh_;
    const Fans& fans_;
    const Decimation& left_;
    std::vector<std::array<glm::vec3, 3>> normals_; // #T or empty
    KeptVertices vertices_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> known_; // vertex, number
    Mesh out_;
};

} // namespace

Mesh kept_mesh(const Mesh& mesh, const Fans& fans, const Decimation& left)
{
    return KeptFaces(mesh, fans, left).built();
}

} // namespace trivar
