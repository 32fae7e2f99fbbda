// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lines/zero_lines.h"

#include "core/base/key_numbers.h"
#include "core/base/parallel.h"
#include "core/silhouette/edge_chains.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr std::size_t triangles_per_zero_block = 8192;
constexpr float alike = 0.7f;         // cosine between directions that are one
constexpr float hardly_zero = 1e-30f; // stands for 0, whose sign could not be turned round
constexpr float full = 3;             // times `strong`, from where on a line is as wide as it gets

struct StrongTriangle {
    CrossedTriangle edges;
    float strength;
};

// The strengths of edges: the mean of the triangles that a line crosses on both sides.
class EdgeStrengths {
public:
    explicit EdgeStrengths(std::size_t triangles) : numbers_(2 * triangles) {}
    void add(const StrongTriangle& triangle)
    {
        for (const std::uint64_t edge : {triangle.edges.in, triangle.edges.out}) {
            const auto [number, is_new] = numbers_.number(edge);
            if (is_new) sums_.push_back({0, 0});
            sums_[number].strength += triangle.strength;
            ++sums_[number].triangles;
        }
    }
    int triangles(std::uint64_t edge) const { return sums_[numbers_.find(edge)].triangles; }
    float operator[](std::uint64_t edge) const
    {
        const Sum& sum = sums_[numbers_.find(edge)];
        return sum.strength / static_cast<float>(sum.triangles);
    }

private:
    struct Sum {
        float strength;
        int triangles;
    };
    KeyNumbers numbers_;
    std::vector<Sum> sums_;
};

// Averages the values along a chain with their neighbours; the ends of an open one stay.
template <class Value> void smooth_along(std::vector<Value>& values, bool closed, int times)
{
    const std::size_t n = values.size();
    if (n < 3) return;
    std::vector<Value> next(n);
    for (int k = 0; k < times; ++k) {
        for (std::size_t i = 0; i < n; ++i)
            next[i] =
                !closed && (i == 0 || i + 1 == n)
                    ? values[i]
                    : (values[(i + n - 1) % n] + 2.0f * values[i] + values[(i + 1) % n]) / 4.0f;
        values.swap(next);
    }
}

