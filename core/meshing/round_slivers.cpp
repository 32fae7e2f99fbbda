// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/round_slivers.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trivar {
namespace {

constexpr int most_passes = 30, shorter_ways = 5, directions = 24;

// SliverRounder moves one vertex after the other.
class SliverRounder {
public:
    SliverRounder(SimplexMesh<3>& mesh, const std::vector<std::uint8_t>& axes)
        : mesh_(mesh),
          axes_(axes),
          stars_(vertex_stars(mesh))
    {
        for (int d = 0; d < directions; ++d) { // evenly on a sphere [Vogel 1979]
            const double z = 1 - (2 * d + 1.0) / directions, r = std::sqrt(1 - z * z),
                         turn = d * std::numbers::pi * (3 - std::sqrt(5.0));
            ways_[static_cast<std::size_t>(d)] = {r * std::cos(turn), r * std::sin(turn), z};
        }
    }
    bool improve(const std::array<int, 4>& cell)
    {
        bool out = false;
        for (const int v : cell)
            if (axes_[static_cast<std::size_t>(v)] != 0) out |= improve(v);
        return out;
    }
    double angle(const std::array<int, 4>& cell) const
    {
        std::array<glm::dvec3, 4> at;
        for (std::size_t k = 0; k < 4; ++k) at[k] = place(cell[k]);
        return least_dihedral(at);
    }

private:
    glm::dvec3& place(int v) const { return mesh_.vertices[static_cast<std::size_t>(v)]; }
    double least_angle_round(int v) const
    {
        double out = std::numbers::pi;
        for (const int c : stars_[static_cast<std::size_t>(v)])
            out = std::min(out, angle(mesh_.cells[static_cast<std::size_t>(c)]));
        return out;
    }
    glm::dvec3 along_axes(glm::dvec3 way, int v) const
    {
        for (int k = 0; k < 3; ++k)
            if (!(axes_[static_cast<std::size_t>(v)] >> k & 1)) way[k] = 0;
        return way;
    }
    bool improve(int v)
    {
        const glm::dvec3 from = place(v);
        double reach = 1e300;
        for (const int c : stars_[static_cast<std::size_t>(v)])
            for (const int w : mesh_.cells[static_cast<std::size_t>(c)])
                if (w != v) reach = std::min(reach, glm::distance(place(w), from));
        glm::dvec3 best = from;
        const double before = least_angle_round(v);
        double most = before;
        for (int s = 0; s < shorter_ways; ++s, reach /= 2)
            for (const glm::dvec3& way : ways_) {
                place(v) = from + 0.5 * reach * along_axes(way, v);
                if (const double angle = least_angle_round(v); angle > most) {
                    most = angle;
                    best = place(v);
                }
            }
        place(v) = best;
        return most > before + 1e-3;
    }

    SimplexMesh<3>& mesh_;
    const std::vector<std::uint8_t>& axes_;
    std::vector<std::vector<int>> stars_;
    std::array<glm::dvec3, directions> ways_;
};

} // namespace

void round_slivers(SimplexMesh<3>& mesh, const std::vector<std::uint8_t>& axes, double least_angle)
{
    SliverRounder rounder(mesh, axes);
    bool goes_on = true;
    for (int pass = 0; goes_on && pass < most_passes; ++pass) {
        goes_on = false;
        for (const std::array<int, 4>& cell : mesh.cells)
            if (rounder.angle(cell) < least_angle) goes_on |= rounder.improve(cell);
    }
}

} // namespace trivar
