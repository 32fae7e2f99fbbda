// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/extent.h"

#include "core/base/finite.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

// Largest entry of a matrix for positions: squares of its cofactors stay within double precision.
constexpr double most_factor = 1e30;

template <class T> bool all_finite(const std::vector<T>& values)
{
    return std::ranges::all_of(values, [](const T& value) { return finite(value); });
}

bool all_finite(const Mesh& mesh)
{
    return all_finite(mesh.positions) && all_finite(mesh.normals) && all_finite(mesh.tangents) &&
           all_finite(mesh.colors) &&
           std::ranges::all_of(mesh.uvs, [](const auto& set) { return all_finite(set); });
}

bool all_finite(const std::vector<Mesh::MorphTarget>& targets)
{
    return std::ranges::all_of(targets, [](const Mesh::MorphTarget& target) {
        return all_finite(target.positions) && all_finite(target.normals) &&
               all_finite(target.tangents);
    });
}

// Says whether the products and sums of a pose stay within single precision: no number is too
// large.
bool small_enough(const Pose& pose)
{
    const auto small = [](float value) { return std::abs(value) <= static_cast<float>(1e18); };
    for (const glm::mat4& joint : pose.joints)
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row)
                if (!small(joint[column][row])) return false;
    return std::ranges::all_of(pose.morph_weights, small);
}

} // namespace

bool within_reach(const Box& box, const glm::dmat4& matrix)
{
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!(std::abs(matrix[column][row]) <= most_factor)) return false;
    if (box.empty()) return finite(box.lo) && finite(box.hi);
    return std::ranges::all_of(box.corners(), [&](const glm::dvec3& corner) {
        const glm::dvec3 p = glm::abs(glm::dvec3(matrix * glm::dvec4(corner, 1)));
        return p.x <= most_coordinate && p.y <= most_coordinate && p.z <= most_coordinate;
    });
}

Extent::Extent(const Ref<Mesh>& mesh)
    : mesh_(mesh),
      box_(bounding_box(*mesh)),
      finite_(all_finite(*mesh) && all_finite(mesh->morph_targets)),
      targets_([mesh] { return target_bounds(*mesh); })
{
}

Extent::Extent(const Ref<Mesh>& mesh, const Extent& other, const Box& box)
    : mesh_(mesh),
      box_(box),
      finite_(other.finite_ && finite(box.lo) && finite(box.hi)),
      targets_([mesh] { return target_bounds(*mesh); })
{
}

std::optional<Box> Extent::posed(const Pose* pose) const
{
    if (!finite_) return {};
    if (!pose || pose->empty()) return within_reach(box_) ? std::optional(box_) : std::nullopt;
    if (small_enough(*pose)) {
        const bool morphs = !pose->morph_weights.empty();
        const Box rough = posed_bounds(box_, morphs ? *targets_ : std::vector<Box>(), *pose);
        if (within_reach(rough)) return rough;
    }
    const Mesh exact = trivar::posed(*mesh_, *pose); // a distant joint may have no weight
    const Box box = bounding_box(exact);
    return all_finite(exact) && within_reach(box) ? std::optional(box) : std::nullopt;
}

bool too_large(const Model& model)
{
    const Stance stance = stance_at(model, nullptr, 0);
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        const int node = static_cast<int>(i), mesh = model.nodes[i].mesh;
        if (const int curves = model.nodes[i].curves;
            curves >= 0 &&
            !within_reach(bounding_box(*model.curves[static_cast<std::size_t>(curves)]->points),
                          stance.to_model[i]))
            return true;
        if (mesh < 0) continue;
        const Pose pose = pose_of(model, node, stance);
        const std::optional<Box> box =
            Extent(model.meshes[static_cast<std::size_t>(mesh)]).posed(&pose);
        if (!box || !within_reach(*box, mesh_to_model(model, node, stance))) return true;
    }
    return false;
}

} // namespace trivar