class ZeroTracer {
public:
    ZeroTracer(const SurfaceShape& shape, const ZeroFunction& function,
               const LineThresholds& thresholds)
        : shape_(shape),
          function_(function),
          thresholds_(thresholds)
    {
    }
    Silhouettes operator()()
    {
        std::vector<StrongTriangle> triangles = crossed_triangles();
        EdgeStrengths strengths(triangles.size());
        for (const StrongTriangle& each : triangles) strengths.add(each);
        std::vector<std::vector<CrossedTriangle>> crossed(1);
        for (const StrongTriangle& each : triangles) // lines end where three sheets meet
            if (strengths.triangles(each.edges.in) <= 2 && strengths.triangles(each.edges.out) <= 2)
                crossed[0].push_back(each.edges);
        const EdgeChains chains = edge_chains(crossed);
        for (std::size_t c = 0; c < chains.count(); ++c) add_chain(chains, c, strengths);
        return std::move(out_);
    }

private:
    float value(std::uint32_t vertex) const
    {
        const float v = function_.values[vertex];
        return v == 0 ? hardly_zero : v;
    }
    // The values at the corners of a triangle, with signs that agree; false where they cannot.
    bool take_values(const std::uint32_t* v, std::array<float, 3>& out) const
    {
        out = {value(v[0]), value(v[1]), value(v[2])};
        if (function_.directions.empty()) return true;
        const auto cosine = [&](std::size_t i, std::size_t j) {
            return glm::dot(function_.directions[v[i]], function_.directions[v[j]]);
        };
        const float first = cosine(0, 1), second = cosine(0, 2), third = cosine(1, 2);
        if (std::min({std::abs(first), std::abs(second), std::abs(third)}) < alike) return false;
        if (((first < 0) != (second < 0)) != (third < 0)) return false;
        if (first < 0) out[1] = -out[1];
        if (second < 0) out[2] = -out[2];
        return true;
    }
    std::vector<StrongTriangle> crossed_triangles() const
    {
        const std::size_t count = shape_.corners.size() / 3;
        std::vector<std::vector<StrongTriangle>> parts((count + triangles_per_zero_block - 1) /
                                                       triangles_per_zero_block);
        parallel_blocks(count, triangles_per_zero_block, [&](std::size_t begin, std::size_t end) {
            std::vector<StrongTriangle>& part = parts[begin / triangles_per_zero_block];
            for (std::size_t t = begin; t < end; ++t) {
                const std::uint32_t* v = shape_.corners.data() + 3 * t;
                std::array<float, 3> values;
                if (!take_values(v, values)) continue;
                const unsigned signs = unsigned{values[0] > 0} | unsigned{values[1] > 0} << 1 |
                                       unsigned{values[2] > 0} << 2;
                if (signs == 0 || signs == 7) continue;
                const float strength = function_.strength(t, values);
                constexpr std::array<std::uint8_t, 8> alone{0, 0, 1, 2, 2, 1, 0, 0}; // corner
                const unsigned i = alone[signs];
                part.push_back({{edge_key(v[i], v[(i + 1) % 3]), edge_key(v[i], v[(i + 2) % 3])},
                                std::max(0.0f, strength)});
            }
        });
        std::vector<StrongTriangle> out;
        for (const std::vector<StrongTriangle>& part : parts)
            out.insert(out.end(), part.begin(), part.end());
        return out;
    }
    SilhouettePoint point(std::uint64_t edge, float strength) const
    {
        const auto a = static_cast<std::uint32_t>(edge >> 32),
                   b = static_cast<std::uint32_t>(edge & 0xFFFFFFFF);
        const float at_a = std::abs(value(a)), at_b = std::abs(value(b)), sum = at_a + at_b,
                    share = std::isfinite(sum) ? at_a / sum : 0.5f;
        const float widest = full * thresholds_.strong;
        return {.p = glm::mix(shape_.positions[a], shape_.positions[b], share),
                .edge = edge,
                .strength = widest > thresholds_.weak ? std::clamp((strength - thresholds_.weak) /
                                                                       (widest - thresholds_.weak),
                                                                   0.0f, 1.0f)
                                                      : 1};
    }
    void add_chain(const EdgeChains& chains, std::size_t c, const EdgeStrengths& strengths)
    {
        const std::span<const std::uint64_t> edges(chains.edges.data() + chains.first[c],
                                                   chains.edges.data() + chains.first[c + 1]);
        const bool closed = chains.closed[c];
        std::vector<float> strength;
        for (const std::uint64_t edge : edges) strength.push_back(strengths[edge]);
        smooth_along(strength, closed, thresholds_.smoothing);
        const std::size_t n = edges.size();
        const auto is_in = [&](std::size_t i) { return strength[i % n] > thresholds_.weak; };
        std::size_t begin = 0;
        if (closed) {
            while (begin < n && is_in(begin)) ++begin;
            if (begin == n) return add_piece(edges, strength, 0, n, true);
        }
        // The walk begins at a weak point, so that no piece of a loop goes over its first point.
        for (std::size_t i = begin; i < begin + n;) {
            if (!is_in(i)) {
                ++i;
                continue;
            }
            std::size_t end = i;
            while (end < begin + n && is_in(end)) ++end;
            add_piece(edges, strength, i, end, false);
            i = end;
        }
    }
    void add_piece(std::span<const std::uint64_t> edges, const std::vector<float>& strength,
                   std::size_t begin, std::size_t end, bool closed)
    {
        const std::size_t n = edges.size(), before = out_.points.size();
        float greatest = 0, length = 0;
        for (std::size_t i = begin; i < end; ++i) greatest = std::max(greatest, strength[i % n]);
        if (end - begin < 2 || greatest < thresholds_.strong) return;
        std::vector<SilhouettePoint> piece;
        std::vector<glm::vec3> places;
        for (std::size_t i = begin; i < end; ++i) {
            piece.push_back(point(edges[i % n], strength[i % n]));
            places.push_back(piece.back().p);
        }
        smooth_along(places, closed, thresholds_.rounding);
        for (std::size_t i = 0; i < piece.size(); ++i) piece[i].p = places[i];
        const auto at = [&](std::size_t i) { return piece[i - begin]; };
        for (std::size_t i = begin; i < end; ++i) {
            const SilhouettePoint next = at(i);
            const bool stays = i == begin || (!closed && i + 1 == end);
            if (!stays && glm::distance(next.p, out_.points.back().p) < thresholds_.spacing)
                continue;
            if (i > begin) length += glm::distance(next.p, out_.points.back().p);
            out_.points.push_back(next);
        }
        if (closed && out_.points.size() - before < 3 && end - begin >= 3) {
            out_.points.resize(before);
            for (std::size_t e = 0; e < 3; ++e)
                out_.points.push_back(at(begin + e * (end - begin) / 3));
        }
        if (length < thresholds_.shortest) return out_.points.resize(before);
        out_.first.push_back(static_cast<std::uint32_t>(out_.points.size()));
        out_.closed.push_back(closed);
    }

    const SurfaceShape& shape_;
    const ZeroFunction& function_;
    const LineThresholds& thresholds_;
    Silhouettes out_;
};

} // namespace

Silhouettes zero_lines(const SurfaceShape& shape, const ZeroFunction& function,
                       const LineThresholds& thresholds)
{
    return ZeroTracer(shape, function, thresholds)();
}

} // namespace trivar
