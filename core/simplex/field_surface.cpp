// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplex/field_surface.h"

#include "core/base/parallel.h"
#include "core/simplex/cell_faces.h"
#include "core/simplex/cell_lattice.h"
#include "core/simplex/curved_tears.h"
#include "core/simplex/level_ring.h"
#include "core/simplex/side_difference.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace trivar {
namespace {

// Towards the middle of its cell, so that a point on a cut is on the cell's side.
constexpr double aside = 1e-8;
// Roots at a cut that are nearer than this share of an edge are one.
constexpr double continuous = 1e-6;

using Corners = std::array<std::size_t, 4>;

struct Point {             // of the lattice of a part of the cells
    glm::dvec3 at, middle; // middle: of a cell there
    std::uint32_t place;   // the same for both parts
    double value = 0;
};
struct Root {                   // where f is at the level
    std::uint32_t above, below; // points
    glm::dvec3 at{0}, normal{0};
};

struct Cap { // a triangle in a face of a cell
    CellFace<3> face;
    bool cut;
    bool with_face; // turned as the face is, outward of its cell
    std::array<SidePlace, 3> corners;
};
std::pair<std::uint32_t, std::uint32_t> ascending(std::uint32_t a, std::uint32_t b)
{
    return {std::min(a, b), std::max(a, b)};
}

class Surface {
public:
    Surface(const SimplexField& field, const std::vector<bool>& inside, double level, int steps)
        : field_(field),
          domain_(field.basis->domain()),
          inside_(inside.empty() ? std::vector<bool>(domain_.cells.size()) : inside),
          cuts_(domain_, inside_),
          level_(level),
          lattice_(steps)
    {
    }

    Mesh operator()()
    {
        find_points();
        parallel_blocks(points_.size(), 256, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                points_[i].value = f(points_[i].at, points_[i].middle, false).value;
        });
        for (std::size_t c = 0; c < domain_.cells.size(); ++c) march(c);
        solve();
        weld_roots();
        bend();
        const std::vector<CellFace<3>> faces = sorted_faces(domain_);
        for (std::size_t i = 0; i < faces.size(); ++i) {
            const bool inner = i + 1 < faces.size() && faces[i].vertices == faces[i + 1].vertices;
            if (!inner)
                add_caps(faces[i], false);
            else if (inside_[faces[i].cell] != inside_[faces[i + 1].cell])
                add_caps(faces[i], true);
            i += inner ? 1 : 0;
        }
        return finished();
    }

private:
    FieldPoint f(const glm::dvec3& x, const glm::dvec3& middle, bool gradient) const
    {
        return evaluate(field_, x + (middle - x) * aside, gradient);
    }
    bool above(std::uint32_t point) const { return points_[point].value >= level_; }

