// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/cages.h"

#include "assets/make/kit.h"

#include <filesystem>
#include <map>
#include <set>

namespace make {

namespace {

using Cell = std::array<int, 3>;

void fill(std::set<Cell>& cells, glm::ivec3 first, glm::ivec3 last)
{
    for (int x = first.x; x <= last.x; ++x) {
        for (int y = first.y; y <= last.y; ++y) {
            for (int z = first.z; z <= last.z; ++z) cells.insert({x, y, z});
        }
    }
}

// The skin of the cells as quads; `place` says where a corner of the lattice goes.
Mesh skin_of(const std::set<Cell>& cells, const std::function<vec3(glm::ivec3)>& place)
{
    Mesh mesh;
    std::map<Cell, int> index;
    const auto point = [&](const Cell& corner) {
        const auto [it, fresh] = index.try_emplace(corner, int(mesh.points.size()));
        if (fresh) mesh.points.push_back(place({corner[0], corner[1], corner[2]}));
        return it->second;
    };
    constexpr int ring[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (const Cell& cell : cells) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (const int side : {0, 1}) {
                Cell beyond = cell;
                beyond[axis] += side ? 1 : -1;
                if (cells.contains(beyond)) continue;
                Face face;
                for (std::size_t i = 0; i < 4; ++i) {
                    Cell corner = cell;
                    corner[axis] += side;
                    corner[(axis + 1) % 3] += ring[i][0];
                    corner[(axis + 2) % 3] += ring[i][1];
                    face[i] = point(corner);
                }
                if (!side) std::swap(face[1], face[3]);
                mesh.faces.push_back(face);
            }
        }
    }
    return mesh;
}

// Every edge whose two ends the predicate takes, once.
std::vector<Crease> creases_where(const Mesh& mesh, float sharpness,
                                  const std::function<bool(vec3, vec3)>& wanted)
{
    std::set<std::pair<int, int>> edges;
    for (const Face& q : mesh.faces) {
        for (std::size_t i = 0; i < corner_count(q); ++i) {
            const int a = q[i], b = q[(i + 1) % corner_count(q)];
            if (wanted(mesh.points[a], mesh.points[b])) edges.insert(std::minmax(a, b));
        }
    }
    std::vector<Crease> creases;
    for (const auto& [a, b] : edges) creases.push_back({a, b, sharpness});
    return creases;
}

void append(Cage& cage, const Mesh& piece, const std::vector<Crease>& creases)
{
    const int offset = int(cage.mesh.points.size());
    cage.mesh.add(piece);
    for (const Crease& c : creases) {
        cage.creases.push_back({c.a + offset, c.b + offset, c.sharpness});
    }
}

// A standing animal: trunk, four legs with hard hooves, a rising neck, a head and a tail.
Cage quadruped_cage()
{
    std::set<Cell> cells;
    fill(cells, {1, 3, 0}, {5, 4, 2}); // trunk
    for (const int x : {1, 5}) {
        for (const int z : {0, 2}) fill(cells, {x, 0, z}, {x, 2, z}); // legs
    }
    fill(cells, {5, 5, 1}, {6, 5, 1}); // neck
    fill(cells, {6, 6, 1}, {6, 6, 1});
    fill(cells, {7, 6, 1}, {8, 6, 1}); // head
    fill(cells, {0, 4, 1}, {0, 4, 1}); // tail
    constexpr float xs[] = {0, .10f, .24f, .36f, .50f, .62f, .75f, .86f, .95f, 1.03f};
    constexpr float ys[] = {0, .07f, .28f, .47f, .60f, .74f, .86f, 1.02f};
    constexpr float zs[] = {-.145f, -.045f, .045f, .145f};
    const auto place = [&](glm::ivec3 c) {
        vec3 p(xs[c.x], ys[c.y], zs[c.z]);
        if (c.y <= 2) { // legs taper to the hoof, and the hind ones bend back at the hock
            const float center = c.x <= 2 ? .17f : .56f;
            p.x = center + (p.x - center) * (c.y == 0 ? .62f : .52f) +
                  (c.x <= 2 && c.y == 2 ? -.035f : 0.f);
            p.z = std::copysign(.095f + (std::abs(p.z) - .095f) * (c.y == 0 ? .8f : .62f), p.z);
        } else if (c.y <= 5) { // a deep chest, a tucked belly
            if (c.y == 3) p.y += c.x == 3 || c.x == 2 ? .035f : c.x == 5 ? -.035f : 0;
            if (c.y == 5 && c.x == 3) p.y -= .03f;
            if (c.y == 4 && c.x >= 1 && c.x <= 6) p.z *= 1.18f;
            if (c.y == 5 && c.x <= 6) p.z *= .82f;
        }
        if (c.x >= 6 && c.y >= 5) { // the neck leans forward, the muzzle hangs and narrows
            p += vec3(.02f, c.y == 5 ? .09f : .05f, 0);
            if (c.x >= 8) p += vec3(-.01f, -.05f - .05f * float(c.x - 8), 0);
            if (c.x == 9) p = {p.x, glm::mix(p.y, .88f, .35f), p.z * .75f};
        }
        if (c.x == 0) p = {c.y == 4 ? -.01f : .04f, c.y == 4 ? .40f : .44f, p.z * .55f}; // tail
        return p;
    };
    Cage cage{"quadruped", {}, {}};
    const Mesh mesh = skin_of(cells, place);
    append(cage, mesh, creases_where(mesh, 3, [](vec3 a, vec3 b) { return a.y + b.y < 1e-6f; }));
    return cage;
}

// An octagon about z, its rims half sharp and its flanks sunk in.
Mesh wheel(vec3 center, float radius, float half)
{
    Mesh m = lathe({{radius * .45f, -half * .6f},
                    {radius * .8f, -half},
                    {radius, -half},
                    {radius, half},
                    {radius * .8f, half},
                    {radius * .45f, half * .6f},
                    {radius * .2f, half * .5f},
                    {radius * .2f, -half * .5f}},
                   8, true);
    m.uvs.clear();
    return m.turn(90, {1, 0, 0}).move(center);
}

// A saloon: one closed body with open wheel arches, and four wheels.
Cage car_cage()
{
    std::set<Cell> cells;
    fill(cells, {0, 0, 0}, {6, 1, 2}); // up to the belt
    for (const int x : {1, 5}) {
        for (const int z : {0, 2}) cells.erase({x, 0, z}); // arches
    }
    fill(cells, {2, 2, 1}, {4, 2, 1}); // cabin
    constexpr float xs[] = {0, .10f, .29f, .43f, .57f, .70f, .89f, 1.0f};
    constexpr float ys[] = {.045f, .150f, .205f, .350f};
    constexpr float zs[] = {-.205f, -.148f, .148f, .205f};
    const auto place = [&](glm::ivec3 c) {
        vec3 p(xs[c.x], ys[c.y], zs[c.z]);
        if (c.y <= 2 && (c.x == 0 || c.x == 7)) { // rounded nose and tail
            p.z *= .86f;
            if (c.z == 0 || c.z == 3) p.x += c.x == 0 ? .03f : -.04f;
            if (c.y == 0) p.y += .025f;
        }
        if (c.y == 2 && c.x >= 5) p.y -= .014f * float(c.x - 4); // the bonnet falls
        if (c.y == 2 && c.x == 5) p.x += .03f;                   // under a raked windscreen
        if (c.y == 3) {                                          // roof, drawn in
            p.z *= .95f;
            p.x += c.x == 2 ? .04f : c.x == 5 ? -.10f : c.x == 4 ? -.03f : 0;
            if (c.x == 2 || c.x == 5) p.y -= .02f;
        }
        return p;
    };
    Cage cage{"car", {}, {}};
    const Mesh body = skin_of(cells, place);
    std::vector<Crease> creases = creases_where(
        body, 2, [](vec3 a, vec3 b) { return std::max(a.y, b.y) < .151f; }); // sills and arches
    const auto on_belt = [](vec3 p) { return p.y > .13f && p.y < .21f && std::abs(p.z) < .149f; };
    for (const Crease& c : creases_where(body, 1.2f, [&](vec3 a, vec3 b) {
             return on_belt(a) && on_belt(b) && std::abs(a.z - b.z) < .01f && a.y > .151f;
         })) {
        creases.push_back(c);
    }
    append(cage, body, creases);
    for (const float x : {.195f, .795f}) {
        for (const float side : {-1.f, 1.f}) {
            const Mesh m = wheel({x, .075f, side * .172f}, .080f, .030f);
            append(cage, m, creases_where(m, 2, [&](vec3 a, vec3 b) {
                       const auto rim = [&](vec3 p) {
                           return glm::length(vec2(p.x - x, p.y - .075f)) > .075f;
                       };
                       return rim(a) && rim(b) && std::abs(a.z - b.z) < .001f;
                   }));
        }
    }
    return cage;
}

Cage plain_cage(const std::string& name, Mesh mesh)
{
    mesh.uvs.clear();
    return {name, std::move(mesh), {}};
}

Cage jar_ring_cage()
{
    return plain_cage("jar_ring", lathe({{.08f, 0},
                                         {.17f, 0},
                                         {.24f, .16f},
                                         {.36f, .50f},
                                         {.25f, .78f},
                                         {.14f, .88f},
                                         {.16f, .97f},
                                         {.22f, 1.0f},
                                         {.19f, 1.01f},
                                         {.12f, .95f},
                                         {.11f, .88f},
                                         {.22f, .76f},
                                         {.32f, .50f},
                                         {.21f, .18f},
                                         {.08f, .05f}},
                                        10, true));
}

Cage torus_cage()
{
    std::vector<vec4> circle;
    for (int i = 0; i < 10; ++i) {
        const float a = 2 * pi * float(i) / 10;
        circle.push_back({.36f * std::cos(a), .14f, .36f * std::sin(a), .14f});
    }
    return plain_cage("torus", tube(circle, 6, true));
}

// A round tower with a wall as thick as a wall is: it spreads at its foot, carries its parapet on
// a rim, and is open from above to its floor.
Cage tower_cage()
{
    return plain_cage("tower", lathe({{.30f, 0},
                                      {.56f, 0},
                                      {.50f, .06f},
                                      {.455f, .25f},
                                      {.42f, .60f},
                                      {.40f, 1.0f},
                                      {.40f, 1.32f},
                                      {.415f, 1.40f},
                                      {.50f, 1.50f},
                                      {.505f, 1.56f},
                                      {.50f, 1.72f},
                                      {.485f, 1.76f},
                                      {.42f, 1.76f},
                                      {.40f, 1.72f},
                                      {.40f, 1.52f},
                                      {.30f, 1.48f}},
                                     12, true));
}

} // namespace

std::vector<Cage> cages()
{
    return {car_cage(),
            quadruped_cage(),
            jar_ring_cage(),
            torus_cage(),
            tower_cage(),
            plain_cage("ball", ball_mesh(.5f, 2)),
            plain_cage("rounded_cube", bevel_box({.5f, .5f, .5f}, .08f, 1, {1, 1, 1}))};
}

void write_cages(const std::string& folder)
{
    std::filesystem::create_directories(folder);
    for (const Cage& cage : cages()) {
        write_obj(cage.mesh, folder + "/" + cage.name + ".obj", cage.creases);
    }
}

} // namespace make
