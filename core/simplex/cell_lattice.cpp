// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplex/cell_lattice.h"

#include <algorithm>
#include <map>

namespace trivar {
namespace {

// The cell as steps >= y0 >= y1 >= y2 >= 0; its corners are the numbers of leading `steps`.
std::array<int, 4> barycentric(const std::array<int, 3>& y, int steps)
{
    return {steps - y[0], y[0] - y[1], y[1] - y[2], y[2]};
}

} // namespace

CellLattice::CellLattice(int step_count) : steps(step_count)
{
    std::map<std::array<int, 3>, int> number;
    for (int a = 0; a <= steps; ++a)
        for (int b = 0; b <= a; ++b)
            for (int c = 0; c <= b; ++c) {
                number[{a, b, c}] = static_cast<int>(points.size());
                points.push_back(barycentric({a, b, c}, steps));
            }
    for (const auto& [from, unused] : number) {
        std::array<int, 3> axes{0, 1, 2};
        bool odd = false; // permutations in this order: even, odd, odd, even, even, odd
        int place = 0;
        do {
            odd = place == 1 || place == 2 || place == 5;
            ++place;
            std::array<int, 3> at = from;
            std::array<int, 4> piece{number[at], 0, 0, 0};
            bool within = true;
            for (std::size_t i = 0; within && i < 3; ++i) {
                ++at[static_cast<std::size_t>(axes[i])];
                const auto found = number.find(at);
                within = found != number.end();
                if (within) piece[i + 1] = found->second;
            }
            if (!within) continue;
            if (odd) std::swap(piece[2], piece[3]);
            pieces.push_back(piece);
        } while (std::next_permutation(axes.begin(), axes.end()));
    }
    for (const auto& piece : pieces)
        for (const auto& face : outward_faces) {
            std::array<int, 3> triangle;
            for (std::size_t i = 0; i < 3; ++i)
                triangle[i] = piece[static_cast<std::size_t>(face[i])];
            for (std::size_t k = 0; k < 4; ++k)
                if (std::all_of(triangle.begin(), triangle.end(),
                                [&](int p) { return points[static_cast<std::size_t>(p)][k] == 0; }))
                    faces[k].push_back(triangle);
        }
}

} // namespace trivar
