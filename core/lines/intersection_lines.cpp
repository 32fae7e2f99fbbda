// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lines/intersection_lines.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <compare>
#include <optional>

namespace trivar {
namespace {

constexpr std::size_t triangles_in_a_block = 256;
constexpr float least_turn = 0.5f; // cosine of the turn at which a line ends

// A Crossing is where an edge of one body goes through a triangle of the other.
struct Crossing {
    bool of_second = false;                   // whether the edge is of the second body
    std::uint32_t a = 0, b = 0, triangle = 0; // the edge's points, the lower one first
    auto operator<=>(const Crossing&) const = default;
};
struct PlacedCrossing {
    Crossing key;
    glm::dvec3 at;
};
// The piece of line in which two triangles meet.
struct Piece {
    std::array<PlacedCrossing, 2> ends;
    std::array<glm::vec3, 2> normals;
};

// Six times the volume of a tetrahedron: above 0 where d is on the side of a, b, c from which they
// go round anticlockwise.
double volume(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d)
{
    return glm::dot(glm::cross(b - a, c - a), d - a);
}

// Whether a volume is above 0. Where it is 0 but for rounding, its growth tells, for the second
// body is taken as moved by less than any number: bodies that touch are apart then, and all
// triangles at an edge agree (simulation of simplicity: Edelsbrunner and Muecke 1990).
bool is_above(double volume, double growth, double size)
{
    constexpr double rounding = 1e-12;
    return std::abs(volume) > rounding * size ? volume > 0 : growth > 0;
}

glm::vec3 normal_of(const TriangleBody& body, std::uint32_t t)
{
    const glm::uvec3& c = body.triangles[t];
    const glm::dvec3 n =
        glm::cross(body.points[c.y] - body.points[c.x], body.points[c.z] - body.points[c.x]);
    const double length = glm::length(n);
    return length > 0 ? glm::vec3(n / length) : glm::vec3(0);
}

// Returns where an edge crosses a triangle of another body, or of its own. `apart` is the direction
// in which the second body is taken as moved.
std::optional<glm::dvec3> crossing_at(const TriangleBody& of_edge, std::uint32_t a, std::uint32_t b,
                                      const TriangleBody& other, std::uint32_t triangle,
                                      bool of_second, const glm::dvec3& apart)
{
    const glm::uvec3& c = other.triangles[triangle];
    const glm::dvec3 &p = of_edge.points[a], &q = of_edge.points[b];
    const glm::dvec3 &first = other.points[c.x], along = other.points[c.y] - first,
                     across = other.points[c.z] - first, normal = glm::cross(along, across);
    const double growth = glm::dot(normal, of_second ? apart : -apart),
                 size = glm::length(along) * glm::length(across);
    const double before = glm::dot(normal, p - first), after = glm::dot(normal, q - first);
    if (is_above(before, growth, size * glm::distance(p, first)) ==
        is_above(after, growth, size * glm::distance(q, first)))
        return {};
    std::array<bool, 3> left{};
    for (int k = 0; k < 3; ++k) {
        const std::uint32_t i = std::min(c[k], c[(k + 1) % 3]), j = std::max(c[k], c[(k + 1) % 3]);
        // The edge of the first body, then that of the second: both triangles see one number.
        std::array<glm::dvec3, 4> ends{p, q, other.points[i], other.points[j]};
        if (of_second) std::rotate(ends.begin(), ends.begin() + 2, ends.end());
        const auto& [r, s, x, y] = ends;
        left[static_cast<std::size_t>(k)] =
            is_above(volume(r, s, x, y), glm::dot(glm::cross(s - r, x - y), apart),
                     glm::distance(r, s) * glm::distance(r, x) * glm::distance(r, y)) ==
            (c[k] == i);
    }
    if (left[0] != left[1] || left[1] != left[2]) return {};
    const double share = before == after ? 0.5 : before / (before - after);
    return p + std::clamp(share, 0.0, 1.0) * (q - p);
}

// Adds the crossings of the edges of a triangle with one of the other body.
void add_crossings(std::vector<PlacedCrossing>& out, const TriangleBody& a, std::uint32_t t,
                   const TriangleBody& b, std::uint32_t u, bool of_second, const glm::dvec3& apart)
{
    const glm::uvec3& c = a.triangles[t];
    for (int k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax(c[k], c[(k + 1) % 3]);
        if (const std::optional<glm::dvec3> at = crossing_at(a, low, high, b, u, of_second, apart))
            out.push_back({{of_second && &a != &b, low, high, u}, *at});
    }
}

bool share_a_point(const glm::uvec3& a, const glm::uvec3& b)
{
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (a[i] == b[j]) return true;
    return false;
}

std::vector<Piece> pieces_between(const TriangleBody& a, const TriangleBody& b)
{
    const bool own = &a == &b;
    const glm::dvec3 between = b.tree.bounds().center() - a.tree.bounds().center(),
                     apart = between + (1e-3 * glm::length(between) + 1e-30) *
                                           glm::dvec3(0.618, 0.414, 0.732); // along no face
    const std::size_t blocks =
        (a.triangles.size() + triangles_in_a_block - 1) / triangles_in_a_block;
    std::vector<std::vector<Piece>> found(blocks);
    parallel_blocks(
        a.triangles.size(), triangles_in_a_block, [&](std::size_t begin, std::size_t end) {
            std::vector<Piece>& into = found[begin / triangles_in_a_block];
            std::vector<PlacedCrossing> crossings;
            for (auto t = static_cast<std::uint32_t>(begin); t < end; ++t) {
                if (b.tree.bounds().apart(a.boxes[t])) continue;
                for (const int near : b.tree.touching(a.boxes[t])) {
                    const auto u = static_cast<std::uint32_t>(near);
                    if (own && (u <= t || share_a_point(a.triangles[t], b.triangles[u]))) continue;
                    crossings.clear();
                    add_crossings(crossings, a, t, b, u, false, apart);
                    add_crossings(crossings, b, u, a, t, true, apart);
                    // Other than two are of triangles in one plane but for rounding.
                    if (crossings.size() != 2) continue;
                    into.push_back(
                        {{crossings[0], crossings[1]}, {normal_of(a, t), normal_of(b, u)}});
                }
            }
        });
    std::vector<Piece> out;
    for (const std::vector<Piece>& each : found) out.insert(out.end(), each.begin(), each.end());
    return out;
}

// PieceJoiner joins pieces to lines.
class PieceJoiner {
public:
    PieceJoiner(const std::vector<Piece>& pieces, const Box& bounds)
        : pieces_(pieces),
          least_(1e-9 * glm::length(bounds.size())),
          seen_(pieces.size(), 0)
    {
        out_.origin = bounds.center();
        for (const Piece& piece : pieces)
            for (const PlacedCrossing& end : piece.ends) keys_.push_back(end.key);
        std::ranges::sort(keys_);
        keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
        at_.resize(keys_.size());
        for (std::uint32_t i = 0; i < pieces.size(); ++i)
            for (std::uint32_t k = 0; k < 2; ++k) at_[node(i, k)].push_back(2 * i + k);
    }
    IntersectionLines operator()()
    {
        for (std::uint32_t n = 0; n < at_.size(); ++n)
            for (const std::uint32_t end : at_[n])
                if (!seen_[end / 2] && after(end) == none) walk(end);
        for (std::uint32_t i = 0; i < pieces_.size(); ++i)
            if (!seen_[i]) walk(2 * i);
        return std::move(out_);
    }

private:
    static constexpr std::uint32_t none = ~0u;
    // The end of piece i with a number k is 2 i + k.
    std::uint32_t node(std::uint32_t piece, std::uint32_t k) const
    {
        return static_cast<std::uint32_t>(
            std::ranges::lower_bound(keys_, pieces_[piece].ends[k].key) - keys_.begin());
    }
    glm::dvec3 place(std::uint32_t end) const { return pieces_[end / 2].ends[end % 2].at; }
    // The end of another piece with which a line goes on that leaves a piece by an end.
    std::uint32_t after(std::uint32_t end) const
    {
        const std::vector<std::uint32_t>& here = at_[node(end / 2, end % 2)];
        if (here.size() != 2) return none;
        const std::uint32_t next = here[0] == end ? here[1] : here[0];
        const glm::dvec3 in = place(end) - place(end ^ 1), out = place(next ^ 1) - place(next);
        if (glm::length(in) < least_ || glm::length(out) < least_) return next; // at an edge
        return glm::dot(in, out) >= least_turn * glm::length(in) * glm::length(out) ? next : none;
    }
    void add(std::uint32_t end)
    {
        out_.lines.points.push_back({.p = glm::vec3(place(end) - out_.origin),
                                     .polished = true,
                                     .edge = node(end / 2, end % 2)});
        out_.normals.push_back(pieces_[end / 2].normals);
    }
    // Follows a line that begins at an end, along its piece.
    void walk(std::uint32_t first)
    {
        std::uint32_t end = first;
        bool closed = false;
        while (true) {
            seen_[end / 2] = 1;
            add(end);
            const std::uint32_t next = after(end ^ 1);
            closed = next == first;
            if (next == none || closes(next)) {
                if (!closed) add(end ^ 1);
                break;
            }
            end = next;
        }
        out_.lines.closed.push_back(closed);
        out_.lines.first.push_back(static_cast<std::uint32_t>(out_.lines.points.size()));
    }
    bool closes(std::uint32_t next) const { return seen_[next / 2] != 0; }

