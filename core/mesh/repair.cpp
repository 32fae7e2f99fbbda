// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/repair.h"

#include "core/base/parallel.h"
#include "core/mesh/face_edges.h"
#include "core/mesh/joined_borders.h"
#include "core/mesh/orientation.h"

#include <algorithm>
#include <atomic>
#include <fmt/format.h>
#include <tuple>
#include <utility>

namespace trivar {
namespace {

// Chooses the faces that have the places, the direction and the material of an earlier face. Only
// faces are looked at that are crowded, or all of whose corners lie where other points lie.
std::vector<bool> doubled_faces(const Mesh& mesh, const FaceEdges& edges)
{
    const bool at_seams = !mesh.points.empty() && (!edges.border.empty() || edges.parts > 1);
    if (edges.crowded.empty() && !at_seams) return {};
    std::vector<std::uint32_t> place = mesh.points;
    std::vector<bool> looked_at(mesh.face_count(), false);
    for (const std::uint32_t f : edges.crowded) looked_at[f] = true;
    if (at_seams) {
        place = points_by_position(mesh.positions);
        std::vector<std::uint32_t> point(mesh.vertex_count(), ~0u); // the first at each place
        std::vector<bool> several(mesh.vertex_count(), false);
        for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
            std::uint32_t& known = point[place[v]];
            if (known == ~0u) known = mesh.point(v);
            if (known != mesh.point(v)) several[place[v]] = true;
        }
        for (std::size_t f = 0; f < mesh.face_count(); ++f)
            if (std::all_of(mesh.corners.begin() + mesh.face_begin[f],
                            mesh.corners.begin() + mesh.face_begin[f + 1],
                            [&](std::uint32_t v) { return several[place[v]]; }))
                looked_at[f] = true;
    }
    // The places of each face from the smallest on, its material, and behind them its number
    std::vector<std::pair<std::vector<std::uint32_t>, std::uint32_t>> faces;
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
        if (!looked_at[f]) continue;
        std::vector<std::uint32_t>& key = faces.emplace_back(std::vector<std::uint32_t>(), f).first;
        for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c)
            key.push_back(place.empty() ? mesh.corners[c] : place[mesh.corners[c]]);
        std::rotate(key.begin(), std::ranges::min_element(key), key.end());
        key.push_back(mesh.face_material.empty() ? 0 : mesh.face_material[f]);
    }
    std::sort(faces.begin(), faces.end());
    std::vector<bool> doubled(mesh.face_count(), false);
    for (std::size_t i = 1; i < faces.size(); ++i)
        doubled[faces[i].second] = faces[i].first == faces[i - 1].first;
    return doubled;
}

// Says whether corners, of which no two neighbours are at one point, have three different points.
bool has_three_points(const Mesh& mesh, const std::uint32_t* begin, const std::uint32_t* end)
{
    if (end - begin < 3) return false;
    const std::uint32_t a = mesh.point(begin[0]), b = mesh.point(begin[1]);
    return std::any_of(begin + 2, end,
                       [&](std::uint32_t v) { return mesh.point(v) != a && mesh.point(v) != b; });
}

// Whether no face repeats a point or has fewer than three.
bool all_whole(const Mesh& mesh)
{
    std::atomic<bool> whole{true};
    parallel_blocks(mesh.face_count(), 1 << 15, [&](std::size_t first, std::size_t last) {
        for (std::size_t f = first; f < last; ++f) {
            const std::uint32_t* const begin = mesh.corners.data() + mesh.face_begin[f];
            const std::uint32_t* const end = mesh.corners.data() + mesh.face_begin[f + 1];
            bool good = has_three_points(mesh, begin, end);
            for (const std::uint32_t* c = begin; c < end && good; ++c)
                good = mesh.point(*c) != mesh.point(c + 1 < end ? c[1] : *begin);
            if (!good) whole.store(false, std::memory_order_relaxed);
        }
    });
    return whole;
}

// Removes repeated corners, then faces with fewer than three, and the chosen faces; returns the
// number of the first and the second.
std::pair<std::size_t, std::size_t> drop_degenerate(Mesh& mesh,
                                                    const std::vector<bool>& chosen = {})
{
    if (chosen.empty() && all_whole(mesh)) return {};
    std::vector<std::uint32_t> corners, face_begin{0};
    corners.reserve(mesh.corners.size());
    face_begin.reserve(mesh.face_begin.size());
    std::size_t repeats = 0, kept = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const std::size_t first = corners.size();
        const std::uint32_t end = mesh.face_begin[f + 1];
        if (!chosen.empty() && chosen[f]) continue;
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
    doubled += other.doubled;
    turned += other.turned;
    inside_out += other.inside_out;
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
    say(repairs.doubled, "face lay on another one with the same corners and was left out",
        "faces lay on others with the same corners and were left out");
    say(repairs.turned, "flipped face was corrected", "flipped faces were corrected");
    say(repairs.inside_out, "closed part was inside out and was turned",
        "closed parts were inside out and were turned");
    say(repairs.loose, "vertex that no face uses was left out",
        "vertices that no face uses were left out");
    return said;
}

RepairedMesh repaired(Mesh mesh)
{
    Repairs repairs;
    std::tie(repairs.repeats, repairs.dropped) = drop_degenerate(mesh);
    FaceEdges edges(mesh);
    const std::vector<bool> doubled = doubled_faces(mesh, edges);
    repairs.doubled = static_cast<std::size_t>(std::ranges::count(doubled, true));
    if (repairs.doubled > 0) {
        drop_degenerate(mesh, doubled);
        edges = FaceEdges(mesh);
    }
    if (!edges.border.empty()) {
        JoinedBorders joined = with_joined_borders(std::move(mesh), edges.border);
        mesh = std::move(joined.mesh);
        if (joined.any) {
            const auto [repeats, dropped] = drop_degenerate(mesh);
            repairs.repeats += repeats;
            repairs.dropped += dropped;
            edges = FaceEdges(mesh);
        }
    }
    const TurnedFaces turned = orient(mesh, edges);
    repairs.turned = turned.faces;
    repairs.inside_out = turned.inside_out;
    repairs.loose = mesh.vertex_count();
    RepairedMesh result{without_loose_vertices(std::move(mesh)), repairs};
    result.repairs.loose -= result.mesh.vertex_count();
    return result;
}

} // namespace trivar
