// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/curves.h"

#include <span>

namespace trivar {

// The curves of a file have at most this many points: they are drawn anew in every picture.
inline constexpr std::size_t most_curve_points = 1'000'000;

// The lines of a file while it is read, as numbers of vertices that it may list only later.
class FileLines {
public:
    explicit FileLines(std::size_t most_points = most_curve_points) : most_points_(most_points) {}
    // False where it would have more points than there may be: it is left out then, and counted.
    bool add(std::span<const std::uint32_t> line, std::uint32_t material = 0);
    // A line of its own, or the next step of the line before, where that ended at `a` and nothing
    // was added since.
    void add_edge(std::uint32_t a, std::uint32_t b, std::uint32_t material = 0);
    // What is added now does not go on with what was added before.
    void interrupt() { open_ = false; }

    std::size_t count() const { return begin_.size() - 1; }
    std::size_t points() const { return vertices_.size(); }
    std::size_t without_room() const { return without_room_; }
    // The points, with colours where there are any. Lines that name other vertices are left out.
    Curves curves(const std::vector<glm::vec3>& positions,
                  const std::vector<glm::vec4>& colors) const;

private:
    std::vector<std::uint32_t> vertices_, begin_{0}, material_;
    std::size_t most_points_, without_room_ = 0;
    bool open_ = false;
};

// That lines were left out for want of room.
std::string lines_without_room(std::size_t count);

} // namespace trivar
