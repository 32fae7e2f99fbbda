// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/repair.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <fmt/format.h>
#include <tuple>
#include <utility>

namespace trivar {
namespace {

// Neighbours are two faces that share an edge with no third face.
struct Neighbours {
    std::uint32_t a, b;
    bool against; // both have the edge in the same direction
};

std::vector<Neighbours> neighbours(const Mesh& mesh)
{
    struct Edge {
        std::uint32_t other, face; // the larger point, and the face
        bool upward;
    };
    // Every edge is filed under its smaller point.
    const auto each_edge = [&](auto use) {
        for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
            const std::uint32_t end = mesh.face_begin[f + 1];
            std::uint32_t a = mesh.point(mesh.corners[end - 1]);
            for (std::uint32_t c = mesh.face_begin[f]; c < end; ++c) {
                const std::uint32_t b = mesh.point(mesh.corners[c]);
                use(std::min(a, b), Edge{std::max(a, b), f, a < b});
                a = b;
            }
        }
    };
    const std::size_t points = point_count(mesh);
    std::vector<std::uint32_t> begin(points + 1, 0);
    each_edge([&](std::uint32_t low, const Edge&) { ++begin[low + 1]; });
    for (std::size_t p = 0; p < points; ++p) begin[p + 1] += begin[p];
    std::vector<Edge> edges(mesh.corners.size());
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    each_edge([&](std::uint32_t low, const Edge& edge) { edges[next[low]++] = edge; });
    parallel_blocks(points, 1 << 14, [&](std::size_t first, std::size_t last) {
        for (std::size_t p = first; p < last; ++p)
            std::sort(edges.begin() + begin[p], edges.begin() + begin[p + 1],
                      [](const Edge& x, const Edge& y) {
                          return std::pair(x.other, x.face) < std::pair(y.other, y.face);
                      });
    });
    std::vector<Neighbours> result;
    for (std::size_t p = 0; p < points; ++p)
        for (std::uint32_t i = begin[p], end; i < begin[p + 1]; i = end) {
            end = i + 1;
            while (end < begin[p + 1] && edges[end].other == edges[i].other) ++end;
            if (end - i == 2 && edges[i].face != edges[i + 1].face)
                result.push_back(
                    {edges[i].face, edges[i + 1].face, edges[i].upward == edges[i + 1].upward});
        }
    return result;
}

// Chooses the faces to turn: in each component that can be consistent, the smaller of its two sets.
std::vector<bool> faces_to_turn(std::size_t faces, const std::vector<Neighbours>& pairs)
{
    struct Link {
        std::uint32_t face;
        bool against;
    };
    std::vector<std::uint32_t> begin(faces + 1, 0);
    for (const Neighbours& n : pairs) ++begin[n.a + 1], ++begin[n.b + 1];
    for (std::size_t f = 0; f < faces; ++f) begin[f + 1] += begin[f];
    std::vector<Link> links(pairs.size() * 2);
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    for (const Neighbours& n : pairs) {
        links[next[n.a]++] = {n.b, n.against};
        links[next[n.b]++] = {n.a, n.against};
    }
    std::vector<bool> seen(faces, false), turn(faces, false);
    std::vector<std::uint32_t> component;
    for (std::uint32_t start = 0; start < faces; ++start) {
        if (seen[start]) continue;
        component.assign(1, start);
        seen[start] = true;
        bool orientable = true;
        for (std::size_t i = 0; i < component.size(); ++i) {
            const std::uint32_t f = component[i];
            for (std::uint32_t l = begin[f]; l < begin[f + 1]; ++l) {
                const bool wanted = turn[f] != links[l].against;
                if (!seen[links[l].face]) {
                    seen[links[l].face] = true;
                    turn[links[l].face] = wanted;
                    component.push_back(links[l].face);
                } else if (turn[links[l].face] != wanted) {
                    orientable = false;
                }
            }
        }
        const auto turned = static_cast<std::size_t>(
            std::count_if(component.begin(), component.end(), [&](auto f) { return turn[f]; }));
        const bool other_party = turned * 2 > component.size();
        for (const std::uint32_t f : component) turn[f] = orientable && turn[f] != other_party;
    }
    return turn;
}

// Says whether corners, of which no two neighbours are at one point, have three different points.
bool has_three_points(const Mesh& mesh, const std::uint32_t* begin, const std::uint32_t* end)
{
    if (end - begin < 3) return false;
    const std::uint32_t a = mesh.point(begin[0]), b = mesh.point(begin[1]);
    return std::any_of(begin + 2, end,
                       [&](std::uint32_t v) { return mesh.point(v) != a && mesh.point(v) != b; });
}

// Removes repeated corners, then faces with fewer than three; returns the number of each.
std::pair<std::size_t, std::size_t> drop_degenerate(Mesh& mesh)
{
    std::vector<std::uint32_t> corners, face_begin{0};
    corners.reserve(mesh.corners.size());
    face_begin.reserve(mesh.face_begin.size());
    std::size_t repeats = 0, kept = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const std::size_t first = corners.size();
        const std::uint32_t end = mesh.face_begin[f + 1];
        for (std::uint32_t c = mesh.face_begin[f]; c < end; ++c) {
            const std::uint32_t v = mesh.corners[c];
            if (corners.size() > first && mesh.point(corners.back()) == mesh.point(v)) continue;
            corners.push_back(v);
        }
        while (corners.size() - first > 1 &&
               mesh.point(corners.back()) == mesh.point(corners[first]))
            corners.pop_back();
        if (!has_three_points(mesh, corners.data() + first, corners.data() + corners.size())) {
            corners.resize(first);
            continue;
        }
        if (corners.size() - first < end - mesh.face_begin[f]) ++repeats;
        face_begin.push_back(static_cast<std::uint32_t>(corners.size()));
        if (!mesh.face_material.empty()) mesh.face_material[kept] = mesh.face_material[f];
        if (!mesh.face_group.empty()) mesh.face_group[kept] = mesh.face_group[f];
        ++kept;
    }
    const std::size_t dropped = mesh.face_count() - kept;
    mesh.corners = std::move(corners);
    mesh.face_begin = std::move(face_begin);
    if (!mesh.face_material.empty()) mesh.face_material.resize(kept);
    if (!mesh.face_group.empty()) mesh.face_group.resize(kept);
    return {repeats, dropped};
}

} // namespace

