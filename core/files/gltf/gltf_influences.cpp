// SPDX-License-Identifier: GPL-3.0-or-later
// This file reads which joints move a vertex, from the attributes of a primitive.
#include "core/files/gltf/gltf_mesh.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace trivar {
namespace {

constexpr double joint_numbers = 65536; // influences hold 16 bits each

using Shares = std::vector<std::pair<float, std::uint16_t>>;

// Keeps the four largest weights of a vertex and makes them sum to 1; false if it has none.
bool settle(Mesh::Influences& out, Shares& all)
{
    std::stable_sort(all.begin(), all.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    double sum = 0;
    for (std::size_t k = 0; k < 4; ++k) sum += std::max(0.0, double(all[k].first));
    if (!(sum > 0)) return false;
    for (std::size_t k = 0; k < 4; ++k) {
        const double share = std::max(0.0, double(all[k].first)) / sum;
        out.weights[static_cast<int>(k)] = static_cast<float>(share);
        out.joints[k] = share > 0 ? all[k].second : std::uint16_t{0};
    }
    return true;
}

// Says whether the weights of a vertex differ from a sum of 1 by more than rounding to bytes can
// cause.
bool is_off_one(const Shares& all)
{
    constexpr double rounded = 0.02;
    double sum = 0;
    for (const auto& [share, joint] : all) sum += std::max(0.0, double(share));
    return sum > 0 && std::abs(sum - 1) > rounded;
}

} // namespace

void GltfMeshes::add_influences(Mesh& mesh, const GltfEntry& attributes, VertexRange added)
{
    std::vector<GltfAccessors::Table> joints, weights;
    std::size_t halves = 0, no_numbers = 0, loose = 0, crowded = 0, unsummed = 0, negative = 0;
    for (int set = 0;; ++set) {
        const std::string j = fmt::format("JOINTS_{}", set), w = fmt::format("WEIGHTS_{}", set);
        const bool has_joints = attributes.has(j.c_str()), has_weights = attributes.has(w.c_str());
        if (set > 0 && has_joints != has_weights) ++halves;
        if (!has_joints || !has_weights) break;
        joints.push_back(table(attributes, j.c_str(), added.count, 4, 4));
        weights.push_back(table(attributes, w.c_str(), added.count, 4, 4));
        no_numbers += joints.back().not_finite + weights.back().not_finite;
    }
    if (joints.empty() && mesh.influences.empty()) return;
    mesh.influences.resize(added.first);
    mesh.influences.resize(added.end());
    Shares all;
    for (std::size_t v = 0; v < added.count && !joints.empty(); ++v) {
        all.clear();
        for (std::size_t set = 0; set < joints.size(); ++set)
            for (std::size_t c = 0; c < 4; ++c) {
                const double joint = double(joints[set].values[4 * v + c]);
                if (!(joint >= 0 && joint < joint_numbers))
                    attributes.fail(fmt::format(
                        "'JOINTS_{}' names joint {}, but joints are counted from 0 to {}", set,
                        joint, joint_numbers - 1));
                all.emplace_back(weights[set].values[4 * v + c], static_cast<std::uint16_t>(joint));
            }
        if (std::ranges::any_of(all, [](const auto& each) { return each.first < 0; })) ++negative;
        if (is_off_one(all)) ++unsummed;
        if (!settle(mesh.influences[added.first + v], all)) ++loose;
        if (all.size() > 4 && all[4].first > 0) ++crowded;
    }
    notices_.add("one value of its vertices is not a finite number and was read as 0",
                 "{0} values of its vertices are not finite numbers and were read as 0",
                 no_numbers);
    notices_.add("one vertex of a skin has no weight and follows its first joint",
                 "{0} vertices of a skin have no weight and follow its first joint", loose);
    notices_.add(
        "one vertex is bound to more than four joints: the four with the largest weights count",
        "{0} vertices are bound to more than four joints: the four with the largest weights count",
        crowded);
    notices_.add("one vertex of a skin has weights that did not sum to 1 and were corrected",
                 "{0} vertices of a skin have weights that did not sum to 1 and were corrected",
                 unsummed);
    notices_.add("one vertex of a skin has a negative weight, which counts as none",
                 "{0} vertices of a skin have a negative weight, which counts as none", negative);
    notices_.add("one part of a mesh has further joints without weights, or weights without "
                 "joints, which were left out",
                 "{0} parts of meshes have further joints without weights, or weights without "
                 "joints, which were left out",
                 halves);
}

} // namespace trivar
