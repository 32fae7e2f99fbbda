// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/silhouette/leaf_march.h"

#include "core/level/kuhn_cells.h"
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
    const auto n = static_cast<std::size_t>(side_);
    number_.assign(n * n * n, none);
}

void LeafMarcher::begin(const glm::ivec3& first_cell)
{
    origin_ = first_cell * per_voxel_;
    for (const Corner& corner : corners_) number_[corner.at] = none;
    corners_.clear();
}

std::uint32_t LeafMarcher::corner(const glm::ivec3& at)
{
    const auto i = static_cast<std::size_t>(at.x + side_ * (at.y + side_ * at.z));
    if (number_[i] != none) return number_[i];
    const glm::vec3 p = glm::vec3(origin_ + at) / static_cast<float>(per_voxel_);
    const ScalarJet<float> jet = field_.at<1>(p);
    const glm::vec3 sight(view_.sight(glm::dvec3(p)));
    Corner& out = corners_.emplace_back();
    out.at = i;
    out.above = jet.value - level_;
    out.product = jet.gradient[0] * sight.x + jet.gradient[1] * sight.y + jet.gradient[2] * sight.z;
    out.vertex.fill(none);
    return number_[i] = static_cast<std::uint32_t>(corners_.size() - 1);
}

std::uint32_t LeafMarcher::vertex(const glm::ivec3& corner_at, int direction, std::uint32_t from,
                                  std::uint32_t to, LeafMarch& out)
{
    std::uint32_t& known = corners_[from].vertex[static_cast<std::size_t>(direction)];
    if (known != none) return known;
    const auto number = static_cast<std::uint32_t>(out.positions.size());
    known = number;
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
    std::array<std::uint32_t, 8> number;
    unsigned inside = 0, along = 0;
    for (int c = 0; c < 8; ++c) {
        const std::uint32_t n = corner(leaf + steps_of(c));
        const Corner& at = corners_[n];
        number[static_cast<std::size_t>(c)] = n;
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