    // The corners of a cell by ascending vertex numbers.
    Corners sorted(std::size_t cell) const
    {
        Corners out{0, 1, 2, 3};
        const auto& c = domain_.cells[cell];
        std::sort(out.begin(), out.end(),
                  [&](std::size_t a, std::size_t b) { return c[a] < c[b]; });
        return out;
    }
    bool turned(const Corners& order) const
    {
        int swaps = 0;
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < i; ++j) swaps += order[j] > order[i] ? 1 : 0;
        return swaps % 2 == 1;
    }

    void find_points()
    {
        const std::size_t per_cell = lattice_.points.size();
        std::map<std::array<int, 9>, std::uint32_t> known, places; // by corners, counts and part
        number_.resize(domain_.cells.size() * per_cell);
        for (std::size_t c = 0; c < domain_.cells.size(); ++c) {
            const Corners order = sorted(c);
            glm::dvec3 middle(0);
            for (const int v : domain_.cells[c]) middle += domain_.vertex(v) / 4.0;
            for (std::size_t i = 0; i < per_cell; ++i) {
                std::array<int, 9> key;
                key.fill(-1);
                glm::dvec3 at(0);
                for (std::size_t k = 0, n = 0; k < 4; ++k) {
                    const int count = lattice_.points[i][k], v = domain_.cells[c][order[k]];
                    if (count == 0) continue;
                    key[2 * n] = v;
                    key[2 * n++ + 1] = count;
                    at += domain_.vertex(v) * (static_cast<double>(count) / lattice_.steps);
                }
                const auto [place, is_new] =
                    places.try_emplace(key, static_cast<std::uint32_t>(places.size()));
                if (is_new) place_at_.push_back(key[6] < 0 ? rounded(key) : at);
                key[8] = inside_[c] ? 1 : 0;
                const auto [point, added] =
                    known.try_emplace(key, static_cast<std::uint32_t>(points_.size()));
                if (added) points_.push_back({at, middle, place->second});
                number_[c * per_cell + i] = point->second;
            }
        }
        at_place_.resize(places.size(), {none, none});
        for (const auto& [key, point] : known)
            at_place_[points_[point].place][static_cast<std::size_t>(key[8])] = point;
    }

    // Returns the rounded place of a key, which holds vertices and their counts.
    glm::dvec3 rounded(const std::array<int, 9>& key) const
    {
        glm::dvec3 weights(0);
        for (int k = 0; k < 3; ++k)
            if (const auto i = static_cast<std::size_t>(2 * k); key[i] >= 0)
                weights[k] = static_cast<double>(key[i + 1]) / lattice_.steps;
        return cuts_.rounded({key[0], key[2], key[4]}, weights);
    }

    std::uint32_t root(std::uint32_t a, std::uint32_t b)
    {
        const auto [found, added] =
            root_of_.try_emplace(ascending(a, b), static_cast<std::uint32_t>(roots_.size()));
        if (added) roots_.push_back({above(a) ? a : b, above(a) ? b : a});
        return found->second;
    }

    void march(std::size_t cell)
    {
        const std::uint32_t* const number = &number_[cell * lattice_.points.size()];
        const bool turn = turned(sorted(cell));
        for (const auto& piece : lattice_.pieces) {
            std::array<std::uint32_t, 4> p;
            for (std::size_t k = 0; k < 4; ++k) p[k] = number[static_cast<std::size_t>(piece[k])];
            if (turn) std::swap(p[2], p[3]);
            const LevelRing cut = level_ring({above(p[0]), above(p[1]), above(p[2]), above(p[3])});
            std::array<std::uint32_t, 4> ring{};
            for (std::size_t i = 0; i < cut.size; ++i)
                ring[i] = root(p[cut.edges[i].above], p[cut.edges[i].below]);
            if (cut.odd)
                std::reverse(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(cut.size));
            for (std::size_t i = 1; i + 1 < cut.size; ++i)
                level_triangles_.push_back({ring[0], ring[i], ring[i + 1]});
        }
    }

    // Adds the part of a face that belongs to the surface: the body of its own cell minus the body
    // beyond a cut.
    void add_caps(const CellFace<3>& face, bool cut)
    {
        const Corners order = sorted(face.cell);
        const auto opposite = static_cast<std::size_t>(
            std::find(order.begin(), order.end(), face.opposite) - order.begin());
        const bool turn = turned(order);
        const std::size_t per_cell = lattice_.points.size();
        for (auto triangle : lattice_.faces[opposite]) {
            if (turn) std::swap(triangle[1], triangle[2]);
            TriangleSide here, there;
            for (std::size_t i = 0; i < 3; ++i) {
                const std::size_t j = (i + 1) % 3;
                const auto a = static_cast<std::size_t>(triangle[i]),
                           b = static_cast<std::size_t>(triangle[j]);
                const std::uint32_t p = number_[face.cell * per_cell + a],
                                    q = number_[face.cell * per_cell + b];
                here.in[i] = above(p);
                there.in[i] = cut && above(beyond(p, face.cell));
                here.corners[i] = there.corners[i] = {false, points_[p].place, a, a};
                if (above(p) != above(q))
                    here.roots[i] = {true, root_of_.at(ascending(p, q)), a, b};
                const std::uint32_t p2 = beyond(p, face.cell), q2 = beyond(q, face.cell);
                if (cut && above(p2) != above(q2))
                    there.roots[i] = {true, root_of_.at(ascending(p2, q2)), a, b};
            }
            for (std::vector<SidePlace>& loop : side_difference(here, there)) {
                if (!cut) add_rim(loop, here, beyond_of(here, face.cell, triangle));
                add_loop(loop, face, cut);
            }
        }
    }

    // Returns the values of the other cell on the edges of a triangle; unchanged where these are on
    // no cut.
    TriangleSide beyond_of(const TriangleSide& here, std::size_t cell,
                           const std::array<int, 3>& triangle) const
    {
        TriangleSide out = here;
        const std::uint32_t* const number = &number_[cell * lattice_.points.size()];
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t p = number[static_cast<std::size_t>(triangle[i])],
                                q = number[static_cast<std::size_t>(triangle[(i + 1) % 3])];
            const auto root = root_of_.find(ascending(beyond(p, cell), beyond(q, cell)));
            out.in[i] = above(beyond(p, cell));
            out.roots[i] = {true, root != root_of_.end() ? root->second : none, here.corners[i].a};
        }
        return out;
    }

    // On the rim of a cut the border has the ends of both bodies where the cut has them.
    void add_rim(std::vector<SidePlace>& loop, const TriangleSide& here,
                 const TriangleSide& there) const
    {
        for (std::size_t i = 0; i < 3; ++i) {
            const SidePiece a = piece(here, i), b = piece(there, i);
            if (a.empty() || b.empty()) continue;
            const bool from = a.from == b.from;
            if (from == (a.to == b.to)) continue;
            const SidePlace &shared = from ? a.from : a.to, &end = from ? a.to : a.from,
                            &between = from ? b.to : b.from;
            if (between.is_root && between.id == none) continue; // the edge is on no cut
            if (glm::distance(place(shared), place(between)) >=
                glm::distance(place(shared), place(end)))
                continue;
            const auto at = std::find(loop.begin(), loop.end(), a.from);
            SidePlace added = between;
            added.b = here.corners[(i + 1) % 3].a;
            loop.insert(at + 1, added);
        }
    }

    void add_loop(const std::vector<SidePlace>& loop, const CellFace<3>& face, bool cut)
    {
        glm::dvec3 area(0);
        for (std::size_t i = 1; i + 1 < loop.size(); ++i)
            area +=
                glm::cross(place(loop[i]) - place(loop[0]), place(loop[i + 1]) - place(loop[0]));
        const bool with_face = glm::dot(area, outward(domain_, face)) >= 0;
        for (std::size_t i = 1; i + 1 < loop.size(); ++i)
            caps_.push_back({face, cut, with_face, {loop[0], loop[i], loop[i + 1]}});
    }

    glm::dvec3 place(const SidePlace& corner) const
    {
        return corner.is_root ? roots_[corner.id].at : place_at_[corner.id];
    }

    // Where f is continuous at a cut, its two roots on an edge become one.
    void weld_roots()
    {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> by_places;
        std::vector<std::uint32_t> kept(roots_.size());
        for (std::uint32_t r = 0; r < roots_.size(); ++r) {
            const Point &a = points_[roots_[r].above], &b = points_[roots_[r].below];
            const std::uint32_t other =
                by_places.try_emplace(ascending(a.place, b.place), r).first->second;
            const bool same = glm::distance(roots_[other].at, roots_[r].at) <=
                              continuous * glm::distance(a.at, b.at);
            kept[r] = same ? other : r;
        }
        for (auto& [edge, root] : root_of_) root = kept[root];
        for (auto& triangle : level_triangles_)
            for (std::uint32_t& root : triangle) root = kept[root];
    }

    std::uint32_t beyond(std::uint32_t point, std::size_t cell) const
    {
        const std::uint32_t there = at_place_[points_[point].place][inside_[cell] ? 0 : 1];
        return there == none ? point : there;
    }

    // Roots on the edges of cuts go where these go.
    void bend()
    {
        for (Root& root : roots_) {
            const Point &a = points_[root.above], &b = points_[root.below];
            const double t = glm::distance(root.at, a.at) / glm::distance(b.at, a.at);
            root.at += glm::mix(place_at_[a.place] - a.at, place_at_[b.place] - b.at, t);
        }
    }

    void solve()
    {
        const auto [least, greatest] =
            std::minmax_element(points_.begin(), points_.end(),
                                [](const Point& a, const Point& b) { return a.value < b.value; });
        const double near = 1e-9 * (greatest->value - least->value);
        parallel_blocks(roots_.size(), 64, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) solve(roots_[i], near);
        });
    }

    // Regula falsi that halves the value of an end which stays [Illinois, Dowell, Jarratt, 1971].
    void solve(Root& root, double near) const
    {
        const Point &up = points_[root.above], &down = points_[root.below];
        double lo = 0, hi = 1, at_lo = up.value - level_, at_hi = down.value - level_, t = 0;
        const glm::dvec3 middle = (up.middle + down.middle) / 2.0;
        int last = 0;
        for (int step = 0; step < 60; ++step) {
            t = at_lo > at_hi ? lo + (hi - lo) * at_lo / (at_lo - at_hi) : lo;
            const double value = f(glm::mix(up.at, down.at, t), up.middle, false).value - level_;
            if (std::abs(value) <= near || hi - lo < 1e-14) break;
            if (value >= 0) {
                lo = t, at_lo = value;
                if (last == 1) at_hi /= 2;
                last = 1;
            } else {
                hi = t, at_hi = value;
                if (last == -1) at_lo /= 2;
                last = -1;
            }
        }
        root.at = glm::mix(up.at, down.at, t);
        const glm::dvec3 slope = -f(root.at, middle, true).gradient;
        root.normal = glm::length(slope) > 0 ? glm::normalize(slope) : glm::dvec3(0, 0, 1);
    }

    glm::dvec3 cap_normal(const Cap& cap, const SidePlace& corner) const
    {
        if (!cap.cut) return outward(domain_, cap.face);
        const Corners order = sorted(cap.face.cell);
        glm::dvec3 sum(0);
        for (std::size_t k = 0; k < 4; ++k)
            sum += cuts_.normal(domain_.cells[cap.face.cell][order[k]]) *
                   static_cast<double>(lattice_.points[corner.a][k] + lattice_.points[corner.b][k]);
        return glm::normalize(inside_[cap.face.cell] == cap.with_face ? sum : -sum);
    }

    // One of the two sides of all cuts, or a direction out of the border.
    std::array<long, 3> facing(const Cap& cap) const
    {
        if (cap.cut) return {inside_[cap.face.cell] == cap.with_face ? 2'000'000 : -2'000'000};
        const glm::dvec3 out = glm::round(outward(domain_, cap.face) * 1e6);
        return {static_cast<long>(out.x), static_cast<long>(out.y), static_cast<long>(out.z)};
    }

    Mesh finished() const
    {
        Mesh mesh;
        std::map<std::pair<bool, std::uint32_t>, std::uint32_t> point_of; // by root or place
        const auto add = [&](bool is_root, std::uint32_t id, const glm::dvec3& at,
                             const glm::dvec3& normal) {
            const auto point = static_cast<std::uint32_t>(point_of.size());
            mesh.points.push_back(point_of.try_emplace({is_root, id}, point).first->second);
            mesh.positions.emplace_back(at);
            mesh.normals.emplace_back(normal);
            return static_cast<std::uint32_t>(mesh.positions.size() - 1);
        };
        std::vector<std::uint32_t> of_root(roots_.size(), none);
        for (const auto& triangle : level_triangles_) {
            std::array<std::uint32_t, 3> corners;
            for (std::size_t i = 0; i < 3; ++i) {
                std::uint32_t& vertex = of_root[triangle[i]];
                const Root& root = roots_[triangle[i]];
                if (vertex == none) vertex = add(true, triangle[i], root.at, root.normal);
                corners[i] = vertex;
            }
            add_face(mesh, corners);
        }
        // Caps that face the same way share their vertices.
        std::map<std::tuple<bool, std::uint32_t, std::array<long, 3>>, std::uint32_t> of_caps;
        for (const Cap& cap : caps_) {
            std::array<std::uint32_t, 3> corners;
            for (std::size_t i = 0; i < 3; ++i) {
                const SidePlace& corner = cap.corners[i];
                const auto [found, added] =
                    of_caps.try_emplace({corner.is_root, corner.id, facing(cap)}, none);
                if (added)
                    found->second =
                        add(corner.is_root, corner.id, place(corner), cap_normal(cap, corner));
                corners[i] = found->second;
            }
            add_face(mesh, corners);
        }
        return mesh;
    }

    static constexpr std::uint32_t none = ~0U;

    const SimplexField& field_;
    const SimplexDomain<3>& domain_;
    std::vector<bool> inside_;
    CurvedTears cuts_;
    double level_;
    CellLattice lattice_;
    std::vector<Point> points_;
    std::vector<std::uint32_t> number_;                  // of each cell's points
    std::vector<std::array<std::uint32_t, 2>> at_place_; // points outside and inside, or none
    std::vector<glm::dvec3> place_at_; // of places, those on cuts where the curved cuts are
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> root_of_;
    std::vector<Root> roots_;
    std::vector<std::array<std::uint32_t, 3>> level_triangles_; // of roots
    std::vector<Cap> caps_;
};

} // namespace

Mesh field_surface(const SimplexField& field, const std::vector<bool>& inside, double level,
                   int steps)
{
    return Surface(field, inside, level, steps)();
}

} // namespace trivar
