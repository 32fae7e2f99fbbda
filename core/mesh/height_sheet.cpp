// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/height_sheet.h"

#include "core/base/rejected.h"
#include "core/mesh/grid_mesh.h"

namespace trivar {

Mesh height_sheet(const GreyImage& image, const HeightSheet& sheet)
{
    if (image.values.empty()) throw Rejected("the picture of its heights has no pixels");
    const int n = sheet.segments;
    const double step = 1.0 / n;
    const auto height = [&](double i, double j) { return sheet.at(image, {i * step, j * step}); };
    const auto vertex_at = [&](int i, int j) {
        const double x = sheet.size * (2 * i - n) / (2.0 * n),
                     y = sheet.size * (2 * j - n) / (2.0 * n), width = 2 * step * sheet.size;
        const glm::dvec3 slope{(height(i + 1, j) - height(i - 1, j)) / width,
                               (height(i, j + 1) - height(i, j - 1)) / width, -1};
        return GridVertex{{x, y, height(i, j)}, -glm::normalize(slope), {i * step, j * step}};
    };
    Mesh mesh;
    append_grid(mesh, {n, n}, vertex_at);
    return finished_grids(std::move(mesh));
}

} // namespace trivar