Repairs& Repairs::operator+=(const Repairs& other)
{
    repeats += other.repeats;
    dropped += other.dropped;
    turned += other.turned;
    loose += other.loose;
    return *this;
}

std::vector<std::string> sentences(const Repairs& repairs)
{
    std::vector<std::string> said;
    const auto say = [&](std::size_t count, const char* one, const char* several) {
        if (count > 0) said.push_back(fmt::format("{} {}", count, count == 1 ? one : several));
    };
    say(repairs.repeats, "face had corners that repeat a point; the repeats were left out",
        "faces had corners that repeat a point; the repeats were left out");
    say(repairs.dropped, "face with fewer than three different corners was left out",
        "faces with fewer than three different corners were left out");
    say(repairs.turned, "flipped face was corrected", "flipped faces were corrected");
    say(repairs.loose, "vertex that no face uses was left out",
        "vertices that no face uses were left out");
    return said;
}

RepairedMesh repaired(Mesh mesh)
{
    Repairs repairs;
    std::tie(repairs.repeats, repairs.dropped) = drop_degenerate(mesh);
    const std::vector<Neighbours> pairs = neighbours(mesh);
    if (std::any_of(pairs.begin(), pairs.end(), [](const Neighbours& n) { return n.against; })) {
        const std::vector<bool> turn = faces_to_turn(mesh.face_count(), pairs);
        for (std::size_t f = 0; f < mesh.face_count(); ++f)
            if (turn[f])
                std::reverse(mesh.corners.begin() + mesh.face_begin[f] + 1,
                             mesh.corners.begin() + mesh.face_begin[f + 1]);
        repairs.turned = static_cast<std::size_t>(std::count(turn.begin(), turn.end(), true));
    }
    repairs.loose = mesh.vertex_count();
    RepairedMesh result{without_loose_vertices(std::move(mesh)), repairs};
    result.repairs.loose -= result.mesh.vertex_count();
    return result;
}

} // namespace trivar
