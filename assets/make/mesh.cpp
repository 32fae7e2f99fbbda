// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/mesh.h"

#include <algorithm>
#include <cmath>

namespace make {

namespace {

void flip(Mesh& mesh)
{
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        const auto n = std::ptrdiff_t(corner_count(mesh.faces[i]));
        std::reverse(mesh.faces[i].begin(), mesh.faces[i].begin() + n);
        if (!mesh.uvs.empty()) std::reverse(mesh.uvs[i].begin(), mesh.uvs[i].begin() + n);
    }
}

} // namespace

Mesh& Mesh::add(const Mesh& other)
{
    const int offset = int(points.size());
    const auto append = [](auto& to, std::size_t size, auto from, std::size_t from_size,
                           auto fill) {
        if (to.empty() && from.empty()) return;
        to.resize(size, fill);
        from.resize(from_size, fill);
        to.insert(to.end(), from.begin(), from.end());
    };
    append(colors, points.size(), other.colors, other.points.size(), vec3(1));
    append(uvs, faces.size(), other.uvs, other.faces.size(), std::array<vec2, 4>{});
    points.insert(points.end(), other.points.begin(), other.points.end());
    for (Face face : other.faces) {
        for (int& i : face) {
            if (i >= 0) i += offset;
        }
        faces.push_back(face);
    }
    return *this;
}

Mesh& Mesh::move(vec3 by)
{
    return warp([by](vec3 p) { return p + by; });
}

Mesh& Mesh::scale(vec3 by)
{
    if (by.x * by.y * by.z < 0) flip(*this);
    return warp([by](vec3 p) { return p * by; });
}

Mesh& Mesh::turn(float angle_deg, vec3 axis)
{
    const mat3 r(glm::rotate(mat4(1), glm::radians(angle_deg), axis));
    return warp([&r](vec3 p) { return r * p; });
}

Mesh& Mesh::apply(const mat4& matrix)
{
    if (glm::determinant(mat3(matrix)) < 0) flip(*this);
    return warp([&matrix](vec3 p) { return vec3(matrix * vec4(p, 1)); });
}

Mesh& Mesh::warp(const std::function<vec3(vec3)>& map)
{
    for (vec3& p : points) p = map(p);
    return *this;
}

Mesh& Mesh::paint(const std::function<vec3(vec3)>& color)
{
    colors.resize(points.size());
    std::transform(points.begin(), points.end(), colors.begin(), color);
    return *this;
}

Mesh& Mesh::mat(int index)
{
    material = index;
    return *this;
}

Mesh mirrored(const Mesh& mesh)
{
    Mesh copy = mesh;
    return copy.scale({1, 1, -1});
}

void orient_outward(Mesh& mesh)
{
    // Measured from a point of the mesh, so that an open one far from the origin is judged well
    // too.
    vec3 center(0);
    for (const vec3& p : mesh.points) center += p / float(mesh.points.size());
    float volume = 0;
    for (const Face& q : mesh.faces) {
        const auto at = [&](std::size_t k) { return mesh.points[std::size_t(q[k])] - center; };
        for (std::size_t t = 1; t + 1 < corner_count(q); ++t) {
            volume += glm::dot(at(0), glm::cross(at(t), at(t + 1)));
        }
    }
    if (volume < 0) flip(mesh);
}

std::vector<vec3> normals(const Mesh& mesh)
{
    std::vector<vec3> result(mesh.points.size(), vec3(0));
    for (const Face& q : mesh.faces) {
        const auto at = [&](std::size_t k) { return mesh.points[std::size_t(q[k])]; };
        const vec3 area = q[3] < 0 ? glm::cross(at(1) - at(0), at(2) - at(0))
                                   : glm::cross(at(2) - at(0), at(3) - at(1));
        for (int i : q) {
            if (i >= 0) result[std::size_t(i)] += area;
        }
    }
    for (vec3& n : result) {
        const float length = glm::length(n);
        n = length > 1e-20f ? n / length : vec3(0, 1, 0);
    }
    return result;
}

int Model::material(const std::string& label, vec3 color, float rough, float metal)
{
    materials.push_back({label, color, rough, metal, {}});
    return int(materials.size()) - 1;
}

int Model::node(const std::string& label, int parent, vec3 translation)
{
    Node made;
    made.name = label;
    made.parent = parent;
    made.translation = translation;
    nodes.push_back(made);
    return int(nodes.size()) - 1;
}

Node& Model::root()
{
    if (nodes.empty()) node(name);
    return nodes[0];
}

std::vector<mat4> world_matrices(const Model& model, int clip, int key)
{
    std::vector<Node> posed = model.nodes;
    if (clip >= 0) {
        for (const Channel& c : model.clips[std::size_t(clip)].channels) {
            Node& node = posed[std::size_t(c.node)];
            if (!c.translations.empty()) node.translation = c.translations[std::size_t(key)];
            if (!c.rotations.empty()) node.rotation = c.rotations[std::size_t(key)];
        }
    }
    std::vector<mat4> world(posed.size());
    for (std::size_t i = 0; i < posed.size(); ++i) {
        const Node& node = posed[i];
        const mat4 local =
            glm::translate(mat4(1), node.translation) * glm::mat4_cast(node.rotation);
        world[i] = node.parent < 0 ? local : world[std::size_t(node.parent)] * local;
    }
    return world;
}

vec3 srgb(unsigned hex)
{
    return vec3(float(hex >> 16 & 255), float(hex >> 8 & 255), float(hex & 255)) / 255.f;
}

vec3 linear_light(vec3 srgb)
{
    for (int i = 0; i < 3; ++i) {
        srgb[i] =
            srgb[i] <= .04045f ? srgb[i] / 12.92f : std::pow((srgb[i] + .055f) / 1.055f, 2.4f);
    }
    return srgb;
}

} // namespace make
