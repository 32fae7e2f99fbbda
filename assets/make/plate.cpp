// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/parts.h"

namespace make {

Mesh plate(const Plate& shape)
{
    const int columns = int(shape.u.size()), rows = int(shape.v.size());
    Mesh m;
    for (const bool above : {true, false})
        for (const float v : shape.v)
            for (const float u : shape.u) {
                m.points.push_back(above ? shape.above({u, v}) : shape.below({u, v}));
                m.colors.push_back(shape.color({u, v}, above));
            }
    const int under = columns * rows;
    const auto at = [=](int i, int j) { return j * columns + i; };
    for (int j = 0; j + 1 < rows; j++)
        for (int i = 0; i + 1 < columns; i++) {
            const Face up{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
            m.faces.push_back(up);
            m.faces.push_back({up[3] + under, up[2] + under, up[1] + under, up[0] + under});
        }
    const auto wall = [&](int a, int b) { m.faces.push_back({b, a, a + under, b + under}); };
    for (int i = 0; i + 1 < columns; i++) {
        wall(at(i, 0), at(i + 1, 0));
        wall(at(i + 1, rows - 1), at(i, rows - 1));
    }
    for (int j = 0; j + 1 < rows; j++) {
        wall(at(0, j + 1), at(0, j));
        wall(at(columns - 1, j), at(columns - 1, j + 1));
    }
    return m;
}

} // namespace make
