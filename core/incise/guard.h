// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/incise/cut_shape.h"
#include "core/incise/narrowing.h"
#include "core/incise/piercing.h"

#include <algorithm>
#include <optional>

namespace trivar {

// A CutGuard looks at the region of cuts for triangles that pierce each other.
class CutGuard {
public:
    explicit CutGuard(const CutShape& shape);

    // With each incision open by a share of what it is let have: those that are not when all of
    // them are shut. Ascending.
    std::vector<PiercingPair> piercings(std::span<const Admitted> admitted, double share) const;
    // Those of walls, with all of them shut.
    std::vector<PiercingPair> piercings_when_shut() const;
    bool is_wall(std::uint32_t triangle) const
    {
        return triangle >= first_wall_ && triangle < end_of_walls_;
    }
    // Of CutShape::walls.
    std::uint32_t wall_number(std::uint32_t triangle) const
    {
        return walls_[triangle - first_wall_];
    }
    // Narrows the incisions that move a corner of one of both, there, by one step.
    void narrow(std::span<const PiercingPair> pairs, std::span<const double> radius,
                std::vector<Admitted>& admitted) const;

private:
    struct Share {
        std::uint32_t incision;
        double move; // units of the mesh
    };
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
};

// The incisions through the body whose walls pierce others while all is shut, ascending.
std::vector<std::uint32_t> piercing_on_their_way(const CutShape& shape);

// How far incisions may open along their length: quite where nothing pierces then, otherwise less
// for those that move what does, where they move it. None: walls pierce although all is shut.
std::optional<std::vector<Admitted>> admissible_openings(const CutShape& shape,
                                                         std::span<const Incision> incisions);

} // namespace trivar
