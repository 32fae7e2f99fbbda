// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/cap.h"

#include "core/base/array_copies.h"
#include "core/plane/triangulation.h"
#include "core/split/layered_cap.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>
#include <utility>

namespace trivar {
namespace {

// Inserts a place of a rim; `number` holds the places of the points that are there. Where another
// one is, it goes a step aside; a rim that comes to a place again finds it. Returns -1 where all
// places round it are taken.
int put_aside(Triangulation& plane, const glm::ivec2& at, int near,
              std::vector<std::uint32_t>& number, std::uint32_t place)
{
    constexpr std::array<glm::ivec2, 9> steps{
        {{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}}};
    for (const glm::ivec2& step : steps) {
        const int point = plane.insert(at + step, near);
        if (point == static_cast<int>(number.size())) {
            number.push_back(place);
            return point;
        }
        if (number[static_cast<std::size_t>(point)] == place) return point;
    }
    return -1;
}

// The places that are left out of a rim, to be closed by slivers: those nearer than `distance`, in
// parameters, to the one kept before them, and others by number.
struct LeftOut {
    double steps = 0;         // distance, in steps of the grid
    std::vector<char> places; // by number, or empty: none
};

// Returns the loop without the places left out. The slivers between both are added to `slivers`.
RimLoop thinned(const RimLoop& loop, double distance, const std::vector<char>& left_out,
                const CapOptions& options, std::vector<std::array<std::uint32_t, 3>>& slivers)
{
    const auto kept_first = std::ranges::find_if(
        loop, [&](std::uint32_t place) { return left_out.empty() || !left_out[place]; });
    if (kept_first == loop.end()) return {};
    RimLoop turned(kept_first, loop.end());
    turned.insert(turned.end(), loop.begin(), kept_first);
    RimLoop out;
    std::uint32_t last = 0; // place before the present one, kept or not
    for (const std::uint32_t place : turned) {
        const bool near = !out.empty() && glm::distance(options.places[out.back()],
                                                        options.places[place]) < distance;
        if (!out.empty() && last != out.back()) slivers.push_back({out.back(), last, place});
        if (!near && (left_out.empty() || !left_out[place])) out.push_back(place);
        last = place;
    }
    if (last != out.back()) slivers.push_back({out.back(), last, out.front()});
    return out;
}

// The places between edges of one loop that cross and are near to each other along it: a rim whose
// surface all but touches the cut surface may fold over itself by a little.
std::vector<char> tangled(const std::vector<const RimLoop*>& loops, const CapOptions& options)
{
    constexpr std::size_t most = 8; // edges apart
    std::vector<char> out(options.places.size(), 0);
    const auto turn = [](const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
        return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    };
    for (const RimLoop* loop : loops) {
        const std::size_t n = loop->size();
        const auto at = [&](std::size_t i) { return options.places[(*loop)[i % n]]; };
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = i + 2; j <= i + most && j + 1 < i + n; ++j) {
                const glm::dvec2 a = at(i), b = at(i + 1), c = at(j), d = at(j + 1);
                if (turn(a, b, c) * turn(a, b, d) > 0 || turn(c, d, a) * turn(c, d, b) > 0)
                    continue;
                for (std::size_t k = i + 1; k <= j; ++k) out[(*loop)[k % n]] = 1;
            }
    }
    return out;
}

// A rim that is to be closed.
struct OpenRim {
    const CapOptions& options;
    // Edges of its loops that no skin has, since they go across gaps of the mesh; by places.
    std::set<std::pair<std::uint32_t, std::uint32_t>> gaps = {};
};

// Points between a and b: halves it until none of its pieces is too coarse.
void add_between(const glm::dvec2& a, const glm::dvec2& b, const Coarseness& coarseness,
                 double shortest, std::vector<glm::dvec2>& out)
{
    if (glm::distance(a, b) <= shortest || coarseness({a, b, b}).edges[0] <= 1) return;
    const glm::dvec2 middle = (a + b) / 2.0;
    add_between(a, middle, coarseness, shortest, out);
    out.push_back(middle);
    add_between(middle, b, coarseness, shortest, out);
}

// Triangulates the region to the left of loops, without the places left out. Returns false, with
// nothing added, if edges cross or meet on the grid, or do not enclose it.
bool triangulate_thinned(const std::vector<const RimLoop*>& loops, const LeftOut& left_out,
                         const OpenRim& rim, FlatCap& cap)
{
    const CapOptions& options = rim.options;
    const PlaneGrid grid = grid_of(loops, options.places);
    Triangulation plane;
    std::vector<std::uint32_t> number; // of a point of the plane: that of the cap
    const std::size_t first_inside = options.places.size() + cap.inside.size();
    std::vector<glm::dvec2> inside;
    std::vector<std::pair<int, int>> edges;
    std::vector<std::array<std::uint32_t, 3>> slivers;
    for (const RimLoop* whole : loops) {
        const RimLoop loop =
            thinned(*whole, left_out.steps / grid.scale, left_out.places, options, slivers);
        if (loop.size() < 3) return false;
        std::vector<int> points(loop.size(), -1);
        // Every second one of those that are left comes next: in their order along a round loop
        // each would turn over the triangles of all before it
        const std::size_t coarsest = std::bit_ceil(loop.size());
        for (std::size_t step = coarsest; step > 0; step /= 2)
            for (std::size_t i = step == coarsest ? 0 : step; i < loop.size();
                 i += step == coarsest ? coarsest : 2 * step) {
                const glm::ivec2 at = grid.at(options.places[loop[i]]);
                const int near = i == 0 ? -1 : points[i - step];
                points[i] = put_aside(plane, at, near, number, loop[i]);
                if (points[i] < 0) return false;
            }
        for (std::size_t i = 0; i < points.size(); ++i) {
            const std::uint32_t from = loop[i], to = loop[(i + 1) % loop.size()];
            int last = points[i];
            const auto go = [&](int point) {
                edges.emplace_back(std::exchange(last, point), point);
            };
            if (options.coarseness && rim.gaps.contains({from, to})) {
                std::vector<glm::dvec2> between;
                add_between(options.places[from], options.places[to], options.coarseness,
                            grid.size / 8000, between);
                for (const glm::dvec2& each : between) {
                    const auto own = static_cast<std::uint32_t>(first_inside + inside.size());
                    const int point = put_aside(plane, grid.at(each), last, number, own);
                    if (point < 0) return false;
                    inside.push_back(each);
                    go(point);
                }
            }
            go(points[(i + 1) % points.size()]);
        }
    }
    // A rim that comes to a place again must not go along one of its edges again
    std::vector<std::pair<int, int>> once;
    for (const auto& [a, b] : edges) once.push_back(std::minmax(a, b));
    std::ranges::sort(once);
    if (std::ranges::adjacent_find(once) != once.end() ||
        std::ranges::any_of(once, [](const auto& e) { return e.first == e.second; }))
        return false;
    for (const auto& [a, b] : edges)
        if (plane.join(a, b) != Triangulation::JoinResult::one_edge) return false;
    if (!plane.fill(edges)) return false;
    FlatTriangles flat;
    for (const std::uint32_t n : number)
        flat.points.push_back(n < first_inside ? options.places[n] : inside[n - first_inside]);
    for (const Triangulation::Corners& t : plane.inside())
        flat.corners.push_back({static_cast<std::uint32_t>(t[0]), static_cast<std::uint32_t>(t[1]),
                                static_cast<std::uint32_t>(t[2])});
    if (options.coarseness) make_fine_enough(flat, options.coarseness, grid.size / 8000);
    const std::size_t from_rim = number.size(), refined = first_inside + inside.size();
    const auto number_of = [&](std::uint32_t point) {
        return point < from_rim ? number[point]
                                : static_cast<std::uint32_t>(refined + point - from_rim);
    };
    for (const auto& [a, b, c] : flat.corners)
        cap.triangles.push_back({number_of(a), number_of(b), number_of(c)});
    cap.triangles.insert(cap.triangles.end(), slivers.begin(), slivers.end());
    cap.inside.insert(cap.inside.end(), inside.begin(), inside.end());
    cap.inside.insert(cap.inside.end(), flat.points.begin() + static_cast<long>(from_rim),
                      flat.points.end());
    return true;
}

// The same with as little left out as possible.
bool triangulate(const std::vector<const RimLoop*>& loops, const OpenRim& rim, FlatCap& cap)
{
    // Where places are near to each other, rounding to single precision may make the rim cross
    // itself
    for (const double steps : {0.0, 16.0, 256.0})
        if (triangulate_thinned(loops, {steps, {}}, rim, cap)) return true;
    const std::vector<char> places = tangled(loops, rim.options);
    for (const double steps : {16.0, 256.0, 4096.0})
        if (triangulate_thinned(loops, {steps, places}, rim, cap)) return true;
    return false;
}

// Closes a loop by triangles round its middle: closed, if not without overlaps.
void close_by_fan(const RimLoop& loop, const CapOptions& options, FlatCap& cap)
{
    if (loop.size() < 3) return;
    if (loop.size() == 3) {
        cap.triangles.push_back({loop[0], loop[1], loop[2]});
        return;
    }
    glm::dvec2 middle(0);
    for (const std::uint32_t place : loop) middle += options.places[place];
    const auto at = static_cast<std::uint32_t>(options.places.size() + cap.inside.size());
    cap.inside.push_back(middle / static_cast<double>(loop.size()));
    for (std::size_t i = 0; i < loop.size(); ++i)
        cap.triangles.push_back({loop[i], loop[(i + 1) % loop.size()], at});
}

// Closes a loop without regard to others: the area that it runs round is covered, by triangles that
// are reversed if it runs clockwise. Returns false if it crosses itself.
bool close_alone(const RimLoop& loop, const OpenRim& rim, FlatCap& cap)
{
    if (triangulate({&loop}, rim, cap)) return true;
    RimLoop round = loop;
    std::ranges::reverse(round);
    const std::size_t first = cap.triangles.size();
    if (!triangulate({&round}, rim, cap)) return false;
    for (std::size_t t = first; t < cap.triangles.size(); ++t)
        std::swap(cap.triangles[t][1], cap.triangles[t][2]);
    return true;
}

// Appends the vertices of one half's caps. Returns the first one.
std::size_t add_cap_vertices(CutMesh& cut, const CapOptions& options, const FlatCap& flat, bool up)
{
    Mesh& mesh = cut.mesh;
    const std::size_t first = mesh.vertex_count();
    const std::size_t count = options.places.size() + flat.inside.size();
    // Points of the other half's inside come first
    const auto first_inside = static_cast<std::uint32_t>(
        cut.first_point + 2 * options.places.size() + (up ? flat.inside.size() : 0));
    for (std::size_t i = 0; i < count; ++i) {
        const bool on_rim = i < options.places.size();
        const glm::dvec2 at = on_rim ? options.places[i] : flat.inside[i - options.places.size()];
        mesh.positions.push_back(on_rim ? cut.places[i] : glm::vec3(options.point(at)));
        mesh.points.push_back(on_rim ? cut.point(static_cast<std::uint32_t>(i), up)
                                     : first_inside +
                                           static_cast<std::uint32_t>(i - options.places.size()));
        if (!mesh.normals.empty())
            mesh.normals.push_back(glm::vec3((up ? -1.0 : 1.0) * options.normal(at)));
        for (std::size_t set = 0; set < mesh.uvs.size(); ++set) mesh.uvs[set].emplace_back(at);
        cut.above.push_back(up);
    }
    const auto filled = [&](auto& values, const auto& value) {
        if (!values.empty()) values.resize(mesh.vertex_count(), value);
    };
    filled(mesh.tangents, glm::vec4(1, 0, 0, 1));
    filled(mesh.colors, glm::vec4(1));
    filled(mesh.influences, Mesh::Influences{});
    for (Mesh::MorphTarget& target : mesh.morph_targets) {
        filled(target.positions, glm::vec3(0));
        filled(target.normals, glm::vec3(0));
        filled(target.tangents, glm::vec3(0));
    }
    return first;
}

// Triangulates the cap of either half; counts go to `out`.
FlatCap closed(const CutMesh& cut, const CapOptions& options, Caps& out)
{
    RimLoops loops = loops_of(cut.rim, cut.places.size());
    // Where the mesh was open, the cap goes straight across the gap
    for (const RimLoop& way : loops.open) out.open += way.size() - 1;
    OpenRim rim{options};
    FlatCap flat;
    for (RimLoop& loop : joined_ways(loops.open, options.places)) {
        ++out.gaps;
        out.open -= std::min(out.open, loop.size() - 1);
        for (std::size_t i = 0; i < loop.size(); ++i)
            rim.gaps.emplace(loop[i], loop[(i + 1) % loop.size()]);
        loops.closed.push_back(std::move(loop));
    }
    for (const glm::uvec2& edge : cut.rim) rim.gaps.erase({edge.x, edge.y});
    std::vector<const RimLoop*> all;
    for (const RimLoop& loop : loops.closed)
        if (loop.size() > 2) all.push_back(&loop);
    if (!all.empty() && !triangulate(all, rim, flat)) {
        // Loops of bodies that run through each other are closed one by one
        for (const std::vector<std::size_t>& group : nested(loops.closed, options.places)) {
            std::vector<const RimLoop*> some;
            for (const std::size_t i : group)
                if (loops.closed[i].size() > 2) some.push_back(&loops.closed[i]);
            if (some.empty() || triangulate(some, rim, flat) ||
                close_in_layers(some, options, flat))
                continue;
            for (const RimLoop* loop : some) {
                if (!close_alone(*loop, rim, flat)) close_by_fan(*loop, options, flat);
                ++out.fans;
            }
        }
    }
    return flat;
}

} // namespace

