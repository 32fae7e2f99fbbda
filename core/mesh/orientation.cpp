// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/orientation.h"

#include "core/base/parallel.h"
#include "core/mesh/outside.h"

#include <algorithm>

namespace trivar {
namespace {

// The faces to turn so that each part looks one way, where it can at all; most faces stay.
struct OneWay {
    std::vector<bool> turn;             // #F
    std::vector<bool> possible, turned; // #parts: that it can; that some of its faces turn
};
OneWay one_way(std::size_t faces, const FaceEdges& edges)
{
    struct Link {
        std::uint32_t face;
        bool against;
    };
    OneWay out;
    out.turn.assign(faces, false);
    out.possible.assign(edges.parts, true);
    out.turned.assign(edges.parts, false);
    if (edges.neighbours.empty()) return out;
    std::vector<std::uint32_t> begin(faces + 1, 0);
    for (const auto& n : edges.neighbours) ++begin[n.a + 1], ++begin[n.b + 1];
    for (std::size_t f = 0; f < faces; ++f) begin[f + 1] += begin[f];
    std::vector<Link> links(edges.neighbours.size() * 2);
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    for (const auto& n : edges.neighbours) {
        links[next[n.a]++] = {n.b, n.against};
        links[next[n.b]++] = {n.a, n.against};
    }
    std::vector<bool> seen(faces, false);
    std::vector<std::uint32_t> part;
    for (std::uint32_t start = 0; start < faces; ++start) {
        if (seen[start]) continue;
        part.assign(1, start);
        seen[start] = true;
        bool possible = true;
        for (std::size_t i = 0; i < part.size(); ++i) {
            const std::uint32_t f = part[i];
            for (std::uint32_t l = begin[f]; l < begin[f + 1]; ++l) {
                const bool wanted = out.turn[f] != links[l].against;
                if (!seen[links[l].face]) {
                    seen[links[l].face] = true;
                    out.turn[links[l].face] = wanted;
                    part.push_back(links[l].face);
                } else if (out.turn[links[l].face] != wanted) {
                    possible = false;
                }
            }
        }
        const auto turned = static_cast<std::size_t>(
            std::ranges::count_if(part, [&](auto f) { return out.turn[f]; }));
        const bool other_party = turned * 2 > part.size();
        for (const std::uint32_t f : part) out.turn[f] = possible && out.turn[f] != other_party;
        out.possible[edges.part_of[start]] = possible;
        out.turned[edges.part_of[start]] = possible && turned > 0 && turned < part.size();
    }
    return out;
}

// Six times the volume that each part encloses, where it is closed, and the sum of the sizes of its
// terms, to which rounding is relative.
struct Enclosed {
    double volume = 0, terms = 0;
    void add(double term) { volume += term, terms += std::abs(term); }
    void add(const Enclosed& other) { volume += other.volume, terms += other.terms; }
    bool inside_out() const { return volume < -1e-6 * terms; }
};
std::vector<Enclosed> enclosed(const Mesh& mesh, const FaceEdges& edges)
{
    constexpr std::size_t per_block = 1 << 14;
    const std::size_t faces = mesh.face_count();
    const auto place = [&](std::size_t f) {
        return glm::dvec3(mesh.positions[mesh.corners[mesh.face_begin[f]]]);
    };
    std::vector<std::size_t> first(edges.parts, faces); // its first face, near all of its others
    for (std::size_t f = faces; f-- > 0;) first[edges.part_of[f]] = f;
    const auto add = [&](std::size_t begin, std::size_t end, auto& to) {
        for (std::size_t f = begin; f < end; ++f)
            if (const std::uint32_t part = edges.part_of[f]; !edges.open[part])
                to[part].add(glm::dot(area_normal(mesh, f), place(f) - place(first[part])));
    };
    std::vector<Enclosed> out(edges.parts);
    if (edges.parts != 1) {
        add(0, faces, out);
        return out;
    }
    std::vector<std::array<Enclosed, 1>> blocks(faces / per_block + 1);
    parallel_blocks(faces, per_block, [&](std::size_t begin, std::size_t end) {
        add(begin, end, blocks[begin / per_block]);
    });
    for (const auto& block : blocks) out[0].add(block[0]);
    return out;
}

std::vector<Box> boxes_of(const Mesh& mesh, const FaceEdges& edges)
{
    std::vector<Box> out(edges.parts);
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c)
            out[edges.part_of[f]].add(glm::dvec3(mesh.positions[mesh.corners[c]]));
    return out;
}

constexpr std::size_t most_compared = 100'000'000;

bool holds(const Box& box, const Box& other)
{
    return glm::all(glm::lessThanEqual(box.lo, other.lo)) &&
           glm::all(glm::greaterThanEqual(box.hi, other.hi));
}

// Whether a part shows more of its back, by a clear majority: sheets show both sides alike.
bool shows_its_back(const SeenSides& seen)
{
    return static_cast<double>(seen.back) > 1.2 * static_cast<double>(seen.front);
}

// Chooses the parts to turn as a whole: those of `suspects` that show their backs outside.
std::vector<bool> parts_to_turn(const Mesh& mesh, const FaceEdges& edges,
                                const std::vector<bool>& suspects,
                                const std::vector<Enclosed>& enclosed)
{
    std::vector<bool> turn(edges.parts, false);
    const std::vector<Box> boxes = boxes_of(mesh, edges);
    std::vector<std::uint32_t> unsure;
    bool look = false;
    std::size_t compared = 0; // boxes, of which a file that is made to be slow has too many
    for (std::uint32_t p = 0; p < edges.parts; ++p) {
        if (!suspects[p]) continue;
        const bool inside_out = !edges.open[p] && enclosed[p].inside_out();
        if (inside_out && (compared += edges.parts) > most_compared) continue;
        turn[p] = inside_out && std::ranges::count_if(boxes, [&](const Box& other) {
                                    return holds(other, boxes[p]);
                                }) == 1; // its own
        look = look || !turn[p];
        if (inside_out && !turn[p]) unsure.push_back(p);
    }
    if (!look) return turn;
    const std::vector<SeenSides> seen =
        seen_from_outside(mesh, edges.part_of, edges.parts, bounding_box(mesh));
    for (std::uint32_t p = 0; p < edges.parts; ++p)
        turn[p] = turn[p] || (suspects[p] && shows_its_back(seen[p]));
    // Parts too small for pictures of the whole have pictures of their own.
    constexpr std::uint64_t few_pixels = 64;
    constexpr std::size_t most_pictures = 8;
    std::erase_if(unsure, [&](auto p) { return seen[p].front + seen[p].back > few_pixels; });
    std::ranges::stable_sort(unsure, std::ranges::greater(),
                             [&](auto p) { return glm::length(boxes[p].size()); });
    unsure.resize(std::min(unsure.size(), most_pictures));
    for (const std::uint32_t p : unsure)
        turn[p] = shows_its_back(seen_from_outside(mesh, edges.part_of, edges.parts, boxes[p])[p]);
    return turn;
}

void turn_round(Mesh& mesh, std::size_t face)
{
    std::reverse(mesh.corners.begin() + mesh.face_begin[face] + 1,
                 mesh.corners.begin() + mesh.face_begin[face + 1]);
}

// Turns the normals of turned faces that look into the faces round their vertex.
void turn_normals(Mesh& mesh, const std::vector<bool>& turned)
{
    if (mesh.normals.empty()) return;
    std::vector<glm::dvec3> sums(mesh.vertex_count(), glm::dvec3(0));
    std::vector<bool> touched(mesh.vertex_count(), false);
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const glm::dvec3 normal = area_normal(mesh, f);
        for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
            sums[mesh.corners[c]] += normal;
            if (turned[f]) touched[mesh.corners[c]] = true;
        }
    }
    for (std::size_t v = 0; v < sums.size(); ++v)
        if (touched[v] && glm::dot(sums[v], glm::dvec3(mesh.normals[v])) < 0) {
            mesh.normals[v] = -mesh.normals[v];
            if (!mesh.tangents.empty()) mesh.tangents[v].w = -mesh.tangents[v].w;
        }
}

} // namespace

