// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/mistake.h"
#include "core/base/parallel.h"
#include "core/mesh/mesh.h"

#include <cmath>
#include <deque>

namespace trivar {
namespace {

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// An EarCutter cuts ears from a ring of corners 0 .. n - 1, counter-clockwise in the plane. Only
// reflex corners can lie in an ear, and cutting one changes only its two neighbours: O(n) ear tests
// of O(reflex corners). If a polygon crosses itself and has no ear left, a corner is cut anyway.
// The neighbour of a cut corner waits until all others had their turn: of a round polygon each
// round cuts every second corner, and no fan of slivers at one corner results.
class EarCutter {
public:
    explicit EarCutter(std::vector<glm::dvec2> polygon)
        : p_(std::move(polygon)),
          previous_(p_.size()),
          next_(p_.size()),
          alive_(p_.size(), true)
    {
        const std::size_t n = p_.size();
        for (std::size_t i = 0; i < n; ++i) {
            previous_[i] = (i + n - 1) % n;
            next_[i] = (i + 1) % n;
        }
        for (std::size_t i = 0; i < n; ++i)
            if (reflex(i)) reflex_.push_back(i);
    }

    template <class Emit> void cut(Emit emit)
    {
        struct WaitingEar {
            std::size_t corner, round;
        };
        std::deque<WaitingEar> ears;
        std::vector<std::size_t> round_of(p_.size(), 0);
        for (std::size_t i = 0; i < p_.size(); ++i)
            if (ear(i)) ears.push_back({i, 0});
        std::size_t left = p_.size(), somewhere = 0;
        bool look_again = true; // a corner that stops being reflex may make ears anywhere
        while (left > 3) {
            std::size_t i;
            if (!ears.empty()) {
                const WaitingEar first = ears.front();
                ears.pop_front();
                i = first.corner;
                if (!alive_[i] || round_of[i] != first.round || !ear(i)) continue;
            } else if (look_again) {
                for (std::size_t c = 0; c < p_.size(); ++c)
                    if (alive_[c] && ear(c)) ears.push_back({c, round_of[c]});
                look_again = !ears.empty();
                continue;
            } else {
                while (!alive_[somewhere]) somewhere = next_[somewhere];
                i = somewhere;
            }
            const std::size_t a = previous_[i], b = next_[i];
            emit(a, i, b);
            alive_[i] = false;
            next_[a] = b;
            previous_[b] = a;
            --left;
            for (const std::size_t beside : {a, b}) {
                ++round_of[beside];
                if (ear(beside)) ears.push_back({beside, round_of[beside]});
            }
        }
        while (!alive_[somewhere]) somewhere = next_[somewhere];
        emit(previous_[somewhere], somewhere, next_[somewhere]);
    }

private:
    bool reflex(std::size_t i) const { return turn(p_[previous_[i]], p_[i], p_[next_[i]]) <= 0; }

    bool ear(std::size_t i) const
    {
        if (reflex(i)) return false;
        const glm::dvec2 a = p_[previous_[i]], b = p_[i], c = p_[next_[i]];
        for (const std::size_t j : reflex_) {
            const glm::dvec2 q = p_[j];
            if (!alive_[j] || q == a || q == b || q == c) continue;
            if (turn(a, b, q) >= 0 && turn(b, c, q) >= 0 && turn(c, a, q) >= 0 && reflex(j))
                return false;
        }
        return true;
    }

    std::vector<glm::dvec2> p_;
    std::vector<std::size_t> previous_, next_, reflex_;
    std::vector<bool> alive_;
};

// Projects the corners along the axis in which the normal is longest, counter-clockwise.
std::vector<glm::dvec2> flattened(const Mesh& mesh, std::size_t face, const glm::dvec3& normal)
{
    const glm::dvec3 size = glm::abs(normal);
    const int drop = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    int a = (drop + 1) % 3, b = (drop + 2) % 3;
    if (normal[drop] < 0) std::swap(a, b);
    std::vector<glm::dvec2> polygon;
    for (std::uint32_t c = mesh.face_begin[face]; c < mesh.face_begin[face + 1]; ++c) {
        const glm::vec3& p = mesh.positions[mesh.corners[c]];
        polygon.emplace_back(p[a], p[b]);
    }
    return polygon;
}

void cut_face(const Mesh& mesh, std::size_t face, glm::uvec3* out)
{
    const std::uint32_t* v = mesh.corners.data() + mesh.face_begin[face];
    const std::size_t n = mesh.face_begin[face + 1] - mesh.face_begin[face];
    ensure(n >= 3, "a face has fewer than three corners");
    if (n == 3) {
        *out = {v[0], v[1], v[2]};
        return;
    }
    const std::vector<glm::dvec2> p = flattened(mesh, face, area_normal(mesh, face));
    if (n == 4) {
        const bool first_diagonal = turn(p[0], p[1], p[2]) > 0 && turn(p[0], p[2], p[3]) > 0;
        const bool second_diagonal = turn(p[1], p[2], p[3]) > 0 && turn(p[1], p[3], p[0]) > 0;
        if (first_diagonal || !second_diagonal) {
            *out++ = {v[0], v[1], v[2]};
            *out = {v[0], v[2], v[3]};
        } else {
            *out++ = {v[1], v[2], v[3]};
            *out = {v[1], v[3], v[0]};
        }
        return;
    }
    EarCutter(p).cut([&](std::size_t a, std::size_t b, std::size_t c) {
        *out++ = {v[a], v[b], v[c]};
    });
}

} // namespace

std::vector<glm::uvec3> triangles(const Mesh& mesh)
{
    std::vector<glm::uvec3> result(mesh.corners.size() - 2 * mesh.face_count());
    parallel_blocks(mesh.face_count(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f)
            cut_face(mesh, f, result.data() + (mesh.face_begin[f] - 2 * f));
    });
    return result;
}

} // namespace trivar
