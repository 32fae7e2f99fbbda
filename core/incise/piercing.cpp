// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/piercing.h"

#include "core/base/box.h"
#include "core/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace trivar {
namespace {

constexpr double least_certain = 1e-14; // of the largest determinant with such edges
constexpr std::size_t entries_per_block = 4096;

int side_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d)
{
    const glm::dvec3 x = b - a, y = c - a, z = d - a;
    const double det = glm::dot(x, glm::cross(y, z));
    const auto size = [](const glm::dvec3& v) {
        return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
    };
    const double bound = least_certain * size(x) * size(y) * size(z);
    return det > bound ? 1 : det < -bound ? -1 : 0;
}

using TriangleCorners = std::array<glm::dvec3, 3>;

// Whether the line from p to q, whose ends lie on those sides of a triangle's plane, goes through
// its inside.
bool goes_through(const glm::dvec3& p, const glm::dvec3& q, int side_p, int side_q,
                  const TriangleCorners& t)
{
    if (side_p * side_q >= 0) return false;
    const int u = side_of(p, q, t[0], t[1]);
    return u != 0 && u == side_of(p, q, t[1], t[2]) && u == side_of(p, q, t[2], t[0]);
}

// Whether a side of `t` goes through the inside of `other`; `common`: the corner of t that is one
// of the other's, or -1.
bool goes_through(const TriangleCorners& t, int common, const TriangleCorners& other)
{
    std::array<int, 3> side{};
    for (std::size_t i = 0; i < 3; ++i)
        side[i] = static_cast<int>(i) == common ? 0 : side_of(other[0], other[1], other[2], t[i]);
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t k = (i + 1) % 3;
        if (goes_through(t[i], t[k], side[i], side[k], other)) return true;
    }
    return false;
}

class PiercingSearch {
public:
    PiercingSearch(const std::vector<glm::dvec3>& p, const std::vector<glm::uvec3>& triangles)
        : p_(p),
          triangles_(triangles)
    {
        double sizes = 0;
        Box all;
        for (const glm::uvec3& t : triangles) {
            Box box;
            for (int i = 0; i < 3; ++i) box.add(p[t[i]]);
            sizes += glm::length(box.size());
            all.add(box);
            boxes_.push_back(box);
        }
        origin_ = all.lo;
        const double most = glm::length(all.size()) / (1 << 19); // cells have 20 bits an axis
        cell_ = std::max(
            {sizes / static_cast<double>(std::max<std::size_t>(1, boxes_.size())), most, 1e-300});
    }

    std::vector<PiercingPair> operator()()
    {
        enter_cells();
        std::vector<std::vector<PiercingPair>> found(entries_.size() / entries_per_block + 1);
        parallel_blocks(entries_.size(), entries_per_block,
                        [&](std::size_t begin, std::size_t end) {
                            for (std::size_t i = begin; i < end; ++i)
                                compare_with_next(i, found[begin / entries_per_block]);
                        });
        std::vector<PiercingPair> all;
        for (const auto& each : found) all.insert(all.end(), each.begin(), each.end());
        std::ranges::sort(all);
        return all;
    }

private:
    struct Entry {
        std::uint64_t cell;
        std::uint32_t triangle;
        auto operator<=>(const Entry&) const = default;
    };
    glm::u64vec3 cell_at(const glm::dvec3& x) const { return glm::u64vec3((x - origin_) / cell_); }
    static std::uint64_t key(const glm::u64vec3& c) { return c.x << 42 | c.y << 21 | c.z; }

    void enter_cells()
    {
        for (std::uint32_t t = 0; t < boxes_.size(); ++t) {
            const glm::u64vec3 lo = cell_at(boxes_[t].lo), hi = cell_at(boxes_[t].hi);
            glm::u64vec3 c;
            for (c.x = lo.x; c.x <= hi.x; ++c.x)
                for (c.y = lo.y; c.y <= hi.y; ++c.y)
                    for (c.z = lo.z; c.z <= hi.z; ++c.z) entries_.push_back({key(c), t});
        }
        std::ranges::sort(entries_);
    }

    void compare_with_next(std::size_t i, std::vector<PiercingPair>& found) const
    {
        for (std::size_t j = i + 1; j < entries_.size() && entries_[j].cell == entries_[i].cell;
             ++j) {
            const std::uint32_t s = entries_[i].triangle, t = entries_[j].triangle;
            if (boxes_[s].apart(boxes_[t])) continue;
            // A pair that meets in several cells is looked at in the first of them
            if (key(cell_at(glm::max(boxes_[s].lo, boxes_[t].lo))) != entries_[i].cell) continue;
            if (pierce(triangles_[s], triangles_[t]))
                found.push_back({std::min(s, t), std::max(s, t)});
        }
    }
    bool pierce(const glm::uvec3& s, const glm::uvec3& t) const
    {
        int common = 0, at_s = 0, at_t = 0;
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k)
                if (s[i] == t[k]) {
                    ++common;
                    at_s = i;
                    at_t = k;
                }
        if (common > 1) return false;
        const TriangleCorners a{p_[s.x], p_[s.y], p_[s.z]}, b{p_[t.x], p_[t.y], p_[t.z]};
        return goes_through(a, common == 1 ? at_s : -1, b) ||
               goes_through(b, common == 1 ? at_t : -1, a);
    }

    const std::vector<glm::dvec3>& p_;
    const std::vector<glm::uvec3>& triangles_;
    std::vector<Box> boxes_;
    glm::dvec3 origin_{0};
    double cell_ = 1;
    std::vector<Entry> entries_;
};

} // namespace

std::vector<PiercingPair> piercings(const std::vector<glm::dvec3>& p,
                                    const std::vector<glm::uvec3>& triangles)
{
    return PiercingSearch(p, triangles)();
}

} // namespace trivar
