// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/silhouette/silhouette_finder.h"

#include "core/base/parallel.h"
#include "core/silhouette/silhouette_curves.h"

#include <numeric>

namespace trivar {
namespace {

constexpr std::size_t bricks_per_view_block = 32;

// Returns the product of view and normal at a vertex. A parallel view needs no position; the 0
// that it would add changes no sign.
template <bool from_an_eye>
[[gnu::always_inline]] inline float product(const LevelMesh& level, std::size_t v,
                                            const glm::vec4& h)
{
    const float of_normal =
        level.normal_x[v] * h.x + level.normal_y[v] * h.y + level.normal_z[v] * h.z;
    return from_an_eye ? of_normal + level.offset(v) * h.w : of_normal;
}
// Computes the products at the vertices from `begin` to before `end`, and whether they are at least
// 0; four at once.
void find_products(const LevelMesh& level, const glm::vec4& h, std::size_t begin, std::size_t end,
                   float* products, std::uint8_t* above)
{
    using FourBytes __attribute__((vector_size(4))) = std::uint8_t;
    const float x = h.x, y = h.y, z = h.z;
    const float *const nx = level.normal_x.data(), *const ny = level.normal_y.data(),
                       *const nz = level.normal_z.data();
    std::size_t v = begin;
    for (; v + 4 <= end; v += 4) {
        const Row4<float> row = row4(nx + v) * x + row4(ny + v) * y + row4(nz + v) * z;
        const FourBytes is_above = __builtin_convertvector((row >= 0) & 1, FourBytes);
        std::memcpy(products + v, &row, sizeof row);
        std::memcpy(above + v, &is_above, sizeof is_above);
    }
    for (; v < end; ++v) {
        products[v] = product<false>(level, v, h);
        above[v] = products[v] >= 0;
    }
}

} // namespace

Silhouettes SilhouetteFinder::operator()(const ScalarField<float>& field, const LevelMesh& level,
                                         const ViewPoint& view, const SilhouetteOptions& options)
{
    const glm::vec4 h(view.at);
    check(view);
    find_runs(level, h, level.bricks.size());
    find_signs(level, h);
    const std::size_t tested = find_triangles(level);
    Silhouettes out = curves(field, level, view, options);
    out.tested = tested;
    return out;
}

std::vector<CrossedTriangle> SilhouetteFinder::crossed(const LevelMesh& level,
                                                       const ViewPoint& view, std::size_t bricks)
{
    const glm::vec4 h(view.at);
    check(view);
    find_runs(level, h, bricks);
    find_signs(level, h);
    find_triangles(level);
    std::vector<CrossedTriangle> out;
    for (const std::vector<CrossedTriangle>& part : crossed_)
        out.insert(out.end(), part.begin(), part.end());
    return out;
}

Silhouettes SilhouetteFinder::curves(const ScalarField<float>& field, const LevelMesh& level,
                                     const ViewPoint& view, const SilhouetteOptions& options)
{
    Silhouettes out = curves_of(edge_chains(crossed_), level.positions, product_, options.spacing);
    for (const std::vector<CrossedTriangle>& part : crossed_) out.crossed += part.size();
    finish(field, level.level, view, options, out);
    return out;
}

void SilhouetteFinder::find_runs(const LevelMesh& level, const glm::vec4& h, std::size_t bricks)
{
    run_changes_.assign(level.runs.size(), 0);
    is_needed_.assign(level.bricks.size(), 0);
    parallel_blocks(bricks, 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) {
            const LevelMesh::Brick& brick = level.bricks[b];
            const glm::vec3 u = glm::vec3(h) - h.w * brick.middle;
            const Row4<float> v{u.x, u.y, u.z, h.w};
            const std::uint32_t runs =
                (brick.triangle_end - brick.first_triangle + LevelMesh::run_length - 1) /
                LevelMesh::run_length;
            for (std::uint32_t r = brick.first_run; r < brick.first_run + runs; ++r) {
                const LevelMesh::Run& run = level.runs[r];
                const Row4<float> p = v * row4(run.least.data()), q = v * row4(run.greatest.data()),
                                  least = q < p ? q : p, greatest = p < q ? q : p;
                run_changes_[r] = ((least[0] + least[1]) + least[2]) + least[3] <= 0 &&
                                  ((greatest[0] + greatest[1]) + greatest[2]) + greatest[3] >= 0;
                is_needed_[b] |= run_changes_[r];
            }
        }
    });
    changing_.clear();
    for (std::size_t b = 0; b < bricks; ++b)
        if (is_needed_[b]) changing_.push_back(static_cast<std::uint32_t>(b));
    for (const std::uint32_t b : changing_)
        for (std::uint32_t o = 0; o < level.bricks[b].owner_count; ++o)
            is_needed_[level.bricks[b].owners[o]] = 1;
}