Caps cap(CutMesh& cut, const CapOptions& options)
{
    Caps out;
    out.first_vertex = cut.mesh.vertex_count();
    out.first_face = cut.mesh.face_count();
    FlatCap flat;
    ArrayCopies both;
    if (!cut.rim.empty()) both.add([&] { flat = closed(cut, options, out); });
    if (options.meanwhile) both.add(options.meanwhile);
    both.run();
    if (cut.rim.empty()) return out;
    for (const bool up : {false, true}) {
        const auto first = static_cast<std::uint32_t>(add_cap_vertices(cut, options, flat, up));
        for (const auto& [a, b, c] : flat.triangles)
            add_face(cut.mesh, std::array{first + a, first + (up ? c : b), first + (up ? b : c)});
    }
    const std::size_t faces = cut.mesh.face_count();
    if (options.material != 0 && cut.mesh.face_material.empty())
        cut.mesh.face_material.resize(out.first_face, 0);
    if (!cut.mesh.face_material.empty()) cut.mesh.face_material.resize(faces, options.material);
    if (!cut.mesh.face_group.empty()) cut.mesh.face_group.resize(faces, 0);
    for (int half = 0; half < 2; ++half) {
        out.parameters.insert(out.parameters.end(), options.places.begin(), options.places.end());
        out.parameters.insert(out.parameters.end(), flat.inside.begin(), flat.inside.end());
    }
    return out;
}

} // namespace trivar
