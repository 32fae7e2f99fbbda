// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace trivar {

// VertexCorners lists the corners of triangles at each vertex, in ascending order; corner / 3 is
// the triangle. O(#corners).
class VertexCorners {
public:
    VertexCorners(std::span<const std::uint32_t> corners, std::size_t vertices)
        : begin_(vertices + 1, 0),
          at_(corners.size())
    {
        for (const std::uint32_t v : corners) ++begin_[v + 1];
        for (std::size_t v = 0; v < vertices; ++v) begin_[v + 1] += begin_[v];
        std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
        for (std::size_t c = 0; c < corners.size(); ++c)
            at_[next[corners[c]]++] = static_cast<std::uint32_t>(c);
    }
    std::span<const std::uint32_t> operator[](std::size_t vertex) const
    {
        return {at_.data() + begin_[vertex], at_.data() + begin_[vertex + 1]};
    }

private:
    std::vector<std::uint32_t> begin_, at_;
};

} // namespace trivar