    const std::vector<Piece>& pieces_;
    double least_; // a length that is none but for rounding
    std::vector<char> seen_;
    std::vector<Crossing> keys_;                 // ascending
    std::vector<std::vector<std::uint32_t>> at_; // the ends at each crossing
    IntersectionLines out_;
};

} // namespace

TriangleBody triangle_body(std::span<const std::pair<Ref<Mesh>, glm::dmat4>> meshes)
{
    TriangleBody out;
    for (const auto& [mesh, to_space] : meshes) {
        const std::vector<std::uint32_t> point_of =
            mesh->points.empty() ? points_by_position(mesh->positions) : mesh->points;
        const auto first = static_cast<std::uint32_t>(out.points.size());
        for (std::size_t v = 0; v < point_of.size(); ++v) {
            const std::size_t at = first + point_of[v];
            if (out.points.size() <= at) out.points.resize(at + 1);
            out.points[at] = glm::dvec3(to_space * glm::dvec4(mesh->positions[v], 1));
        }
        for (const glm::uvec3& t : triangles(*mesh)) {
            const glm::uvec3 corners(first + point_of[t.x], first + point_of[t.y],
                                     first + point_of[t.z]);
            if (corners.x == corners.y || corners.y == corners.z || corners.z == corners.x)
                continue;
            out.triangles.push_back(corners);
            Box box;
            for (int k = 0; k < 3; ++k) box.add(out.points[corners[k]]);
            out.boxes.push_back(box);
        }
    }
    out.tree = BoxTree(out.boxes);
    return out;
}

IntersectionLines intersection_lines(const TriangleBody& a, const TriangleBody& b)
{
    if (a.triangles.empty() || b.triangles.empty() || a.tree.bounds().apart(b.tree.bounds()))
        return {};
    const std::vector<Piece> pieces = pieces_between(a, b);
    return PieceJoiner(pieces, a.tree.bounds())();
}

IntersectionLines intersection_lines(const TriangleBody& body)
{
    return intersection_lines(body, body);
}

} // namespace trivar
