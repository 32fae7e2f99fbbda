// SPDX-License-Identifier: GPL-3.0-or-later
// Lays random tiles on random bases, meshes and limit surfaces, and compares the height up to which
// the guard lets each grow with dense samples of its patch: how many fold below it, and how many it
// calls folded that are not. Arguments: how many tiles with a limit, and a seed.
#include "core/mesh/primitives.h"
#include "core/tiles/fold_limit.h"
#include "core/tiles/limit_chart.h"
#include "tests/limit/cages.h"
#include "tests/tiles/bases.h"
#include "tests/tiles/sampled_limit.h"

#include <cstdlib>
#include <fmt/format.h>

namespace trivar::testing {
namespace {

// Waves of any direction on all of a mesh, so that it bends both ways everywhere.
Mesh wavy(Mesh mesh, double much, std::mt19937& random)
{
    std::normal_distribution<double> number;
    mesh.points = points_by_position(mesh.positions);
    for (int wave = 0; wave < 4; ++wave) {
        const glm::dvec3 along = 3.0 * glm::dvec3(number(random), number(random), number(random));
        const glm::dvec3 by = much / 4 * glm::dvec3(number(random), number(random), number(random));
        const double phase = 3 * number(random);
        for (glm::vec3& p : mesh.positions)
            p += glm::vec3(by * std::sin(glm::dot(along, glm::dvec3(p)) + phase));
    }
    return mesh;
}

int quartered = 8;
struct Tally {
    int tiles = 0, limited = 0, folds = 0, refused = 0;
    double heights = 0, false_alarms = 0; // of heights spread evenly up to twice the truth

    void add(const TilePatch& patch)
    {
        ++tiles;
        constexpr double tall = 4; // sides of a tile
        const double limit = fold_limit(patch, quartered), sampled = sampled_limit(patch);
        if (!(limit > 0)) ++refused;
        if (sampled > tall) return;
        ++limited;
        folds += limit > sampled * (1 + 1e-9);
        heights += 1;
        if (sampled > 0) false_alarms += std::max(0.0, sampled - limit) / (2 * sampled);
    }
    void print(const char* name) const
    {
        fmt::print("{:16} {:8} tiles, {:7} with a limit, {} fold below it, {:.2f} % of heights "
                   "called folded that are not; {} never stand\n",
                   name, tiles, limited, folds, 100 * false_alarms / std::max(heights, 1.0),
                   refused);
    }
};

void on_meshes(int wanted, std::mt19937& random)
{
    std::uniform_real_distribution<double> share(0, 1);
    Tally all;
    for (int round = 0; all.limited < wanted; ++round) {
        const std::array bodies{sphere_mesh(1, 96, 48), torus_mesh(1, 0.4, {96, 48}),
                                box_mesh({1, 1.5, 0.7}, glm::ivec3(12))};
        const Mesh mesh = wavy(bodies[static_cast<std::size_t>(round) % 3], share(random), random);
        const TileBase base = base_of(mesh);
        const BasePose pose = at_rest(base);
        for (int k = 0; k < 1000; ++k) {
            const SurfacePlace at = random_place(base, random);
            const double size = 0.03 * std::exp2(4 * share(random));
            const TileChart chart =
                chart_of(base, {at, random_tangent(base, at, random), size}, 0, 1);
            if (std::isfinite(chart.cut)) all.add(in_sides(patch_of(base, pose, chart), size));
        }
    }
    all.print("meshes");
}

void on_limit_surfaces(int wanted, std::mt19937& random)
{
    std::uniform_real_distribution<double> share(0, 1);
    Tally all;
    const std::vector<NamedCage> cages = all_cages();
    for (std::size_t round = 0; all.limited < wanted; ++round) {
        Mesh cage = wavy(cages[round % cages.size()].mesh, 0.5 * share(random), random);
        const std::vector<LimitBase::Piece> pieces{{make_ref(std::move(cage)), glm::dmat4(1)}};
        const LimitBase base(pieces);
        for (int k = 0; k < 300; ++k) {
            const SurfacePlace at = random_place(base.triangles(), random);
            const double size = 0.03 * std::exp2(4 * share(random));
            const LimitChart chart = limit_chart_of(
                base, {at, random_tangent(base.triangles(), at, random), size}, 0, 1);
            if (!std::isfinite(chart.cut)) continue;
            std::array<glm::dvec3, 16> p{}, n{};
            for (std::size_t i = 0; i < 16; ++i) {
                p[i] = chart.nodes[i].p;
                n[i] = chart.nodes[i].normal;
            }
            all.add(in_sides({through_nodes(p), through_nodes(n)}, size));
        }
    }
    all.print("limit surfaces");
}

} // namespace
} // namespace trivar::testing

int main(int argc, char** argv)
{
    const int wanted = argc > 1 ? std::atoi(argv[1]) : 100'000;
    std::mt19937 random(argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 1u);
    if (argc > 3) trivar::testing::quartered = std::atoi(argv[3]);
    trivar::testing::on_meshes(wanted / 2, random);
    trivar::testing::on_limit_surfaces(wanted - wanted / 2, random);
}
