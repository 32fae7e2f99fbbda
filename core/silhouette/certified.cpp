// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/silhouette/certified.h"

#include "core/base/key_numbers.h"
#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/field/bezier_net.h"
#include "core/silhouette/leaf_march.h"
#include "core/silhouette/silhouette_curves.h"

#include <memory>
#include <mutex>

namespace trivar {
namespace {

constexpr int most_depth = 5;
constexpr std::size_t bricks_per_block = 16;
constexpr float level_rounding = 1e-6f, sight_rounding = 2e-5f; // of the greatest coefficient

// A box of a cell, which is halved along axis depth % 3.
struct NetBox {
    BezierNet above, along; // D - level and <V, grad D>
    glm::ivec3 at;          // lattice point, from the brick's first cell on
    int halvings;
};

// The least and the greatest coefficient of each of the 4 x 4 x 4 cells of a brick: row y + 4 z
// holds those along x.
struct BrickHulls {
    std::array<Row4<float>, 16> least, greatest;
};

// Computes the hulls of the cells of a brick that exist: along each axis from runs of four
// coefficients.
BrickHulls brick_hulls(const ScalarField<float>& field, const glm::ivec3& first,
                       const glm::ivec3& cells)
{
    using FourFloats = Row4<float>;
    constexpr std::size_t n = FieldHulls::brick, wide = n + 3; // cells, and their coefficients
    const auto lesser = [](const FourFloats& a, const FourFloats& b) { return a < b ? a : b; };
    const auto greater = [](const FourFloats& a, const FourFloats& b) { return a > b ? a : b; };
    const auto of_four = [](const auto& pick, const FourFloats* row) {
        return pick(pick(row[0], row[1]), pick(row[2], row[3]));
    };
    std::array<FourFloats, wide * wide> least{}, greatest{};
    std::array<float, wide> copy{};
    for (int c = 0; c < cells.z + 3; ++c)
        for (int b = 0; b < cells.y + 3; ++b) {
            const float* from = &field.coefficient(first.x - 1, first.y - 1 + b, first.z - 1 + c);
            if (cells.x < FieldHulls::brick) { // what follows is of another row, or not there
                std::copy_n(from, cells.x + 3, copy.begin());
                from = copy.data();
            }
            const std::array<FourFloats, 4> shifted{row4(from), row4(from + 1), row4(from + 2),
                                                    row4(from + 3)};
            const auto row = static_cast<std::size_t>(b) + wide * static_cast<std::size_t>(c);
            least[row] = of_four(lesser, shifted.data());
            greatest[row] = of_four(greater, shifted.data());
        }
    BrickHulls out;
    for (std::size_t j = 0; j < n; ++j) {
        std::array<FourFloats, wide> low, high;
        for (std::size_t c = 0; c < wide; ++c) {
            low[c] = of_four(lesser, &least[j + wide * c]);
            high[c] = of_four(greater, &greatest[j + wide * c]);
        }
        for (std::size_t k = 0; k < n; ++k) {
            out.least[j + n * k] = of_four(lesser, &low[k]);
            out.greatest[j + n * k] = of_four(greater, &high[k]);
        }
    }
    return out;
}

// BrickSearch finds the leaves of one brick after the other.
class BrickSearch {
public:
    BrickSearch(const ScalarField<float>& field, float level, const ViewPoint& view, int depth)
        : field_(field),
          level_(level),
          view_(view),
          depth_(depth),
          marcher_(field, level, view, depth),
          stack_(static_cast<std::size_t>(3 * depth + 2))
    {
    }
    void operator()(const glm::ivec3& first_cell, LeafMarch& out)
    {
        marcher_.begin(first_cell);
        const glm::ivec3 cells = glm::min(field_.size() - 1 - first_cell, FieldHulls::brick);
        const BrickHulls hulls = brick_hulls(field_, first_cell, cells);
        for (int k = 0; k < cells.z; ++k)
            for (int j = 0; j < cells.y; ++j) {
                const auto row = static_cast<std::size_t>(j + FieldHulls::brick * k);
                for (int i = 0; i < cells.x; ++i) {
                    const float least = hulls.least[row][i] - level_,
                                greatest = hulls.greatest[row][i] - level_;
                    if (least <= 0 && greatest >= 0)
                        search(first_cell, {i, j, k}, std::max(-least, greatest), out);
                }
            }
    }

private:
    // The greatest of |D - level| among a cell's coefficients is `scale`.
    void search(const glm::ivec3& first_cell, const glm::ivec3& in_brick, float scale,
                LeafMarch& out)
    {
        const glm::ivec3 cell = first_cell + in_brick;
        NetBox& whole = stack_[0];
        for (int c = 0; c < 4; ++c)
            for (int b = 0; b < 4; ++b)
                whole.above.rows[static_cast<std::size_t>(b + 4 * c)] =
                    row4(&field_.coefficient(cell.x - 1, cell.y - 1 + b, cell.z - 1 + c)) - level_;
        make_bezier(whole.above);
        if (!whole.above.may_vanish(level_rounding * scale)) return;
        const glm::dvec3 from = view_.sight(glm::dvec3(cell));
        whole.along = sight_net(whole.above, glm::vec3(from),
                                view_.at.w == 0 ? Sight::parallel : Sight::from_eye);
        const float sight_scale = scale * std::max(1.0f, static_cast<float>(glm::length(from)));
        if (!whole.along.may_vanish(sight_rounding * sight_scale)) return;
        ++out.cells;
        whole.at = in_brick << depth_;
        whole.halvings = 0;
        halve_all(level_rounding * scale, sight_rounding * sight_scale, out);
    }
    void halve_all(float level_margin, float sight_margin, LeafMarch& out)
    {
        std::size_t count = 1;
        while (count > 0) {
            --count;
            ++out.boxes;
            const NetBox box = stack_[count];
            if (box.halvings == 3 * depth_) {
                marcher_.add(box.at, out);
                continue;
            }
            const int axis = box.halvings % 3;
            NetBox &upper = stack_[count], &lower = stack_[count + 1];
            halve(box.above, axis, lower.above, upper.above);
            bool keeps_lower = lower.above.may_vanish(level_margin),
                 keeps_upper = upper.above.may_vanish(level_margin);
            if (!keeps_lower && !keeps_upper) continue;
            halve(box.along, axis, lower.along, upper.along);
            keeps_lower = keeps_lower && lower.along.may_vanish(sight_margin);
            keeps_upper = keeps_upper && upper.along.may_vanish(sight_margin);
            lower.at = upper.at = box.at;
            upper.at[axis] += (1 << depth_) >> (box.halvings / 3 + 1);
            lower.halvings = upper.halvings = box.halvings + 1;
            if (keeps_lower && !keeps_upper) upper = lower;
            count += std::size_t{keeps_lower} + std::size_t{keeps_upper};
        }
    }

