// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/silhouette/level_mesh.h"

#include "core/base/parallel.h"
#include "core/silhouette/kuhn_cells.h"
#include "core/silhouette/level_bricks.h"

#include <cmath>

namespace trivar {
namespace {

constexpr float edge_tolerance = 2e-6f; // share of a lattice edge
constexpr int most_edge_steps = 24;
constexpr float nearly = 1e-3f; // from where one more Newton step is enough

// A point of the level with the field there.
struct LevelPoint {
    glm::vec3 p;
    ScalarJet<float> jet;
};

// The root of the field on a lattice edge, by Newton's method in a bracket. `first` and `last` are
// the field less the level at its ends, of which just one is negative.
LevelPoint root_on_edge(const ScalarField<float>& field, float level, const glm::vec3& from,
                        const glm::vec3& step, float first, float last, LevelAccuracy accuracy)
{
    const bool rises = first < 0;
    float lo = 0, hi = 1, t = first / (first - last);
    ScalarJet<float> jet;
    const auto look = [&] { jet = field.at<1>(from + t * step); };
    const auto newton = [&] {
        const float slope =
            jet.gradient[0] * step.x + jet.gradient[1] * step.y + jet.gradient[2] * step.z;
        return slope == 0 ? -1 : t - (jet.value - level) / slope;
    };
    for (int k = 0;; ++k) {
        look();
        ((jet.value - level < 0) == rises ? lo : hi) = t;
        float next = newton();
        if (accuracy == LevelAccuracy::quick && next > 0 && next < 1) {
            t = next;
            break;
        }
        if (!(next > lo && next < hi)) next = (lo + hi) / 2;
        const float move = std::abs(next - t);
        t = next;
        if (move < edge_tolerance || hi - lo < edge_tolerance || k >= most_edge_steps) break;
        if (move < nearly) {
            look();
            if (const float last_step = newton(); std::abs(last_step - t) < 1e-2f)
                t = std::clamp(last_step, 0.0f, 1.0f);
            break;
        }
    }
    return {from + t * step, jet};
}

// Makes the level's mesh from its bricks.
template <class Sample> class LevelBuilder {
public:
    LevelBuilder(const ScalarField<float>& field, std::span<const Sample> samples,
                 const LatticeSigns& signs, float level, LevelAccuracy accuracy, LevelMesh& mesh)
        : field_(field),
          samples_(samples),
          signs_(signs),
          bricks_(level_bricks(signs)),
          level_(level),
          accuracy_(accuracy),
          mesh_(mesh)
    {
    }
    void operator()()
    {
        mesh_.level = level_;
        mesh_.positions.resize(bricks_.vertices);
        for (std::vector<float>* each :
             {&mesh_.normal_x, &mesh_.normal_y, &mesh_.normal_z, &mesh_.offset})
            each->resize(bricks_.vertices);
        mesh_.corners.resize(3 * std::size_t{bricks_.triangles});
        mesh_.bricks.resize(bricks_.all.size());
        std::uint32_t runs = 0;
        for (std::size_t b = 0; b < bricks_.all.size(); ++b) {
            mesh_.bricks[b].first_run = runs;
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
                set_vertex(vertex, root_on_edge(field_, level_, glm::vec3(at), glm::vec3(step),
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
        mesh_.offset[v] = -glm::dot(point.p, n);
    }
    void join_triangles(const LevelBrick& from, LevelMesh::Brick& to)
    {
        to.first_vertex = from.first_vertex;
        to.vertex_end = from.first_vertex + from.vertices;
        to.first_triangle = from.first_triangle;
        to.triangle_end = from.first_triangle + from.triangles;
        to.middle = glm::vec3(8 * from.at) + LevelMesh::half_brick;
        to.owner_count = 0;
        std::array<const LevelBrick*, 8> round{};
        for (int c = 0; c < 8; ++c) {
            const LevelBrick* near = bricks_.at(from.at + glm::ivec3(c & 1, c >> 1 & 1, c >> 2));
            round[static_cast<std::size_t>(c)] = near;
            if (near)
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
                            const int owner = (p.x >> 3) | (p.y >> 3) << 1 | (p.z >> 3) << 2;
                            mesh_.corners[corner++] =
                                round[static_cast<std::size_t>(owner)]->vertex(p & 7,
                                                                               edge.direction);
                        }
                });
    }
    // Widened by what rounding may make of a product with a view.
    void bound_runs(const LevelMesh::Brick& brick)
    {
        constexpr float of_normals = 1e-6f, of_offsets = 2e-4f;
        std::uint32_t r = brick.first_run;
        for (std::uint32_t t = brick.first_triangle; t < brick.triangle_end;
             t += LevelMesh::run_length, ++r) {
            LevelMesh::Run& run = mesh_.runs[r];
            run.least.fill(1e30f);
            run.greatest.fill(-1e30f);
            const std::uint32_t end = std::min(t + LevelMesh::run_length, brick.triangle_end);
            for (std::size_t c = 3 * std::size_t{t}; c < 3 * std::size_t{end}; ++c) {
                const std::uint32_t v = mesh_.corners[c];
                const glm::vec3 n(mesh_.normal_x[v], mesh_.normal_y[v], mesh_.normal_z[v]);
                const std::array<float, 4> of{n.x, n.y, n.z,
                                              mesh_.offset[v] + glm::dot(brick.middle, n)};
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
    LevelMesh& mesh_;
};

} // namespace

std::size_t LevelMesh::bytes() const
{
    return positions.size() * (sizeof(glm::vec3) + 4 * sizeof(float)) +
           corners.size() * sizeof(std::uint32_t) + bricks.size() * sizeof(Brick) +
           runs.size() * sizeof(Run);
}

template <class Sample>
LevelMesh level_mesh(const ScalarField<float>& field, std::span<const Sample> samples, float level,
                     LevelAccuracy accuracy)
{
    LevelMesh out;
    const LatticeSigns signs(samples, field.size(), level);
    LevelBuilder<Sample>(field, samples, signs, level, accuracy, out)();
    return out;
}

std::vector<float> lattice_values(const ScalarField<float>& field)
{
    const glm::ivec3& size = field.size();
    const auto width = static_cast<std::size_t>(size.x), height = static_cast<std::size_t>(size.y);
    std::vector<float> out(width * height * static_cast<std::size_t>(size.z));
    parallel_blocks(out.size() / width, 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t r = begin; r < end; ++r)
            for (std::size_t i = 0; i < width; ++i)
                out[width * r + i] =
                    field
                        .at<0>(static_cast<float>(i), static_cast<float>(r % height),
                               static_cast<float>(r / height))
                        .value;
    });
    return out;
}

#define TRIVAR_LEVEL_OF(Sample)                                                              \
    template LevelMesh level_mesh(const ScalarField<float>&, std::span<const Sample>, float, \
                                  LevelAccuracy);
TRIVAR_LEVEL_OF(std::uint8_t)
TRIVAR_LEVEL_OF(std::int8_t)
TRIVAR_LEVEL_OF(std::uint16_t)
TRIVAR_LEVEL_OF(std::int16_t)
TRIVAR_LEVEL_OF(float)
#undef TRIVAR_LEVEL_OF

} // namespace trivar
