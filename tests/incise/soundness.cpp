// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/incise/soundness.h"

#include "core/incise/piercing.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace trivar::testing {
namespace {

struct EdgeCounts {
    std::size_t open = 0, twice = 0, pinched = 0;
    long euler = 0;
};

struct DirectedEdge {
    std::uint64_t key;
    std::uint32_t corner;
    auto operator<=>(const DirectedEdge&) const = default;
};

EdgeCounts counts_of(const Mesh& mesh)
{
    std::vector<DirectedEdge> edges;
    std::vector<std::uint32_t> next(mesh.corners.size()), previous(mesh.corners.size());
    const auto key = [](std::uint32_t a, std::uint32_t b) { return std::uint64_t{a} << 32 | b; };
    const auto point = [&](std::uint32_t c) { return mesh.point(mesh.corners[c]); };
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
            next[c] = c + 1 < mesh.face_begin[f + 1] ? c + 1 : mesh.face_begin[f];
            previous[next[c]] = c;
            edges.push_back({key(point(c), point(next[c])), c});
        }
    std::ranges::sort(edges);
    const auto corner_of = [&](std::uint64_t k) {
        const auto found = std::ranges::lower_bound(edges, k, {}, &DirectedEdge::key);
        return found != edges.end() && found->key == k ? found->corner : ~0u;
    };
    EdgeCounts out;
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        out.twice += i > 0 && edges[i].key == edges[i - 1].key;
        const auto a = static_cast<std::uint32_t>(edges[i].key >> 32);
        const auto b = static_cast<std::uint32_t>(edges[i].key);
        const bool closed = corner_of(key(b, a)) != ~0u;
        out.open += !closed;
        pairs += closed;
    }
    std::vector<std::uint32_t> valence(point_count(mesh), 0), first(valence.size(), ~0u);
    for (std::uint32_t c = 0; c < mesh.corners.size(); ++c) {
        ++valence[point(c)];
        first[point(c)] = c;
    }
    long points = 0;
    for (std::uint32_t p = 0; p < valence.size(); ++p) {
        if (valence[p] == 0) continue;
        ++points;
        std::uint32_t round = 0, c = first[p];
        do {
            ++round;
            c = corner_of(key(p, point(previous[c])));
        } while (c != ~0u && c != first[p] && round <= valence[p]);
        out.pinched += c != first[p] || round != valence[p];
    }
    out.euler =
        points - static_cast<long>(pairs / 2 + out.open) + static_cast<long>(mesh.face_count());
    return out;
}

double volume_of(const Mesh& mesh, const glm::dvec3& origin)
{
    double sum = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const auto p = [&](std::uint32_t c) {
            return glm::dvec3(mesh.positions[mesh.corners[c]]) - origin;
        };
        for (std::uint32_t c = mesh.face_begin[f] + 1; c + 1 < mesh.face_begin[f + 1]; ++c)
            sum += glm::dot(p(mesh.face_begin[f]), glm::cross(p(c), p(c + 1)));
    }
    return sum / 6;
}

} // namespace

SlitFaults faults_of(const IncisedMesh& made)
{
    const Mesh &before = *made.original, &after = *made.rest;
    const EdgeCounts a = counts_of(before), b = counts_of(after);
    SlitFaults out;
    out.open = b.open - std::min(a.open, b.open);
    out.twice = b.twice - std::min(a.twice, b.twice);
    out.pinched = b.pinched - std::min(a.pinched, b.pinched);
    out.euler = b.euler - a.euler;
    std::vector<char> used_before(before.vertex_count(), 0), used(after.vertex_count(), 0);
    for (const std::uint32_t v : before.corners) used_before[v] = 1;
    for (const std::uint32_t v : after.corners) used[v] = 1;
    for (std::size_t v = 0; v < before.vertex_count(); ++v) out.lost += used_before[v] && !used[v];
    const Box box = bounding_box(before);
    const double size = glm::length(box.size());
    out.volume =
        (volume_of(after, box.center()) - volume_of(before, box.center())) / (size * size * size);
    return out;
}

std::vector<double> volumes_of_parts(const Mesh& mesh)
{
    std::vector<std::uint32_t> part(point_count(mesh));
    std::iota(part.begin(), part.end(), 0u);
    const auto root = [&](std::uint32_t p) {
        while (part[p] != p) p = part[p] = part[part[p]];
        return p;
    };
    const auto point = [&](std::uint32_t c) { return mesh.point(mesh.corners[c]); };
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (std::uint32_t c = mesh.face_begin[f] + 1; c < mesh.face_begin[f + 1]; ++c)
            part[root(point(c))] = root(point(mesh.face_begin[f]));
    std::map<std::uint32_t, double> volumes;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const auto p = [&](std::uint32_t c) { return glm::dvec3(mesh.positions[mesh.corners[c]]); };
        double& volume = volumes[root(point(mesh.face_begin[f]))];
        for (std::uint32_t c = mesh.face_begin[f] + 1; c + 1 < mesh.face_begin[f + 1]; ++c)
            volume += glm::dot(p(mesh.face_begin[f]), glm::cross(p(c), p(c + 1))) / 6;
    }
    std::vector<double> out;
    for (const auto& [first, volume] : volumes) out.push_back(volume);
    std::ranges::sort(out);
    return out;
}

std::size_t copies_apart(const Mesh& mesh)
{
    std::vector<std::uint32_t> first(point_count(mesh), ~0u);
    std::size_t apart = 0;
    for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        std::uint32_t& known = first[mesh.point(v)];
        if (known == ~0u) known = v;
        apart += mesh.positions[v] != mesh.positions[known];
    }
    return apart;
}

std::size_t piercings_at(const IncisedMesh& made, std::span<const IncisionOpening> openings)
{
    const Mesh& rest = *made.rest;
    std::vector<glm::dvec3> shut(point_count(rest)), moves(made.slots, glm::dvec3(0));
    for (std::uint32_t v = 0; v < rest.vertex_count(); ++v)
        shut[rest.point(v)] = glm::dvec3(rest.positions[v]);
    for (const IncisedMesh::Term& term : made.terms) {
        const double held = held_open(made, term.incision, openings) * (1 - double{term.held});
        moves[term.slot] += (1 - held) * share_at(openings[term.incision], double{term.share}) *
                            glm::dvec3(term.move);
    }
    std::vector<glm::dvec3> open = shut;
    std::vector<char> near(shut.size(), 0);
    for (std::size_t i = 0; i < made.moved.size(); ++i) {
        const std::uint32_t point = rest.point(made.moved[i]);
        near[point] = 1;
        open[point] = shut[point] + moves[made.slot_of_moved[i]];
    }
    std::vector<glm::uvec3> region;
    for (const glm::uvec3& t : triangles(rest)) {
        const glm::uvec3 points(rest.point(t.x), rest.point(t.y), rest.point(t.z));
        if (near[points.x] || near[points.y] || near[points.z]) region.push_back(points);
    }
    const std::vector<PiercingPair> before = piercings(shut, region);
    std::vector<PiercingPair> fresh;
    std::ranges::set_difference(piercings(open, region), before, std::back_inserter(fresh));
    return fresh.size();
}

} // namespace trivar::testing
