// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/level/level_mesh.h"

#include "core/base/parallel.h"
#include "core/level/kuhn_cells.h"
#include "core/level/level_bricks.h"

#include <cmath>

namespace trivar {
namespace {

constexpr float edge_tolerance = 2e-6f; // share of a lattice edge
constexpr int most_edge_steps = 24;
constexpr float nearly = 1e-3f; // a Newton step after which no other is needed
constexpr int cubic_steps = 3;

// A point of the level with the field there.
struct LevelPoint {
    glm::vec3 p;
    ScalarJet<float> jet;
};

// The change of a share t of an edge to the root of the cubic that has these values at 0, 1 and t
// and this slope at t; that of the tangent if t is all but at an end.
float cubic_step(float first, float last, float t, float value, float slope)
{
    const float tangent = -value / slope, s = 1 - t;
    if (!(std::min(t, s) > nearly)) return tangent;
    // value + slope u + a u^2 + b u^3 in u, from t on
    const float at_first = (first - value + slope * t) / (t * t),
                at_last = (last - value - slope * s) / (s * s), b = at_last - at_first,
                a = at_first + b * t;
    float u = tangent;
    for (int k = 0; k < cubic_steps; ++k)
        u -= (value + u * (slope + u * (a + u * b))) / (slope + u * (2 * a + u * 3 * b));
    return u;
}

// The root of the field on a lattice edge, by Newton's method in a bracket. `first` and `last` are
// the field less the level at its ends, of which just one is negative. Along an axis of the grid
// the field is a cubic, which two values and one value with its slope tell.
LevelPoint root_on_edge(const ScalarField<float>& field, float level, const glm::vec3& from,
                        const glm::vec3& step, float first, float last, LevelAccuracy accuracy)
{
    const bool rises = first < 0;
    float lo = 0, hi = 1, t = first / (first - last);
    ScalarJet<float> jet;
    for (int k = 0;; ++k) {
        jet = field.at<1>(from + t * step);
        const float value = jet.value - level, slope = glm::dot(gradient_of(jet), step);
        ((value < 0) == rises ? lo : hi) = t;
        const float move = k == 0 ? cubic_step(first, last, t, value, slope) : -value / slope,
                    next = t + move; // neither is a number where the slope is 0
        if (std::abs(move) < (k == 0 ? edge_tolerance : nearly)) {
            t = std::clamp(next, 0.0f, 1.0f);
            break;
        }
        const bool stays_between = next > lo && next < hi;
        t = stays_between ? next : (lo + hi) / 2;
        if (accuracy == LevelAccuracy::quick && stays_between) break;
        if (hi - lo < edge_tolerance || k >= most_edge_steps) break;
    }
    return {from + t * step, jet};
}

// Makes the level's mesh from its bricks.
template <class Sample> class LevelBuilder {
public:
    LevelBuilder(const ScalarField<float>& field, std::span<const Sample> samples,
                 const LatticeSigns& signs, float level, LevelAccuracy accuracy, int first_slice,
                 LevelMesh& mesh)
        : field_(field),
          samples_(samples),
          signs_(signs),
          bricks_(level_bricks(signs)),
          level_(level),
          accuracy_(accuracy),
          from_(0, 0, first_slice),
          mesh_(mesh)
    {
    }
    void operator()()
    {
        mesh_.level = level_;
        mesh_.positions.resize(bricks_.vertices);
        for (std::vector<float>* each : {&mesh_.normal_x, &mesh_.normal_y, &mesh_.normal_z})
            each->resize(bricks_.vertices);
        mesh_.corners.resize(3 * std::size_t{bricks_.triangles});
        mesh_.bricks.resize(bricks_.all.size());
        std::uint32_t runs = 0;
        for (std::size_t b = 0; b < bricks_.all.size(); ++b) {
            LevelMesh::Brick& brick = mesh_.bricks[b];
            brick.first_vertex = bricks_.all[b].first_vertex;
            brick.vertex_end = brick.first_vertex + bricks_.all[b].vertices;
            brick.first_triangle = bricks_.all[b].first_triangle;
            brick.triangle_end = brick.first_triangle + bricks_.all[b].triangles;
            brick.first_run = runs;
            runs += (bricks_.all[b].triangles + LevelMesh::run_length - 1) / LevelMesh::run_length;
        }
        mesh_.runs.resize(runs);
        for_bricks([&](std::size_t b) { find_vertices(bricks_.all[b]); });
        for_bricks([&](std::size_t b) {
            join_triangles(bricks_.all[b], mesh_.bricks[b]);
            bound_runs(mesh_.bricks[b]);
        });
    }

private:
    void for_bricks(auto&& use) const
    {
        parallel_blocks(bricks_.all.size(), 4, [&](std::size_t begin, std::size_t end) {
            for (std::size_t b = begin; b < end; ++b) use(b);
        });
    }
    void find_vertices(const LevelBrick& brick)
    {
        const auto width = static_cast<std::size_t>(signs_.size().x),
                   plane = width * static_cast<std::size_t>(signs_.size().y);
        std::size_t vertex = brick.first_vertex;
        for (int row = 0; row < 64; ++row)
            for (std::uint64_t left = brick.crossing[static_cast<std::size_t>(row)]; left;
                 left &= left - 1, ++vertex) {
                const int bit = std::countr_zero(left), d = bit >> 3;
                const glm::ivec3 at = 8 * brick.at + glm::ivec3(bit & 7, row & 7, row >> 3),
                                 step(d & 1, d >> 1 & 1, d >> 2);
                const auto offset = [&](const glm::ivec3& p) {
                    return static_cast<std::size_t>(p.x) + width * static_cast<std::size_t>(p.y) +
                           plane * static_cast<std::size_t>(p.z);
                };
                const auto above = [&](const glm::ivec3& p) {
                    return static_cast<float>(samples_[offset(p)]) - level_;
                };
                set_vertex(vertex,
                           root_on_edge(field_, level_, glm::vec3(from_ + at), glm::vec3(step),
                                        above(at), above(at + step), accuracy_));
            }
    }
    void set_vertex(std::size_t v, const LevelPoint& point)
    {
        const glm::vec3 g = gradient_of(point.jet);
        const float length = glm::length(g);
        const glm::vec3 n = length > 0 ? g / length : glm::vec3(0);
        mesh_.positions[v] = point.p;
        mesh_.normal_x[v] = n.x;
        mesh_.normal_y[v] = n.y;
        mesh_.normal_z[v] = n.z;
    }
    void join_triangles(const LevelBrick& from, LevelMesh::Brick& to)
    {
        to.middle = glm::vec3(from_ + 8 * from.at) + LevelMesh::half_brick;
        to.owner_count = 0;
        std::array<const LevelBrick*, 8> round{};
        std::array<std::uint32_t, 8> owner{};
        for (int c = 0; c < 8; ++c) {
            const LevelBrick* near = bricks_.at(from.at + glm::ivec3(c & 1, c >> 1 & 1, c >> 2));
            round[static_cast<std::size_t>(c)] = near;
            if (!near) continue;
            owner[static_cast<std::size_t>(c)] = to.owner_count << LevelMesh::owner_shift;
            to.owners[to.owner_count++] = static_cast<std::uint32_t>(near - bricks_.all.data());
        }
        std::size_t corner = 3 * std::size_t{from.first_triangle};
        for (int z = 0; z < 8; ++z)
            for (int y = 0; y < 8; ++y)
                for_cells(signs_, from.at, y, z, [&](int x, std::uint8_t inside) {
                    for (const auto& triangle : kuhn_triangles(inside))
                        for (const KuhnEdge& edge : triangle) {
                            const glm::ivec3 p =
                                glm::ivec3(x, y, z) +
                                glm::ivec3(edge.corner & 1, edge.corner >> 1 & 1, edge.corner >> 2);
                            const auto n = static_cast<std::size_t>((p.x >> 3) | (p.y >> 3) << 1 |
                                                                    (p.z >> 3) << 2);
                            mesh_.corners[corner++] = static_cast<LevelMesh::Corner>(
                                owner[n] | round[n]->edge(p & 7, edge.direction));
                        }
                });
    }
    // Bounds a brick's runs, widened by the rounding of a product with a view.
    void bound_runs(const LevelMesh::Brick& brick)
    {
        constexpr float of_normals = 1e-6f, of_places = 1e-6f, least_of_offsets = 2e-4f;
        const glm::ivec3 last = field_.end();
        const float of_offsets = std::max(
            least_of_offsets, of_places * static_cast<float>(std::max({last.x, last.y, last.z})));
        std::uint32_t r = brick.first_run;
        for (std::uint32_t t = brick.first_triangle; t < brick.triangle_end;
             t += LevelMesh::run_length, ++r) {
            LevelMesh::Run& run = mesh_.runs[r];
            run.least.fill(1e30f);
            run.greatest.fill(-1e30f);
            const std::uint32_t end = std::min(t + LevelMesh::run_length, brick.triangle_end);
            for (std::size_t c = 3 * std::size_t{t}; c < 3 * std::size_t{end}; ++c) {
                const std::uint32_t v = mesh_.vertex(brick, mesh_.corners[c]);
                const glm::vec3 n(mesh_.normal_x[v], mesh_.normal_y[v], mesh_.normal_z[v]);
                const std::array<float, 4> of{n.x, n.y, n.z,
                                              mesh_.offset(v) + glm::dot(brick.middle, n)};
                for (std::size_t k = 0; k < 4; ++k) {
                    run.least[k] = std::min(run.least[k], of[k]);
                    run.greatest[k] = std::max(run.greatest[k], of[k]);
                }
            }
            for (std::size_t k = 0; k < 4; ++k) {
                run.least[k] -= k < 3 ? of_normals : of_offsets;
                run.greatest[k] += k < 3 ? of_normals : of_offsets;
            }
        }
    }

    const ScalarField<float>& field_;
    std::span<const Sample> samples_;
    const LatticeSigns& signs_;
    LevelBricks bricks_;
    float level_;
    LevelAccuracy accuracy_;
    glm::ivec3 from_; // the first sample
    LevelMesh& mesh_;
};

} // namespace

std::size_t LevelMesh::bytes() const
{
    return positions.size() * (sizeof(glm::vec3) + 3 * sizeof(float)) +
           corners.size() * sizeof(Corner) + bricks.size() * sizeof(Brick) +
           runs.size() * sizeof(Run);
}

std::vector<std::uint32_t> LevelMesh::triangles() const
{
    std::vector<std::uint32_t> out(corners.size());
    parallel_blocks(bricks.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b)
            for (std::size_t c = 3 * std::size_t{bricks[b].first_triangle};
                 c < 3 * std::size_t{bricks[b].triangle_end}; ++c)
                out[c] = vertex(bricks[b], corners[c]);
    });
    return out;
}