TurnedFaces orient(Mesh& mesh, const FaceEdges& edges)
{
    OneWay ways = one_way(mesh.face_count(), edges);
    const bool mixed = std::ranges::find(ways.turned, true) != ways.turned.end();
    for (std::size_t f = 0; mixed && f < mesh.face_count(); ++f)
        if (ways.turn[f]) turn_round(mesh, f);
    const std::vector<Enclosed> enclosed = trivar::enclosed(mesh, edges);
    std::vector<bool> suspects(edges.parts, false);
    for (std::size_t p = 0; p < edges.parts; ++p)
        suspects[p] = ways.possible[p] && (mixed || (!edges.open[p] && enclosed[p].inside_out()));
    TurnedFaces out;
    const bool some = std::ranges::find(suspects, true) != suspects.end();
    if (!some && !mixed) return out;
    const std::vector<bool> whole = parts_to_turn(mesh, edges, suspects, enclosed);
    for (std::size_t p = 0; p < edges.parts; ++p)
        out.inside_out += whole[p] && !edges.open[p] && !ways.turned[p];
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const std::uint32_t part = edges.part_of[f];
        if (whole[part]) turn_round(mesh, f);
        if (whole[part]) ways.turn[f] = !ways.turn[f];
        out.faces += ways.turn[f] && (edges.open[part] || ways.turned[part]);
    }
    turn_normals(mesh, ways.turn);
    return out;
}

} // namespace trivar
