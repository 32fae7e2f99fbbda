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
        : VertexCorners(corners, vertices, [](std::uint32_t) { return true; })
    {
    }
    // Only those at vertices for which `listed` is true.
    template <class Listed>
    VertexCorners(std::span<const std::uint32_t> corners, std::size_t vertices, Listed listed)
        : begin_(vertices + 1, 0)
    {
        for (const std::uint32_t v : corners) begin_[v + 1] += listed(v) ? 1 : 0;
        for (std::size_t v = 0; v < vertices; ++v) begin_[v + 1] += begin_[v];
        at_.resize(begin_.back());
        if (at_.empty()) return;
        std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
        for (std::size_t c = 0; c < corners.size(); ++c)
            if (listed(corners[c])) at_[next[corners[c]]++] = static_cast<std::uint32_t>(c);
    }
    bool empty() const { return at_.empty(); }
    std::size_t size() const { return begin_.size() - 1; }
    std::span<const std::uint32_t> operator[](std::size_t vertex) const
    {
        return {at_.data() + begin_[vertex], at_.data() + begin_[vertex + 1]};
    }

private:
    std::vector<std::uint32_t> begin_, at_;
};

} // namespace trivar