template <class Sample>
LevelMesh level_mesh(const ScalarField<float>& field, std::span<const Sample> samples, float level,
                     LevelAccuracy accuracy, int first_slice)
{
    LevelMesh out;
    const std::size_t of_slice =
        static_cast<std::size_t>(field.size().x) * static_cast<std::size_t>(field.size().y);
    const LatticeSigns signs(
        samples, {field.size().x, field.size().y, static_cast<int>(samples.size() / of_slice)},
        level);
    LevelBuilder<Sample>(field, samples, signs, level, accuracy, first_slice, out)();
    return out;
}

std::vector<float> lattice_values(const ScalarField<float>& field)
{
    const glm::ivec3& size = field.size();
    const auto width = static_cast<std::size_t>(size.x), height = static_cast<std::size_t>(size.y);
    std::vector<float> out(width * height * static_cast<std::size_t>(field.slice_count()));
    const auto first = static_cast<std::size_t>(field.first_slice());
    parallel_blocks(out.size() / width, 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t r = begin; r < end; ++r)
            for (std::size_t i = 0; i < width; ++i)
                out[width * r + i] =
                    field
                        .at<0>(static_cast<float>(i), static_cast<float>(r % height),
                               static_cast<float>(first + r / height))
                        .value;
    });
    return out;
}

#define TRIVAR_LEVEL_OF(Sample)                                                              \
    template LevelMesh level_mesh(const ScalarField<float>&, std::span<const Sample>, float, \
                                  LevelAccuracy, int);
TRIVAR_LEVEL_OF(std::uint8_t)
TRIVAR_LEVEL_OF(std::int8_t)
TRIVAR_LEVEL_OF(std::uint16_t)
TRIVAR_LEVEL_OF(std::int16_t)
TRIVAR_LEVEL_OF(float)
#undef TRIVAR_LEVEL_OF

} // namespace trivar
