// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/birth.h"

#include "core/base/unit.h"

#include <algorithm>
#include <array>

namespace trivar {
namespace {

template <class Value> Value mean(const std::vector<Value>& values, const BirthVertex& v)
{
    if (v.weights.x == 1) return values[v.of.x]; // to the bit
    Value sum = static_cast<float>(v.weights.x) * values[v.of.x];
    if (v.weights.y != 0) sum += static_cast<float>(v.weights.y) * values[v.of.y];
    if (v.weights.z != 0) sum += static_cast<float>(v.weights.z) * values[v.of.z];
    return sum;
}

template <class Value>
void extend(std::vector<Value>& values, const std::vector<BirthVertex>& births, const auto& make)
{
    if (values.empty()) return;
    values.reserve(values.size() + births.size());
    for (const BirthVertex& v : births) values.push_back(make(v));
}

// The four heaviest joints of all, with weights scaled to the sum 1.
Mesh::Influences mean_influences(const std::vector<Mesh::Influences>& values, const BirthVertex& v)
{
    if (v.weights.x == 1) return values[v.of.x];
    struct Joint {
        std::uint16_t joint;
        double weight;
    };
    std::vector<Joint> joints;
    for (int k = 0; k < 3; ++k) {
        if (v.weights[k] == 0) continue;
        const Mesh::Influences& from = values[v.of[k]];
        for (int i = 0; i < 4; ++i) {
            const std::uint16_t joint = from.joints[static_cast<std::size_t>(i)];
            const double weight = v.weights[k] * double{from.weights[i]};
            const auto known = std::ranges::find(joints, joint, &Joint::joint);
            if (known != joints.end())
                known->weight += weight;
            else
                joints.push_back({joint, weight});
        }
    }
    std::ranges::stable_sort(joints, std::greater(), &Joint::weight);
    joints.resize(std::min<std::size_t>(4, joints.size()));
    double sum = 0;
    for (const Joint& joint : joints) sum += joint.weight;
    Mesh::Influences out{{}, glm::vec4(0)};
    for (std::size_t i = 0; i < joints.size(); ++i) {
        out.joints[i] = joints[i].joint;
        out.weights[static_cast<int>(i)] =
            static_cast<float>(sum > 0 ? joints[i].weight / sum : joints[i].weight);
    }
    return out;
}

} // namespace

void add_births(Mesh& mesh, const std::vector<BirthVertex>& births)
{
    const auto blended = [](const auto& values) {
        return [&](const BirthVertex& v) { return mean(values, v); };
    };
    extend(mesh.positions, births, [](const BirthVertex& v) { return v.position; });
    extend(mesh.points, births, [](const BirthVertex& v) { return v.point; });
    extend(mesh.normals, births, [&](const BirthVertex& v) {
        return unit_or(mean(mesh.normals, v), mesh.normals[v.of.x]);
    });
    extend(mesh.tangents, births, [&](const BirthVertex& v) {
        const glm::vec4 first = mesh.tangents[v.of.x];
        if (v.weights.x == 1) return first;
        return glm::vec4(unit_or(glm::vec3(mean(mesh.tangents, v)), glm::vec3(first)), first.w);
    });
    extend(mesh.colors, births,
           [&](const BirthVertex& v) { return v.wall ? glm::vec4(1) : mean(mesh.colors, v); });
    for (std::vector<glm::vec2>& set : mesh.uvs)
        extend(set, births, [&](const BirthVertex& v) { return v.wall ? v.uv : mean(set, v); });
    extend(mesh.influences, births,
           [&](const BirthVertex& v) { return mean_influences(mesh.influences, v); });
    for (Mesh::MorphTarget& target : mesh.morph_targets) {
        extend(target.positions, births, blended(target.positions));
        for (std::vector<glm::vec3>* turned : {&target.normals, &target.tangents})
            extend(*turned, births,
                   [&](const BirthVertex& v) { return v.wall ? glm::vec3(0) : mean(*turned, v); });
    }
}

} // namespace trivar
