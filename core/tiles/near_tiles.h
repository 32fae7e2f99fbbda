// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <unordered_map>
#include <vector>

namespace trivar {

// NearTiles finds tiles by the place of their middle, in a grid of cubes. Adding costs O(1), asking
// O(#cubes that the ball touches + #tiles in them), and never more than O(#tiles).
class NearTiles {
public:
    explicit NearTiles(double cube) : cube_(cube) {}
    void add(const glm::dvec3& p, int tile)
    {
        all_.push_back({p, tile});
        tiles_[key(cube_of(p))].push_back({p, tile});
    }
    std::size_t size() const { return all_.size(); }
    void remove_last()
    {
        tiles_[key(cube_of(all_.back().p))].pop_back();
        all_.pop_back();
    }
    // Calls found(tile, distance) for the tiles within a radius, until it returns true.
    template <class Found> bool any(const glm::dvec3& p, double radius, Found&& found) const
    {
        const auto is_found = [&](const TilePosition& each) {
            const double distance = glm::distance(each.p, p);
            return distance <= radius && found(each.tile, distance);
        };
        const glm::i64vec3 lo = cube_of(p - radius), hi = cube_of(p + radius);
        const glm::dvec3 cubes(hi - lo + std::int64_t(1));
        if (cubes.x * cubes.y * cubes.z > static_cast<double>(all_.size()))
            return std::ranges::any_of(all_, is_found);
        for (std::int64_t z = lo.z; z <= hi.z; ++z)
            for (std::int64_t y = lo.y; y <= hi.y; ++y)
                for (std::int64_t x = lo.x; x <= hi.x; ++x) {
                    const auto cube = tiles_.find(key({x, y, z}));
                    if (cube == tiles_.end()) continue;
                    if (std::ranges::any_of(cube->second, is_found)) return true;
                }
        return false;
    }

private:
    struct TilePosition {
        glm::dvec3 p;
        int tile;
    };
    glm::i64vec3 cube_of(const glm::dvec3& p) const
    {
        return glm::i64vec3(glm::floor(glm::clamp(p / cube_, -1e15, 1e15)));
    }
    static std::uint64_t key(const glm::i64vec3& c)
    {
        return static_cast<std::uint64_t>(c.x) * 0x9E3779B97F4A7C15u ^
               static_cast<std::uint64_t>(c.y) * 0xC2B2AE3D27D4EB4Fu ^
               static_cast<std::uint64_t>(c.z) * 0x165667B19E3779F9u;
    }
    double cube_;
    std::vector<TilePosition> all_;
    std::unordered_map<std::uint64_t, std::vector<TilePosition>> tiles_;
};

} // namespace trivar
