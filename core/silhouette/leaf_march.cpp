// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/silhouette/leaf_march.h"

#include "core/silhouette/kuhn_cells.h"
#include "core/silhouette/silhouette_curves.h"

namespace trivar {
namespace {

glm::ivec3 steps_of(int bits)
{
    return {bits & 1, bits >> 1 & 1, bits >> 2};
}

} // namespace

LeafMarcher::LeafMarcher(const ScalarField<float>& field, float level, const ViewPoint& view,
                         int depth)
    : field_(field),
      level_(level),
      view_(view),
      per_voxel_(1 << depth),
      side_(FieldHulls::brick * per_voxel_ + 1)
{
    const auto n = static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_) *
                   static_cast<std::size_t>(side_);
    corners_.resize(n);
    corner_brick_.assign(n, 0);
    edge_brick_.assign(8 * n, 0);
    edge_vertex_.resize(8 * n);
}

void LeafMarcher::begin(const glm::ivec3& first_cell)
{
    origin_ = first_cell * per_voxel_;
    ++brick_;
}

const LeafMarcher::Corner& LeafMarcher::corner(const glm::ivec3& at, std::size_t& number)
{
    number = static_cast<std::size_t>(at.x + side_ * (at.y + side_ * at.z));
    Corner& out = corners_[number];
    if (corner_brick_[number] == brick_) return out;
    corner_brick_[number] = brick_;
    const glm::vec3 p = glm::vec3(origin_ + at) / static_cast<float>(per_voxel_);
    const ScalarJet<float> jet = field_.at<1>(p);
    const glm::vec3 sight(view_.sight(glm::dvec3(p)));
    out = {jet.value - level_,
           jet.gradient[0] * sight.x + jet.gradient[1] * sight.y + jet.gradient[2] * sight.z};
    return out;
}

std::uint32_t LeafMarcher::vertex(const glm::ivec3& corner_at, int direction, std::size_t from,
                                  std::size_t to, LeafMarch& out)
{
    const std::size_t edge = 8 * from + static_cast<std::size_t>(direction);
    if (edge_brick_[edge] == brick_) return edge_vertex_[edge];
    edge_brick_[edge] = brick_;
    const auto number = static_cast<std::uint32_t>(out.positions.size());
    edge_vertex_[edge] = number;
    const Corner &a = corners_[from], &b = corners_[to];
    const float share = a.above / (a.above - b.above);
    const glm::ivec3 step = steps_of(direction), at = origin_ + corner_at;
    out.positions.push_back((glm::vec3(at) + share * glm::vec3(step)) /
                            static_cast<float>(per_voxel_));
    out.product.push_back(a.product + share * (b.product - a.product));
    bool in_a_face = false;
    for (int k = 0; k < 3; ++k)
        in_a_face |= step[k] == 0 && (corner_at[k] == 0 || corner_at[k] == side_ - 1);
    if (in_a_face) {
        const auto part = [&](int k) { return static_cast<std::uint64_t>(at[k]); };
        out.shared.push_back({number, (part(2) << 40 | part(1) << 20 | part(0)) << 3 |
                                          static_cast<std::uint64_t>(direction)});
    }
    return number;
}

void LeafMarcher::add(const glm::ivec3& leaf, LeafMarch& out)
{
    ++out.leaves;
    std::array<std::size_t, 8> number;
    unsigned inside = 0, along = 0;
    for (int c = 0; c < 8; ++c) {
        const Corner& at = corner(leaf + steps_of(c), number[static_cast<std::size_t>(c)]);
        inside |= unsigned{at.above >= 0} << c;
        along |= unsigned{at.product >= 0} << c;
    }
    const std::size_t before = out.triangles.size();
    if (along != 0 && along != 255)
        for (const auto& triangle : kuhn_triangles(static_cast<std::uint8_t>(inside))) {
            std::array<std::uint32_t, 3> v;
            for (std::size_t e = 0; e < 3; ++e) {
                const KuhnEdge& edge = triangle[e];
                v[e] = vertex(leaf + steps_of(edge.corner), edge.direction, number[edge.corner],
                              number[edge.corner | edge.direction], out);
            }
            add_crossed(v.data(), signs_of(v.data(), out.product.data()), out.triangles);
        }
    out.open += out.triangles.size() == before;
}

} // namespace trivar
