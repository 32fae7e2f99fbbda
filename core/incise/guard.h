// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/incise/cut_shape.h"
#include "core/incise/narrowing.h"
#include "core/incise/piercing.h"

#include <algorithm>

namespace trivar {

// A CutGuard looks at the region of cuts for triangles that pierce each other, beyond those that do
// in the model itself: with positions and moves as they are stored, in single precision.
class CutGuard {
public:
    CutGuard(const CutShape& shape, std::span<const Incision> incisions);

    // The walls, of CutShape::walls, that pierce something while all is shut, ascending.
    std::vector<std::uint32_t> walls_in_the_way() const;
    // Whether nothing pierces at any share at which it is looked at, with all that was asked for.
    bool admits_all() const;
    // How far incisions may open along their length: quite where nothing pierces then, otherwise
    // less for those that move what does, where they move it: within `dent` times the usual length.
    std::vector<Admitted> admitted(double dent) const;

private:
    struct Share {
        std::uint32_t incision;
        double move; // units of the mesh
    };
    bool is_wall(std::uint32_t triangle) const
    {
        return triangle >= first_wall_ && triangle < end_of_walls_;
    }
    // With each incision open by one of these shares of what it is let have, the greatest first:
    // those that do not when all of them are shut. Ascending.
    std::vector<PiercingPair> piercings(std::span<const Admitted> admitted,
                                        std::span<const double> shares) const;
    // Narrows the incisions that move a corner of one of both, there, by one step.
    void narrow(std::span<const PiercingPair> pairs, double dent,
                std::vector<Admitted>& admitted) const;
    std::vector<Share> shares_of(const PiercingPair& pair,
                                 std::span<const Admitted> admitted) const;
    std::uint32_t corner(const PiercingPair& pair, std::size_t i) const
    {
        return triangles_[i < 3 ? pair.a : pair.b][static_cast<int>(i % 3)];
    }
    auto terms_at(std::uint32_t vertex) const
    {
        return std::ranges::equal_range(terms_, vertex, {}, &CutTerm::vertex);
    }

    std::vector<glm::dvec3> rest_;
    std::vector<glm::uvec3> triangles_; // local vertices; skin first
    std::size_t first_wall_ = 0, end_of_walls_ = 0;
    std::vector<std::uint32_t> walls_;
    std::vector<CutTerm> terms_; // by local vertex, ascending
    std::vector<double> radius_; // of a dent, by incision, as a share of its length
    std::vector<char> round_;    // whether it is a loop
    bool simple_ = false;        // one piece, with upright walls and no bevel
};

} // namespace trivar