void SilhouetteFinder::find_signs(const LevelMesh& level, const glm::vec4& h)
{
    product_.resize(level.positions.size());
    is_above_.resize(level.positions.size());
    parallel_blocks(level.bricks.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) {
            if (!is_needed_[b]) continue;
            const LevelMesh::Brick& brick = level.bricks[b];
            float* const products = product_.data();
            std::uint8_t* const above = is_above_.data();
            if (h.w == 0) {
                find_products(level, h, brick.first_vertex, brick.vertex_end, products, above);
                continue;
            }
            for (std::size_t v = brick.first_vertex; v < brick.vertex_end; ++v) {
                products[v] = product<true>(level, v, h);
                above[v] = products[v] >= 0;
            }
        }
    });
}

void SilhouetteFinder::add_changing(const LevelMesh& level, const LevelMesh::Brick& brick,
                                    BrickSigns& above, std::vector<CrossedTriangle>& crossed,
                                    std::size_t& tested) const
{
    for (std::size_t o = 0; o < brick.owner_count; ++o) {
        const LevelMesh::Brick& owner = level.bricks[brick.owners[o]];
        std::copy(is_above_.data() + owner.first_vertex, is_above_.data() + owner.vertex_end,
                  above.data() + (o << LevelMesh::owner_shift));
    }
    std::uint32_t r = brick.first_run;
    for (std::uint32_t first = brick.first_triangle; first < brick.triangle_end;
         first += LevelMesh::run_length, ++r) {
        if (!run_changes_[r]) continue;
        const std::uint32_t end = std::min(first + LevelMesh::run_length, brick.triangle_end);
        tested += end - first;
        for (std::uint32_t t = first; t < end; ++t) {
            const LevelMesh::Corner* const c = level.corners.data() + 3 * std::size_t{t};
            const unsigned a0 = above[c[0]], a1 = above[c[1]], a2 = above[c[2]];
            if ((a0 + a1 + a2) % 3 != 0)
                add_crossed(level.vertices(brick, t).data(), a0 | a1 << 1 | a2 << 2, crossed);
        }
    }
}

std::size_t SilhouetteFinder::find_triangles(const LevelMesh& level)
{
    const std::size_t blocks =
        (changing_.size() + bricks_per_view_block - 1) / bricks_per_view_block;
    crossed_.resize(blocks);
    std::vector<std::size_t> tested(blocks, 0);
    parallel_blocks(changing_.size(), bricks_per_view_block,
                    [&](std::size_t begin, std::size_t end) {
                        const std::size_t block = begin / bricks_per_view_block;
                        crossed_[block].clear();
                        BrickSigns above; // set where it is read
                        for (std::size_t i = begin; i < end; ++i)
                            add_changing(level, level.bricks[changing_[i]], above, crossed_[block],
                                         tested[block]);
                    });
    return std::accumulate(tested.begin(), tested.end(), std::size_t{0});
}

} // namespace trivar
