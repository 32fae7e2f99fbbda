// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/curves.h"

#include <span>

namespace trivar {

// The largest number of points in the curves of a file: curves are drawn anew in every picture.
inline constexpr std::size_t most_curve_points = 1'000'000;

// FileLines holds the lines of a file while it is read, as numbers of vertices that the file may
// list later.
class FileLines {
public:
    explicit FileLines(std::size_t most_points = most_curve_points) : most_points_(most_points) {}
    // Adds a line. False where there would be too many points: the line is left out and counted.
    bool add(std::span<const std::uint32_t> line, std::uint32_t material = 0);
    // Adds a new line, or the next step of the previous line, if that ended at `a` and nothing was
    // added since.
    void add_edge(std::uint32_t a, std::uint32_t b, std::uint32_t material = 0);
    // The next line does not continue the previous one.
    void interrupt() { open_ = false; }

    std::size_t count() const { return begin_.size() - 1; }
    std::size_t points() const { return vertices_.size(); }
    std::size_t without_room() const { return without_room_; }
    // The curves, with colours where there are any. Lines that name vertices which do not exist are
    // left out.
    Curves curves(const std::vector<glm::vec3>& positions,
                  const std::vector<glm::vec4>& colors) const;

private:
    std::vector<std::uint32_t> vertices_, begin_{0}, material_;
    std::size_t most_points_, without_room_ = 0;
    bool open_ = false;
};

// The sentence that says how many lines were left out for lack of room.
std::string lines_without_room(std::size_t count);

} // namespace trivar
