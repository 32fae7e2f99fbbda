// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplex/box_domain.h"

#include "core/simplex/simplex_domain.h"

#include <algorithm>
#include <numeric>

namespace trivar {
namespace {

template <int S>
SimplexMesh<S> freudenthal(const glm::vec<S, double>& size, const glm::vec<S, int>& boxes)
{
    SimplexMesh<S> out;
    const auto number = [&](const glm::vec<S, int>& at) {
        int n = 0;
        for (int i = 0; i < S; ++i) n = n * (boxes[i] + 1) + at[i];
        return n;
    };
    // counts through a grid, the last axis fastest
    const auto each = [](const glm::vec<S, int>& count, const auto& body) {
        int total = 1;
        for (int i = 0; i < S; ++i) total *= count[i];
        for (int n = 0; n < total; ++n) {
            glm::vec<S, int> at;
            for (int i = S - 1, rest = n; i >= 0; --i) at[i] = rest % count[i], rest /= count[i];
            body(at);
        }
    };
    each(boxes + 1, [&](const glm::vec<S, int>& at) {
        out.vertices.push_back(size * (glm::vec<S, double>(at) / glm::vec<S, double>(boxes) - 0.5));
    });
    each(boxes, [&](glm::vec<S, int> from) {
        std::array<int, S> axes;
        std::iota(axes.begin(), axes.end(), 0);
        do {
            std::array<int, S + 1> cell;
            glm::vec<S, int> at = from;
            cell[0] = number(at);
            for (std::size_t i = 0; i < S; ++i) {
                ++at[axes[i]];
                cell[i + 1] = number(at);
            }
            std::array<glm::vec<S, double>, S + 1> c;
            for (std::size_t i = 0; i <= S; ++i)
                c[i] = out.vertices[static_cast<std::size_t>(cell[i])];
            if (orientation(c) < 0) std::swap(cell[S - 1], cell[S]);
            out.cells.push_back(cell);
        } while (std::next_permutation(axes.begin(), axes.end()));
    });
    return out;
}

} // namespace

SimplexMesh<3> box_cells(const glm::dvec3& size, const glm::ivec3& boxes)
{
    return freudenthal<3>(size, boxes);
}

SimplexMesh<2> rectangle_cells(const glm::dvec2& size, const glm::ivec2& boxes)
{
    return freudenthal<2>(size, boxes);
}

} // namespace trivar
