// SPDX-License-Identifier: GPL-3.0-or-later
// Makes random edits with the guard on, each from where the last one was let go, and looks for
// folds by samples after every one. Arguments: how many lattices of 200 edits each.
#include "core/ffd/guard.h"
#include "tests/ffd/folds.h"
#include "tests/support/splines.h"

#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>

namespace trivar {
namespace {

constexpr int edits_each = 200;

struct Counts {
    int stopped = 0, proven_to_fold = 0, good_by_samples = 0, folded = 0;
};

Counts edit_one_lattice(int which, Counts counts)
{
    testing::Noise noise(static_cast<unsigned>(which) + 1);
    const int order = 3 + which % 2;
    Lattice lattice = lattice_at_rest(
        {Knots::uniform(order, 8), Knots::uniform(order, 7), Knots::uniform(order, 6)},
        glm::dmat4(1));
    CellVerdicts verdicts = judge(lattice);
    for (int edit = 0; edit < edits_each; ++edit) {
        const glm::dvec3 anywhere(noise.between(0, 8), noise.between(0, 7), noise.between(0, 6));
        const PointMove move{glm::ivec3(anywhere), noise.between(0, 0.15) * noise.vec3()};
        const std::span moves(&move, 1);
        CertifiedShare out = certified_share(lattice, verdicts, moves);
        if (out.share < 1) {
            ++counts.stopped;
            const Lattice whole = moved(lattice, moves);
            const auto now = judged_again(verdicts, whole, moves).of;
            counts.proven_to_fold += std::count(now.begin(), now.end(), Verdict::proven_bad) > 0;
            counts.good_by_samples += testing::smallest_jacobian(whole, 5) > 0 &&
                                      testing::smallest_jacobian(whole, 17) > 0;
        }
        lattice = moved(lattice, scaled(moves, out.share));
        verdicts = std::move(out.after);
        counts.folded += !(testing::smallest_jacobian(lattice, 5) > 0);
    }
    return counts;
}

} // namespace
} // namespace trivar

int main(int argc, char** argv)
{
    const int lattices = argc > 1 ? std::atoi(argv[1]) : 500;
    trivar::Counts c;
    for (int i = 0; i < lattices; ++i) c = trivar::edit_one_lattice(i, c);
    fmt::print("{} edits: {} stopped short, of which {} are proven to fold at their full length "
               "and {} do not by 17^3 samples a cell; folded by 5^3 samples a cell: {}\n",
               lattices * trivar::edits_each, c.stopped, c.proven_to_fold, c.good_by_samples,
               c.folded);
}
