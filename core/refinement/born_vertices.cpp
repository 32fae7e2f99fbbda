// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refinement/born_vertices.h"

#include "core/base/parallel.h"
#include "core/base/unit.h"

#include <algorithm>

namespace trivar {
namespace {

template <class Vector> Vector blended(const Vector& a, const Vector& b, float t)
{
    return a + t * (b - a);
}

glm::vec3 unit_blended(const glm::vec3& a, const glm::vec3& b, float t)
{
    return unit_or(blended(a, b, t), a);
}

// Returns the four heaviest joints of both, with weights scaled to the sum 1.
Mesh::Influences blended(const Mesh::Influences& a, const Mesh::Influences& b, float t)
{
    struct Joint {
        std::uint16_t joint;
        float weight;
    };
    std::vector<Joint> joints;
    const auto add = [&](const Mesh::Influences& from, float share) {
        for (int i = 0; i < 4; ++i) {
            const std::uint16_t joint = from.joints[static_cast<std::size_t>(i)];
            const float weight = share * from.weights[i];
            const auto known = std::ranges::find(joints, joint, &Joint::joint);
            if (known != joints.end())
                known->weight += weight;
            else
                joints.push_back({joint, weight});
        }
    };
    add(a, 1 - t);
    add(b, t);
    std::ranges::stable_sort(joints, std::greater(), &Joint::weight);
    Mesh::Influences out{{}, glm::vec4(0)};
    float sum = 0;
    for (std::size_t i = 0; i < std::min<std::size_t>(4, joints.size()); ++i) {
        out.joints[i] = joints[i].joint;
        out.weights[static_cast<int>(i)] = joints[i].weight;
        sum += joints[i].weight;
    }
    if (sum > 0) out.weights /= sum;
    return out;
}

// Appends `make(a, b, t)` for each born vertex, if the mesh has the array.
template <class Value>
void extend(std::vector<Value>& values, const std::vector<BornVertex>& born, std::size_t own,
            const auto& make)
{
    if (values.empty()) return;
    values.resize(own + born.size());
    parallel_blocks(born.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            values[own + i] = make(values[born[i].a], values[born[i].b], born[i].t);
    });
}

} // namespace

void add_vertices(Mesh& mesh, const std::vector<BornVertex>& born)
{
    const std::size_t own = mesh.vertex_count();
    const auto linear = [](const auto& a, const auto& b, float t) { return blended(a, b, t); };
    extend(mesh.positions, born, own, [](const glm::vec3& a, const glm::vec3& b, float t) {
        return glm::vec3(glm::dvec3(a) + double{t} * (glm::dvec3(b) - glm::dvec3(a)));
    });
    extend(mesh.normals, born, own, unit_blended);
    extend(mesh.tangents, born, own, [](const glm::vec4& a, const glm::vec4& b, float t) {
        return glm::vec4(unit_blended(glm::vec3(a), glm::vec3(b), t), a.w);
    });
    extend(mesh.colors, born, own, linear);
    for (auto& set : mesh.uvs) extend(set, born, own, linear);
    extend(mesh.influences, born, own, linear);
    for (Mesh::MorphTarget& target : mesh.morph_targets) {
        extend(target.positions, born, own, linear);
        extend(target.normals, born, own, linear);
        extend(target.tangents, born, own, linear);
    }
    if (!mesh.points.empty())
        for (const BornVertex& v : born) mesh.points.push_back(v.point);
}

} // namespace trivar
