// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplify/proof.h"

#include "core/base/parallel.h"
#include "core/simplify/reach.h"
#include "core/spline/box_tree.h"

#include <algorithm>
#include <array>

namespace trivar {
namespace {

Triangle3 placed(const glm::uvec3& v, const std::vector<glm::dvec3>& places)
{
    return {places[v.x], places[v.y], places[v.z]};
}

// A Claim lists triangles of one of the two meshes that the other one lacks, and has the other
// mesh.
struct Claim {
    Reach other;
    std::vector<std::size_t> numbers; // of the triangles
    std::vector<Triangle3> triangles;
    std::vector<glm::uvec3> nodes;
};

// Makes the claims of both directions in a pose, without the triangles for which skips(way, number,
// triangle).
template <class Skips>
std::array<Claim, 2> claims(const Fans& fans, const Decimation& left,
                            const std::vector<glm::dvec3>& places, Skips skips)
{
    std::vector<Triangle3> before, after;
    std::array<Claim, 2> out;
    const auto add = [&](std::size_t way, std::size_t t, const Triangle3& triangle) {
        if (skips(way, t, triangle)) return;
        out[way].numbers.push_back(t);
        out[way].triangles.push_back(triangle);
        out[way].nodes.push_back(way == 0 ? fans.nodes[t] : left.nodes[t]);
    };
    for (std::size_t t = 0; t < fans.triangles.size(); ++t) {
        const bool gone = is_gone(fans, left, t);
        const Triangle3 was = placed(fans.triangles[t], places),
                        is = placed(left.triangles[t], places);
        before.push_back(was);
        if (!gone) after.push_back(is);
        if (!left.changed[t]) continue;
        add(0, t, was);
        if (!gone) add(1, t, is);
    }
    if (!out[0].triangles.empty()) out[0].other = Reach(std::move(after));
    if (!out[1].triangles.empty()) out[1].other = Reach(std::move(before));
    return out;
}

// Lists the triangles that are not proven to be within a distance, ascending.
std::vector<std::size_t> unproven(const Claim& claim, double distance)
{
    std::vector<char> proven(claim.triangles.size());
    parallel_blocks(proven.size(), 256, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
            proven[i] = claim.other.covers(claim.triangles[i], distance);
    });
    std::vector<std::size_t> out;
    for (std::size_t i = 0; i < proven.size(); ++i)
        if (!proven[i]) out.push_back(i);
    return out;
}

// Raises `least` by factors until all triangles are proven to be within it; triangles that are
// proven earlier are dropped.
double raised(Claim& claim, double least, double factor)
{
    while (!claim.triangles.empty()) {
        const std::vector<std::size_t> left = unproven(claim, least);
        if (left.empty()) break;
        std::vector<Triangle3> still;
        for (const std::size_t i : left) still.push_back(claim.triangles[i]);
        claim.triangles = std::move(still);
        least *= factor;
    }
    return least;
}

} // namespace

Proof::Proof(const Fans& fans, const VertexPlaces& places, double distance)
    : fans_(fans),
      places_(places),
      distance_(distance),
      known_(places.size())
{
}

std::vector<std::uint32_t> Proof::unproven_nodes(const Decimation& left)
{
    std::vector<glm::uvec3> now = left.triangles;
    for (std::size_t t = 0; t < now.size(); ++t)
        if (is_gone(fans_, left, t)) now[t] = glm::uvec3(Fans::none);
    std::vector<std::uint32_t> nodes;
    for (std::size_t pose = 0; pose < places_.size(); ++pose) {
        std::array<std::vector<char>, 2>& known = known_[pose];
        const BoxTree moved(boxes_moved(now, places_[pose]));
        const auto still_holds = [&](std::size_t way, std::size_t t, const Triangle3& triangle) {
            if (last_.empty() || !known[way][t]) return false;
            if (way == 1) return last_[t] == now[t];
            const Box box = box_of(triangle);
            return moved.distance(box.center()) > glm::length(box.size()) / 2 + distance_;
        };
        const std::array<Claim, 2> both = claims(fans_, left, places_[pose], still_holds);
        for (std::size_t way = 0; way < 2; ++way) {
            known[way].assign(now.size(), true);
            for (const std::size_t i : unproven(both[way], distance_)) {
                known[way][both[way].numbers[i]] = false;
                for (int k = 0; k < 3; ++k) nodes.push_back(both[way].nodes[i][k]);
            }
        }
    }
    last_ = std::move(now);
    std::ranges::sort(nodes);
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

// Returns the boxes of triangles that changed since the last round, before and after.
std::vector<Box> Proof::boxes_moved(const std::vector<glm::uvec3>& now,
                                    const std::vector<glm::dvec3>& places) const
{
    std::vector<Box> boxes;
    for (std::size_t t = 0; t < last_.size(); ++t) {
        if (last_[t] == now[t]) continue;
        for (const glm::uvec3& v : {last_[t], now[t]})
            if (v.x != Fans::none) boxes.push_back(box_of(placed(v, places)));
    }
    return boxes;
}

double proven_error(const Fans& fans, const Decimation& left, const VertexPlaces& places,
                    double least)
{
    const auto none_is_skipped = [](std::size_t, std::size_t, const Triangle3&) { return false; };
    for (const std::vector<glm::dvec3>& pose : places)
        for (Claim& claim : claims(fans, left, pose, none_is_skipped)) {
            constexpr double fine = 1.25, coarse = fine * fine * fine * fine * fine * fine;
            // One coarse step below this level was too little.
            const double level = raised(claim, least, coarse);
            least = raised(claim, std::max(least, level / coarse), fine);
        }
    return least;
}

} // namespace trivar
