// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplex/simplex_rows.h"

#include "core/base/parallel.h"
#include "core/simplex/simplex_product.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace trivar {
namespace {

constexpr std::size_t eight = 8, chunk_size = 4096;

// The bits of a coordinate, with two zeros behind each.
std::uint64_t spread_out(std::uint64_t x)
{
    x &= 0x1fffff;
    x = (x | x << 32) & 0x1f00000000ffffU;
    x = (x | x << 16) & 0x1f0000ff0000ffU;
    x = (x | x << 8) & 0x100f00f00f00f00fU;
    x = (x | x << 4) & 0x10c30c30c30c30c3U;
    return (x | x << 2) & 0x1249249249249249U;
}

// Numbers of points along a curve that stays near [Morton, A computer oriented geodetic data base,
// 1966].
std::vector<std::uint32_t> order_by_place(std::span<const glm::vec3> points)
{
    glm::dvec3 lo(1e300), hi(-1e300);
    for (const glm::vec3& p : points) {
        lo = glm::min(lo, glm::dvec3(p));
        hi = glm::max(hi, glm::dvec3(p));
    }
    const double size = std::max({hi.x - lo.x, hi.y - lo.y, hi.z - lo.z, 1e-300});
    std::vector<std::pair<std::uint64_t, std::uint32_t>> keys;
    keys.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::dvec3 at = (glm::dvec3(points[i]) - lo) * (2097151 / size);
        keys.emplace_back(spread_out(static_cast<std::uint64_t>(at.x)) << 2 |
                              spread_out(static_cast<std::uint64_t>(at.y)) << 1 |
                              spread_out(static_cast<std::uint64_t>(at.z)),
                          static_cast<std::uint32_t>(i));
    }
    std::sort(keys.begin(), keys.end());
    std::vector<std::uint32_t> out;
    out.reserve(keys.size());
    for (const auto& key : keys) out.push_back(key.second);
    return out;
}

// The places of the control points of one block in its list, which are few: an open table.
class Places {
public:
    std::size_t operator()(std::uint32_t point, std::vector<std::uint32_t>& list, std::size_t begin)
    {
        std::size_t at = (point * 2654435761U) >> 22;
        for (;; at = (at + 1) & 1023) {
            if (stamp_[at] != round_) {
                stamp_[at] = round_;
                place_[at] = static_cast<std::uint32_t>(list.size() - begin);
                list.push_back(point);
                return place_[at];
            }
            if (list[begin + place_[at]] == point) return place_[at];
        }
    }
    void clear() { ++round_; }

private:
    std::array<std::uint32_t, 1024> stamp_{}, place_{};
    std::uint32_t round_ = 1;
};

} // namespace

SimplexRows::Chunk SimplexRows::bound(const SimplexBasis<3>& basis,
                                      std::span<const glm::vec3> points,
                                      std::span<const std::uint32_t> order, bool gradients)
{
    const std::size_t rows = gradients ? 4 : 1;
    Chunk chunk;
    Places places;
    std::vector<BasisValue<3>> values;
    for (std::size_t first = 0; first < order.size(); first += eight) {
        const auto begin = static_cast<std::uint32_t>(chunk.functions.size());
        places.clear();
        for (std::size_t i = 0; i < std::min(eight, order.size() - first); ++i) {
            basis.values_at(points[order[first + i]], gradients, values);
            double sum = 0;
            for (const BasisValue<3>& value : values) {
                sum += value.value;
                const std::size_t place =
                    places(static_cast<std::uint32_t>(value.point), chunk.functions, begin);
                chunk.weights.resize(chunk.functions.size() * eight * rows);
                float* const w = &chunk.weights[(begin + place) * eight * rows + i];
                w[0] += static_cast<float>(value.value);
                if (gradients)
                    for (int axis = 0; axis < 3; ++axis)
                        w[eight * static_cast<std::size_t>(axis + 1)] +=
                            static_cast<float>(value.gradient[axis]);
            }
            chunk.outside += std::abs(sum - 1) > 1e-6 ? 1 : 0;
        }
        chunk.blocks.push_back({begin, static_cast<std::uint32_t>(chunk.functions.size()) - begin});
    }
    chunk.weights.shrink_to_fit();
    return chunk;
}

SimplexRows::SimplexRows(const SimplexBasis<3>& basis, std::span<const glm::vec3> points,
                         bool gradients)
    : points_(points.begin(), points.end()),
      order_(order_by_place(points)),
      chunks_((points.size() + chunk_size - 1) / chunk_size),
      gradients_(gradients)
{
    parallel_blocks(points.size(), chunk_size, [&](std::size_t begin, std::size_t end) {
        chunks_[begin / chunk_size] =
            bound(basis, points_, std::span(order_).subspan(begin, end - begin), gradients);
    });
}

std::size_t SimplexRows::outside() const
{
    return std::accumulate(chunks_.begin(), chunks_.end(), std::size_t{0},
                           [](std::size_t sum, const Chunk& c) { return sum + c.outside; });
}

std::size_t SimplexRows::bytes() const
{
    std::size_t out = points_.size() * sizeof(glm::vec3) + order_.size() * sizeof(std::uint32_t);
    for (const Chunk& c : chunks_)
        out += c.blocks.size() * sizeof(Block) + c.functions.size() * sizeof(std::uint32_t) +
               c.weights.size() * sizeof(float);
    return out;
}

DisplacedPoints SimplexRows::displaced(std::span<const glm::dvec3> displacements,
                                       DisplacedPoints reuse) const
{
    std::vector<glm::vec4> by;
    by.reserve(displacements.size());
    for (const glm::dvec3& d : displacements) by.emplace_back(glm::vec3(d), 0);
    const std::size_t rows = gradients_ ? 4 : 1;
    DisplacedPoints out = std::move(reuse);
    out.positions.resize(points_.size());
    out.jacobians.resize(gradients_ ? points_.size() : 0);
    parallel_blocks(points_.size(), chunk_size, [&](std::size_t begin, std::size_t end) {
        const Chunk& chunk = chunks_[begin / chunk_size];
        for (std::size_t b = 0; b < chunk.blocks.size(); ++b) {
            const Block& block = chunk.blocks[b];
            const EightPoints sums = simplex_product(
                std::span(chunk.functions).subspan(block.begin, block.count),
                chunk.weights.data() + block.begin * eight * rows, static_cast<int>(rows), by);
            for (std::size_t i = 0; begin + b * eight + i < end && i < eight; ++i) {
                const std::uint32_t point = order_[begin + b * eight + i];
                out.positions[point] =
                    points_[point] + glm::vec3(sums[0][i], sums[1][i], sums[2][i]);
                if (!gradients_) continue;
                glm::mat3& jacobian = out.jacobians[point];
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const std::size_t row = 3 * (axis + 1);
                    jacobian[static_cast<int>(axis)] =
                        glm::vec3(sums[row][i], sums[row + 1][i], sums[row + 2][i]);
                    jacobian[static_cast<int>(axis)][static_cast<int>(axis)] += 1;
                }
            }
        }
    });
    return out;
}

} // namespace trivar