    const ScalarField<float>& field_;
    float level_;
    ViewPoint view_;
    int depth_;
    LeafMarcher marcher_;
    std::vector<NetBox> stack_;
};

// SpareSearches are searches between one block and the next: each takes much memory.
class SpareSearches {
public:
    using Make = std::function<std::unique_ptr<BrickSearch>()>;
    explicit SpareSearches(Make make) : make_(std::move(make)) {}
    std::unique_ptr<BrickSearch> take()
    {
        {
            const std::lock_guard lock(mutex_);
            if (!spare_.empty()) {
                std::unique_ptr<BrickSearch> out = std::move(spare_.back());
                spare_.pop_back();
                return out;
            }
        }
        return make_();
    }
    void give_back(std::unique_ptr<BrickSearch> search)
    {
        const std::lock_guard lock(mutex_);
        spare_.push_back(std::move(search));
    }

private:
    Make make_;
    std::mutex mutex_;
    std::vector<std::unique_ptr<BrickSearch>> spare_;
};

std::vector<glm::ivec3> bricks_at(const FieldHulls& hulls, float level)
{
    std::vector<glm::ivec3> out;
    for (int k = 0; k < hulls.bricks().z; ++k)
        for (int j = 0; j < hulls.bricks().y; ++j)
            for (int i = 0; i < hulls.bricks().x; ++i) {
                const FieldHulls::Range& range = hulls.of({i, j, k});
                if (range.least <= level && range.greatest >= level) out.emplace_back(i, j, k);
            }
    return out;
}

// Puts parts together; vertices that two of them have become one. Triangles stay where they are,
// with the vertices of the whole.
LeafMarch whole_of(std::vector<LeafMarch>& parts)
{
    LeafMarch out;
    std::size_t positions = 0, shared = 0;
    for (const LeafMarch& part : parts) {
        positions += part.positions.size();
        shared += part.shared.size();
    }
    out.positions.reserve(positions);
    out.product.reserve(positions);
    KeyNumbers known(shared);
    std::vector<std::uint32_t> number;
    for (LeafMarch& part : parts) {
        const auto base = static_cast<std::uint32_t>(out.positions.size());
        number.resize(part.positions.size());
        for (std::size_t v = 0; v < number.size(); ++v)
            number[v] = base + static_cast<std::uint32_t>(v);
        out.positions.insert(out.positions.end(), part.positions.begin(), part.positions.end());
        out.product.insert(out.product.end(), part.product.begin(), part.product.end());
        for (const LeafMarch::Shared& at : part.shared)
            number[at.vertex] = known.insert(at.key, number[at.vertex]).first;
        const auto renumbered = [&](std::uint64_t edge) {
            return edge_key(number[edge >> 32], number[edge & 0xFFFFFFFF]);
        };
        for (CrossedTriangle& triangle : part.triangles)
            triangle = {renumbered(triangle.in), renumbered(triangle.out)};
        out.cells += part.cells;
        out.boxes += part.boxes;
        out.leaves += part.leaves;
        out.open += part.open;
    }
    return out;
}

} // namespace

CertifiedSilhouettes certified_silhouettes(const ScalarField<float>& field, const FieldHulls& hulls,
                                           float level, const ViewPoint& view, int depth,
                                           const SilhouetteOptions& options,
                                           const Progress& progress)
{
    check(view);
    if (field.order() != FieldOrder::cubic)
        throw Rejected("only silhouettes of cubic splines can be certified");
    if (depth < 0 || depth > most_depth)
        throw Rejected("the depth of a certificate is 0 to 5 halvings of a voxel");
    const std::vector<glm::ivec3> bricks = bricks_at(hulls, level);
    std::vector<LeafMarch> parts((bricks.size() + bricks_per_block - 1) / bricks_per_block);
    SpareSearches spare([&] { return std::make_unique<BrickSearch>(field, level, view, depth); });
    parallel_blocks(bricks.size(), bricks_per_block, [&](std::size_t begin, std::size_t end) {
        report(progress, static_cast<double>(begin) / static_cast<double>(bricks.size()), "proof");
        std::unique_ptr<BrickSearch> search = spare.take();
        for (std::size_t b = begin; b < end; ++b)
            (*search)(bricks[b] * FieldHulls::brick, parts[begin / bricks_per_block]);
        spare.give_back(std::move(search));
    });
    const LeafMarch all = whole_of(parts);
    CertifiedSilhouettes out;
    out.cells = all.cells;
    out.boxes = all.boxes;
    out.leaves = all.leaves;
    out.open = all.open;
    std::vector<std::vector<CrossedTriangle>> triangles;
    for (LeafMarch& part : parts) triangles.push_back(std::move(part.triangles));
    const EdgeChains chains = edge_chains(triangles);
    for (std::size_t c = 0; c < chains.count(); ++c) {
        if (chains.closed[c]) continue;
        for (const std::uint64_t edge :
             {chains.edges[chains.first[c]], chains.edges[chains.first[c + 1] - 1]})
            out.loose_ends += !are_in_a_face(all.positions[edge >> 32],
                                             all.positions[edge & 0xFFFFFFFF], field.end());
    }
    out.curves = curves_of(chains, all.positions, all.product, options.spacing);
    finish(field, level, view, options, out.curves);
    return out;
}

} // namespace trivar
