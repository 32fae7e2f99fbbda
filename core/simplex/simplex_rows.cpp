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

// The functions of all layers at a point; control points of later layers count on.
class Evaluation {
public:
    Evaluation(std::span<const Ref<SimplexBasis<3>>> layers, bool gradients)
        : layers_(layers),
          gradients_(gradients)
    {
    }
    // Returns the sum of the values of the first layer.
    double operator()(const glm::dvec3& x, std::vector<BasisValue<3>>& out)
    {
        layers_.front()->values_at(x, gradients_, out);
        double sum = 0;
        for (const BasisValue<3>& each : out) sum += each.value;
        std::size_t before = layers_.front()->point_count();
        for (const Ref<SimplexBasis<3>>& layer : layers_.subspan(1)) {
            layer->values_at(x, gradients_, more_);
            for (BasisValue<3>& each : more_) {
                each.point += static_cast<int>(before);
                out.push_back(each);
            }
            before += layer->point_count();
        }
        return sum;
    }

private:
    std::span<const Ref<SimplexBasis<3>>> layers_;
    bool gradients_;
    std::vector<BasisValue<3>> more_;
};

} // namespace

SimplexRows::Chunk SimplexRows::bound(std::span<const Ref<SimplexBasis<3>>> layers,
                                      std::span<const glm::vec3> points,
                                      std::span<const std::uint32_t> order, bool gradients)
{
    const std::size_t rows = gradients ? 4 : 1;
    Chunk chunk;
    Evaluation evaluate(layers, gradients);
    std::array<std::vector<BasisValue<3>>, eight> values;
    std::vector<std::uint32_t> list;
    for (std::size_t first = 0; first < order.size(); first += eight) {
        const std::size_t count = std::min(eight, order.size() - first);
        list.clear();
        for (std::size_t i = 0; i < count; ++i) {
            const double sum = evaluate(points[order[first + i]], values[i]);
            chunk.outside += std::abs(sum - 1) > 1e-6 ? 1 : 0;
            for (const BasisValue<3>& value : values[i])
                list.push_back(static_cast<std::uint32_t>(value.point));
        }
        // Ascending, so that equal points get equal bits in any block.
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
        const std::size_t begin = chunk.functions.size();
        chunk.functions.insert(chunk.functions.end(), list.begin(), list.end());
        chunk.weights.resize(chunk.functions.size() * eight * rows);
        for (std::size_t i = 0; i < count; ++i)
            for (const BasisValue<3>& value : values[i]) {
                const auto place = static_cast<std::size_t>(
                    std::lower_bound(list.begin(), list.end(),
                                     static_cast<std::uint32_t>(value.point)) -
                    list.begin());
                float* const w = &chunk.weights[(begin + place) * eight * rows + i];
                w[0] += static_cast<float>(value.value);
                for (std::size_t axis = 0; axis + 1 < rows; ++axis)
                    w[eight * (axis + 1)] +=
                        static_cast<float>(value.gradient[static_cast<int>(axis)]);
            }
        chunk.blocks.push_back(
            {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(list.size())});
    }
    chunk.weights.shrink_to_fit();
    return chunk;
}

SimplexRows::SimplexRows(std::span<const Ref<SimplexBasis<3>>> layers,
                         std::span<const glm::vec3> points, bool gradients)
    : points_(points.begin(), points.end()),
      order_(order_by_place(points)),
      chunks_((points.size() + chunk_size - 1) / chunk_size),
      gradients_(gradients)
{
    parallel_blocks(points.size(), chunk_size, [&](std::size_t begin, std::size_t end) {
        chunks_[begin / chunk_size] =
            bound(layers, points_, std::span(order_).subspan(begin, end - begin), gradients);
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
