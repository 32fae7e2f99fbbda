// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/steps/strands.h"

#include "core/commands/objects/primitives.h"
#include "core/commands/tiles/tiles.h"
#include "tests/support/scenes/commands.h"

#include <cstring>
#include <set>

namespace trivar::testing::strands {

Document with_ribbon()
{
    AddSphere ball;
    ball.shape = {.radius = 1, .segments = 64, .rings = 32};
    AddPlane ribbon;
    ribbon.shape = {.size = {0.2, 0.1}, .segments = {ribbon_columns, ribbon_rows}};
    return after(after(Document{}, ball), ribbon);
}

TileStroke strand_round_the_ball(double from, double to)
{
    TileStroke stroke;
    stroke.brush = TileBrush::strand;
    stroke.size = 0.2;
    for (int i = 0; i <= 20; ++i) {
        const double a = glm::mix(from, to, i / 20.0), z = 0.3 * std::sin(2 * a);
        const glm::dvec3 n = glm::normalize(glm::dvec3(std::cos(a), std::sin(a), z));
        stroke.samples.push_back({{n, n}, 0.1 * i, 1});
    }
    return stroke;
}

Document with_strand(double from, double to)
{
    return after(with_ribbon(),
                 PaintTiles{strand_tile_id, strand_base, strand_round_the_ball(from, to)});
}

std::vector<std::string> notices_of(const Document& document)
{
    return new_evaluator()(document, 1).objects.at(strand_tile_id)->notices;
}

StrandCounts counted(const Document& document, double frame)
{
    StrandCounts out;
    std::set<std::array<std::uint32_t, 3>> points;
    const Evaluation all = new_evaluator()(document, frame);
    for (const Part& part : all.objects.at(strand_tile_id)->parts) {
        const Mesh& mesh = *part.mesh();
        out.tiles += mesh.face_count() / (ribbon_columns * ribbon_rows);
        for (const glm::vec3& p : mesh.positions) {
            std::array<std::uint32_t, 3> bits{};
            std::memcpy(bits.data(), &p, sizeof bits);
            points.insert(bits);
        }
    }
    out.points = points.size();
    return out;
}

std::size_t points_of_open(std::size_t tiles)
{
    return (ribbon_columns * tiles + 1) * (ribbon_rows + 1);
}

} // namespace trivar::testing::strands
