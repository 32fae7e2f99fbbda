// SPDX-License-Identifier: GPL-3.0-or-later
// Mends random folds of four kinds and says of each way of mending how often it is the best one,
// how often no other one helps, and how much further points go without it. Arguments: how many
// folds.
#include "core/ffd/repair.h"
#include "tests/support/splines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <vector>

namespace trivar {
namespace {

constexpr std::array<const char*, 5> way_names{"smoothed directions", "lowered heights",
                                               "monotone columns", "evened", "relaxed"};
constexpr std::array<const char*, 4> kinds{"a point pulled", "a region pushed", "layers crossed",
                                           "bent too tightly"};
constexpr glm::ivec3 count{9, 6, 4};

Lattice folded(int kind, testing::Noise& noise)
{
    Lattice box = lattice_at_rest(
        {Knots::uniform(3, count.x), Knots::uniform(3, count.y), Knots::uniform(3, count.z)},
        glm::dmat4(1));
    const glm::dvec3 at(noise.between(0, count.x), noise.between(0, count.y),
                        noise.between(1, count.z));
    const glm::dvec3 by = noise.between(0.15, 0.6) * noise.vec3();
    const double radius = noise.between(1, 3), depth = noise.between(0.5, 1.5),
                 bend = noise.between(2, 5); // radians over the length
    for (int i = 0; i < count.x; ++i)
        for (int j = 0; j < count.y; ++j)
            for (int k = 0; k < count.z; ++k) {
                glm::dvec3& d = box.displacement.points[box.displacement.index(i, j, k)];
                const glm::dvec3 here(i, j, k);
                const double share = std::max(0.0, 1 - glm::length(here - at) / radius);
                if (kind == 0 && glm::ivec3(at) == glm::ivec3(i, j, k)) d = by;
                if (kind == 1 && k > 0) d = share * by;
                if (kind == 2 && k > 0)
                    d.z = -depth * k / (count.z - 1.0) *
                          std::max(0.0, 1 - glm::length(glm::dvec2(here - at)) / radius);
                if (kind == 3) {
                    const glm::dvec3 p = control_point(box, i, j, k);
                    const double r = 1 / bend, angle = (p.x - 0.5) * bend;
                    const double z = 0.9 * p.z;
                    d = glm::dvec3((r - z) * std::sin(angle) + 0.5, p.y,
                                   r - (r - z) * std::cos(angle)) -
                        p;
                }
            }
    return box;
}

struct Tally {
    int best = 0, alone = 0;
    std::vector<double> further; // of the folds where it is best: the second way's moves by its own
};

void print(const std::array<Tally, 5>& tallies, int folds, int mended)
{
    fmt::print("{} folds, {} mended\n", folds, mended);
    for (std::size_t w = 0; w < tallies.size(); ++w) {
        std::vector<double> further = tallies[w].further;
        std::ranges::sort(further);
        fmt::print("  {:<20} best {:>5}, alone {:>5}, without it {:.2f} times as far (median)\n",
                   way_names[w], tallies[w].best, tallies[w].alone,
                   further.empty() ? 1 : further[further.size() / 2]);
    }
}

} // namespace
} // namespace trivar

int main(int argc, char** argv)
{
    using namespace trivar;
    const int wanted = argc > 1 ? std::atoi(argv[1]) : 10000;
    std::array<Tally, 5> all;
    int folds = 0, mended = 0;
    for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
        std::array<Tally, 5> tallies;
        int seen = 0, helped = 0;
        testing::Noise noise(static_cast<unsigned>(kind) + 1);
        while (seen < wanted / static_cast<int>(kinds.size())) {
            const Lattice lattice = folded(static_cast<int>(kind), noise);
            if (judge(lattice).good()) continue;
            ++seen;
            const UnfoldedLattice out = unfolded(lattice);
            if (!out.certified) continue;
            ++helped;
            double second = 1e300;
            for (const RepairAttempt& tried : out.tried)
                if (tried.certified && tried.way != out.taken.way)
                    second = std::min(second, tried.moved_rms);
            for (std::array<Tally, 5>* each : {&tallies, &all}) {
                Tally& tally = (*each)[static_cast<std::size_t>(out.taken.way)];
                ++tally.best;
                if (second == 1e300)
                    ++tally.alone;
                else
                    tally.further.push_back(second / std::max(out.taken.moved_rms, 1e-12));
            }
        }
        fmt::print("{}: ", kinds[kind]);
        print(tallies, seen, helped);
        folds += seen;
        mended += helped;
    }
    fmt::print("all: ");
    print(all, folds, mended);
}
