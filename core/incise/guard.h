// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/incise/narrowing.h"
#include "core/incise/piercing.h"
#include "core/incise/slit_shape.h"

#include <algorithm>
#include <optional>

namespace trivar {

// A SlitGuard looks at the region of cuts for triangles that pierce each other, beyond those that
// do in the model itself: with positions and moves as they are stored, in single precision.
class SlitGuard {
public:
    SlitGuard(const SlitShape& shape, std::span<const Incision> incisions);

    // The pairs of walls, of SlitShape::walls, that pierce each other while all is shut; one that
    // pierces the skin is a pair with itself.
    struct Walls {
        std::uint32_t a, b;
    };
    std::vector<Walls> walls_in_the_way() const;
    // Whether no wall pierces another at any tested opening up to the one asked for.
    bool admits_all() const;
    // Returns how far each incision may open along its length: fully where nothing pierces then. Of
    // two that are in each other's way the later one opens less, where it moves the part that
    // pierces. `alone` is not set yet.
    //   most  ends the search early, with nothing, once lack() would be this or more
    std::optional<std::vector<Admission>> admitted(double most) const;
    // Adds how far each one could open if it were alone, where others hold it.
    void find_alone(std::vector<Admission>& admitted) const;
    // Returns the sum, over all parts of incisions, of the share of the wanted opening that they
    // lack, each 0..1.
    double lack(std::span<const Admission> admitted) const;
    // The number of triangles and pairs of triangles tested so far: the cost of all of the above.
    std::size_t looks() const { return looks_; }

private:
    double lack(std::uint32_t incision, const Admitted& admitted) const;
    struct Part { // of an incision, as shares of its length
        std::uint32_t incision;
        double from, to;
    };
    bool is_wall(std::uint32_t triangle) const
    {
        return triangle >= first_wall_ && triangle < end_of_walls_;
    }
    // Returns the move of each vertex while the `open` incisions are as open as they are admitted.
    std::vector<glm::dvec3> moves(std::span<const Admitted> admitted,
                                  std::span<const char> open) const;
    // Whether a pair pierces at any share at which it is looked at.
    bool pierces(const PiercingPair& pair, const std::vector<glm::dvec3>& quite) const;
    static constexpr std::uint32_t any = ~0u;
    std::vector<char> moved_by(std::uint32_t incision) const; // by vertex
    // Finds the pairs that pierce each other when each vertex is moved by one of these shares of
    // its move, the greatest first, and not when all incisions are shut. Ascending; with a corner
    // that is `moving`.
    std::vector<PiercingPair> piercings(const std::vector<glm::dvec3>& quite,
                                        std::span<const double> shares,
                                        std::span<const char> moving) const;
    // Lets an incision open as far as it can while some others are open as they are let, and tells
    // which of these hold it.
    Admission admitted(std::uint32_t incision, const std::vector<Admitted>& all,
                       std::span<const char> open) const;
    // The same, with dents of one size.
    Admitted narrowed(std::uint32_t incision, std::vector<Admitted> all, std::span<const char> open,
                      double dent, std::vector<char>& holds) const;
    // Narrows an incision by one step where it moves a triangle that pierces. `done`: which terms
    // were narrowed already, by bits. False: it moves none.
    bool lower(const PiercingPair& pair, std::uint32_t incision, double dent,
               const Admitted& before, Admitted& after, std::vector<char>& done) const;
    std::uint32_t corner(const PiercingPair& pair, std::size_t i) const
    {
        return triangles_[i < 3 ? pair.a : pair.b][static_cast<int>(i % 3)];
    }
    auto terms_at(std::uint32_t vertex) const
    {
        return std::ranges::equal_range(terms_, vertex, {}, &SlitTerm::vertex);
    }

    std::vector<glm::dvec3> rest_;
    std::vector<glm::uvec3> triangles_; // local vertices; skin first
    std::size_t first_wall_ = 0, end_of_walls_ = 0;
    std::vector<std::uint32_t> walls_;
    std::vector<SlitTerm> terms_; // by local vertex, ascending
    std::span<const Incision> incisions_;
    std::vector<Part> parts_;
    std::vector<double> radius_; // of a dent, by incision, as a share of its length
    std::vector<char> round_;    // whether it is a loop
    mutable std::size_t looks_ = 0;
    bool simple_ = false; // one piece, with upright walls and no bevel
};

} // namespace trivar
