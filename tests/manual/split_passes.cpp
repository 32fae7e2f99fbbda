// SPDX-License-Identifier: GPL-3.0-or-later
// Lets models pass random obstacles and looks at a few frames of each pass: whether the parts are
// closed and right side out, whether vertices and points of flat triangles stay clear of the
// obstacles, and whether the model behind them is as it was. Arguments: passes, a seed, the folder
// of real models, where there is one, or "", "stitched" or "capped", and frames of each pass.
#include "core/base/rejected.h"
#include "core/files/read_model.h"
#include "core/mesh/primitives.h"
#include "core/split/split.h"
#include "tests/split/bodies.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <glm/gtc/constants.hpp>
#include <numeric>
#include <random>

namespace trivar::testing {
namespace {

using Random = std::mt19937;

double between(Random& random, double lo, double hi)
{
    return std::uniform_real_distribution<double>(lo, hi)(random);
}

glm::dmat3 any_rotation(Random& random)
{
    std::normal_distribution<double> number;
    const auto draw = [&] { return glm::dvec3(number(random), number(random), number(random)); };
    const glm::dvec3 x = glm::normalize(draw());
    const glm::dvec3 y = glm::normalize(glm::cross(x, draw()));
    return {x, y, glm::cross(x, y)};
}

// A closed tube round a curve, with a radius by angle and place.
Mesh tube(const std::function<glm::dvec3(double)>& axis, const glm::dvec3& across,
          const std::function<double(double, double)>& radius, int pieces, int round)
{
    Mesh mesh;
    for (int i = 0; i <= pieces; ++i) {
        const double s = static_cast<double>(i) / pieces;
        const glm::dvec3 t =
            glm::normalize(axis(std::min(1.0, s + 1e-4)) - axis(std::max(0.0, s - 1e-4)));
        const glm::dvec3 x = glm::normalize(glm::cross(across, t)), y = glm::cross(t, x);
        for (int j = 0; j < round; ++j) {
            const double a = glm::two_pi<double>() * j / round;
            mesh.positions.emplace_back(axis(s) +
                                        radius(a, s) * (std::cos(a) * x + std::sin(a) * y));
        }
    }
    const auto ends = static_cast<std::uint32_t>(mesh.vertex_count());
    mesh.positions.emplace_back(axis(0));
    mesh.positions.emplace_back(axis(1));
    const auto n = static_cast<std::uint32_t>(round), last = static_cast<std::uint32_t>(pieces) * n;
    for (std::uint32_t i = 0; i < last; i += n)
        for (std::uint32_t j = 0; j < n; ++j) {
            const std::uint32_t a = i + j, b = i + (j + 1) % n;
            add_face(mesh, std::array{a, b, a + n});
            add_face(mesh, std::array{b, b + n, a + n});
        }
    for (std::uint32_t j = 0; j < n; ++j) {
        add_face(mesh, std::array{ends, (j + 1) % n, j});
        add_face(mesh, std::array{ends + 1, last + j, last + (j + 1) % n});
    }
    return mesh;
}

struct Shape {
    std::string kind;
    Mesh mesh;
};

Shape any_shape(Random& random, double size)
{
    const int kind = std::uniform_int_distribution<int>(0, 6)(random);
    const double r = size * between(random, 0.05, 0.25);
    const glm::dvec3 lean(between(random, -0.9, 0.9), between(random, -0.5, 0.5), 1);
    const double reach = between(random, 0.3, 2.2); // short ones end in the model
    const int pieces = std::uniform_int_distribution<int>(1, 40)(random);
    const int round = std::uniform_int_distribution<int>(5, 48)(random);
    const auto straight = [=](double s) { return lean * (2 * s - 1) * reach; };
    const double bend = between(random, 0, 0.4), waves = between(random, 0.5, 3);
    const double slant = between(random, -0.2, 0.2);
    const auto bent = [=](double s) {
        const double z = 2 * s - 1;
        return lean * z * reach + glm::dvec3(bend, slant, 0) * std::sin(waves * z * 3);
    };
    const auto plain = [=](double, double) { return r; };
    switch (kind) {
    case 0: {
        Mesh mesh = ball(glm::dvec3(0), 1, std::max(6, round));
        const glm::dmat3 turn = any_rotation(random);
        const glm::dvec3 radii(r, size * between(random, 0.05, 0.4),
                               size * between(random, 0.05, 0.4));
        for (glm::vec3& p : mesh.positions) p = glm::vec3(turn * (radii * glm::dvec3(p)));
        return {"ball", mesh};
    }
    case 1: return {"tube", tube(straight, {0, 1, 0}, plain, pieces, round)};
    case 2: return {"bent tube", tube(bent, {0, 1, 0}, plain, 40, round)};
    case 3: {
        const int rays = std::uniform_int_distribution<int>(3, 7)(random);
        const double depth = between(random, 0.1, 0.45), twist = between(random, 0, 2);
        return {"star", tube(
                            bent, {0, 1, 0},
                            [=](double a, double s) {
                                return r * (1 + depth * std::cos(rays * (a + twist * s)));
                            },
                            24, 8 * rays)};
    }
    case 4: {
        Mesh mesh = welded(box_mesh({r, size * between(random, 0.1, 0.5), reach}, {1, 1, 1}));
        const glm::dmat3 turn = any_rotation(random);
        for (glm::vec3& p : mesh.positions) p = glm::vec3(turn * glm::dvec3(p));
        return {"box", mesh};
    }
    case 5: { // comes back along u
        const double wide = between(random, 0.2, 0.6);
        const double turned = between(random, -0.6, 0.6);
        return {"hook", tube(
                            [=](double s) {
                                const double a = 1.4 * glm::pi<double>() * s;
                                return wide *
                                       glm::dvec3(std::cos(a), turned * std::sin(a), std::sin(a));
                            },
                            glm::normalize(glm::dvec3(0, 1, -turned)), plain, 32, round)};
    }
    default: {
        Mesh mesh = welded(torus_mesh(size * 0.4, 0.5 * r + 0.02, {40, 16}));
        const glm::dmat3 turn = any_rotation(random);
        for (glm::vec3& p : mesh.positions) p = glm::vec3(turn * glm::dvec3(p));
        return {"ring", mesh};
    }
    }
}

struct Model {
    std::string name;
    Mesh mesh; // within a ball of radius 0.9 round the origin
    bool closed = true;
};

struct Edges {
    std::size_t open = 0, twice = 0;
};

Edges edges_of(const Mesh& mesh)
{
    std::vector<std::uint64_t> all;
    all.reserve(mesh.corners.size());
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
            const std::uint32_t next = c + 1 < mesh.face_begin[f + 1] ? c + 1 : mesh.face_begin[f];
            const std::uint64_t a = mesh.point(mesh.corners[c]), b = mesh.point(mesh.corners[next]);
            all.push_back(a << 32 | b);
        }
    std::ranges::sort(all);
    Edges out;
    for (std::size_t i = 0; i < all.size(); ++i) {
        out.twice += i > 0 && all[i] == all[i - 1];
        out.open += !std::ranges::binary_search(all, all[i] << 32 | all[i] >> 32);
    }
    return out;
}

// The least volume of the connected parts of a mesh.
double least_volume(const Mesh& mesh)
{
    std::vector<std::uint32_t> parent(point_count(mesh));
    std::iota(parent.begin(), parent.end(), 0u);
    const auto root = [&](std::uint32_t p) {
        while (parent[p] != p) p = parent[p] = parent[parent[p]];
        return p;
    };
    const std::vector<glm::uvec3> all = triangles(mesh);
    for (const glm::uvec3& t : all)
        for (int i = 1; i < 3; ++i) parent[root(mesh.point(t[i]))] = root(mesh.point(t[0]));
    std::vector<double> volume(parent.size(), 0);
    for (const glm::uvec3& t : all)
        volume[root(mesh.point(t[0]))] +=
            glm::dot(glm::dvec3(mesh.positions[t.x]),
                     glm::cross(glm::dvec3(mesh.positions[t.y]), glm::dvec3(mesh.positions[t.z]))) /
            6;
    return *std::ranges::min_element(volume);
}

std::vector<Model> models(const std::string& folder)
{
    std::vector<Model> out;
    out.push_back({"sphere", ball(glm::dvec3(0), 0.9, 72)});
    out.push_back({"torus", welded(torus_mesh(0.6, 0.28, {96, 48}))});
    for (const char* name : {"spot.obj", "stanford-bunny.obj", "camel.off"}) {
        const std::filesystem::path path = std::filesystem::path(folder) / "meshes" / name;
        if (folder.empty() || !std::filesystem::exists(path)) continue;
        const trivar::Model read = read_model(path.string());
        Mesh mesh = *read.meshes.at(0);
        if (mesh.points.empty()) mesh.points = points_by_position(mesh.positions);
        const Box box = bounding_box(mesh);
        const glm::dvec3 middle = (box.lo + box.hi) / 2.0;
        const double scale = 1.8 / glm::length(box.size());
        for (glm::vec3& p : mesh.positions) p = glm::vec3(scale * (glm::dvec3(p) - middle));
        const Edges edges = edges_of(mesh);
        out.push_back({name, mesh, edges.open == 0 && edges.twice == 0});
        fmt::print("{}: {} faces, {}\n", name, mesh.face_count(),
                   out.back().closed ? "closed" : "open");
    }
    return out;
}

struct Tally {
    std::size_t passes = 0, refused = 0, frames = 0, open = 0, twice = 0, inverted = 0, changed = 0,
                fans = 0, said_open = 0, beyond_tolerance = 0, samples = 0, in_obstacle = 0;
    double clearance = 1e300, certain = 1e300;
};

// How far samples of a frame are from the obstacles, along u; negative: in one.
void look_at_clearance(const SplitMesh& parted, const Mesh& before, const SplitFrame& frame,
                       const std::vector<SplitObstacle>& obstacles, std::size_t wanted,
                       Random& random, Tally& tally, const std::string& what)
{
    std::vector<std::size_t> moved; // faces
    const Mesh& mesh = parted.mesh;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        if (mesh.face_begin[f + 1] - mesh.face_begin[f] != 3) continue;
        for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
            const std::uint32_t v = mesh.corners[c];
            if (v < before.vertex_count() && mesh.positions[v] == before.positions[v]) continue;
            moved.push_back(f);
            break;
        }
    }
    if (moved.empty()) return;
    std::vector<glm::dvec3> at;
    for (const glm::vec3& p : mesh.positions) at.push_back(frame.uvw(glm::dvec3(p)));
    const std::size_t vertices = at.size();
    for (std::size_t k = 0; k < wanted; ++k) {
        const std::uint32_t* const c =
            &mesh.corners[mesh.face_begin[moved[std::uniform_int_distribution<std::size_t>(
                0, moved.size() - 1)(random)]]];
        double x = between(random, 0, 1), y = between(random, 0, 1);
        if (x + y > 1) x = 1 - x, y = 1 - y;
        at.push_back(at[c[0]] + x * (at[c[1]] - at[c[0]]) + y * (at[c[2]] - at[c[0]]));
    }
    for (const SplitObstacle& obstacle : obstacles) {
        const ObstacleColumns columns(obstacle.bodies, frame);
        std::vector<glm::dvec2> vw;
        std::vector<std::size_t> which;
        for (std::size_t i = 0; i < at.size(); ++i) {
            const Box& box = columns.box();
            if (at[i].y < box.lo.y || at[i].y > box.hi.y || at[i].z < box.lo.z ||
                at[i].z > box.hi.z)
                continue;
            vw.emplace_back(at[i].y, at[i].z);
            which.push_back(i);
        }
        const std::vector<std::optional<glm::dvec2>> extents = columns.at(vw);
        for (std::size_t i = 0; i < which.size(); ++i) {
            if (!extents[i]) continue;
            const double u = at[which[i]].x;
            const double free = std::max(extents[i]->x - u, u - extents[i]->y);
            tally.clearance = std::min(tally.clearance, free);
            if (free >= 0) continue;
            if (++tally.in_obstacle < 20)
                fmt::print("{}: {} in {} by {:.3g} m, bound {:.3g}\n", what,
                           which[i] < vertices ? "vertex" : "sample", obstacle.name, -free,
                           parted.off);
        }
    }
    tally.samples += at.size();
}

void pass(const std::vector<Model>& all, unsigned seed, SplitClosing closing, int frames,
          Tally& tally)
{
    Random random(seed);
    const Model& model = all[std::uniform_int_distribution<std::size_t>(0, all.size() - 1)(random)];
    const glm::dmat3 turn = any_rotation(random);
    const SplitFrame frame{glm::dvec3(between(random, -3, 3), between(random, -3, 3), 0), turn};
    std::vector<SplitObstacle> obstacles;
    const int count = std::max(1, std::uniform_int_distribution<int>(-2, 3)(random));
    const SplitKernel kernel =
        static_cast<SplitKernel>(std::uniform_int_distribution<int>(0, 3)(random));
    std::string what = fmt::format("seed {} {}", seed, model.name);
    for (int k = 0; k < count; ++k) {
        Shape shape = any_shape(random, count > 1 ? 0.5 : 1);
        const glm::dvec3 offset((k - 0.5 * (count - 1)) * 0.75 + between(random, -0.1, 0.1),
                                between(random, -0.3, 0.3), between(random, -0.3, 0.3));
        glm::dmat4 to_world(frame.axes);
        to_world[3] = glm::dvec4(frame.world(offset), 1);
        what += " " + shape.kind;
        obstacles.push_back(
            {shape.kind,
             {{std::make_shared<const RayMesh>(make_ref(std::move(shape.mesh))), to_world, k}},
             0.005,
             between(random, 0, 0.5),
             kernel,
             {},
             round_margin});
    }
    const glm::dmat3 model_turn = any_rotation(random);
    const glm::dvec3 beside(between(random, -0.3, 0.3), 0, between(random, -0.3, 0.3));
    const auto at = [&](double v) {
        Mesh mesh = model.mesh;
        for (glm::vec3& p : mesh.positions)
            p = glm::vec3(frame.world(model_turn * glm::dvec3(p) + beside + glm::dvec3(0, v, 0)));
        mesh.normals.clear();
        mesh.tangents.clear();
        return mesh;
    };
    ++tally.passes;
    try {
        const SplitField field = split_field(obstacles, frame);
        for (const Opening& o : field.openings)
            for (const OpeningWall& wall : o.walls) {
                tally.certain = std::min(tally.certain, wall.clear);
                if (wall.clear < 0.002) fmt::print("{}: {:.3g} m are certain\n", what, wall.clear);
            }
        const SplitOptions options{.tolerance = 2e-3, .closing = closing};
        std::vector<double>
            places; // before the samples, so that none hangs on what comes of others
        for (int k = 0; k < frames; ++k) places.push_back(between(random, -1.2, 1.2));
        for (int k = 0; k < frames; ++k) {
            const Mesh before = at(places[static_cast<std::size_t>(k)]);
            const std::optional<SplitMesh> parted = split(before, field, options);
            if (!parted) continue;
            ++tally.frames;
            tally.fans += parted->fans;
            tally.said_open += parted->open > 0;
            if (parted->off > options.tolerance) {
                ++tally.beyond_tolerance;
                fmt::print("{} frame {}: off by {:.3g} m\n", what, k, parted->off);
            }
            if (model.closed) {
                const Edges edges = edges_of(parted->mesh);
                const double volume = least_volume(parted->mesh);
                tally.open += edges.open;
                tally.twice += edges.twice;
                tally.inverted += volume < -1e-7;
                if (edges.open + edges.twice > 0 || volume < -1e-7 || parted->fans > 0)
                    fmt::print(
                        "{} frame {}: {} open edges, {} twice, least volume {:.3g}, {} fans\n",
                        what, k, edges.open, edges.twice, volume, parted->fans);
            }
            look_at_clearance(*parted, before, frame, obstacles,
                              100000 / static_cast<std::size_t>(frames), random, tally,
                              fmt::format("{} frame {}", what, k));
        }
        // Behind all of them
        const Box reach = field.reach();
        if (split(at(reach.hi.y + 0.95), field, options)) ++tally.changed;
    } catch (const Rejected&) {
        ++tally.refused;
    }
}

} // namespace
} // namespace trivar::testing

int main(int argc, char** argv)
{
    using namespace trivar::testing;
    using trivar::SplitClosing;
    const unsigned passes = argc > 1 ? static_cast<unsigned>(std::atoi(argv[1])) : 10000;
    const unsigned seed = argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 1;
    const std::vector<Model> all = models(argc > 3 ? argv[3] : "");
    const bool stitched = argc > 4 && std::string_view(argv[4]) == "stitched";
    const SplitClosing closing = stitched ? SplitClosing::stitched : SplitClosing::capped;
    const int frames = argc > 5 ? std::max(1, std::atoi(argv[5])) : 3;
    Tally tally;
    const auto report = [&] {
        fmt::print(
            "{} passes, {} refused, {} frames: {} open edges, {} twice, {} inverted, {} fans, "
            "{} said open, {} beyond the tolerance; {} samples, {} in an obstacle, least "
            "clearance {:.3g} m, {:.3g} m certain for the walls; {} changed behind\n",
            tally.passes, tally.refused, tally.frames, tally.open, tally.twice, tally.inverted,
            tally.fans, tally.said_open, tally.beyond_tolerance, tally.samples, tally.in_obstacle,
            tally.clearance, tally.certain, tally.changed);
        std::fflush(stdout);
    };
    for (unsigned i = 0; i < passes; ++i) {
        pass(all, seed + i, closing, frames, tally);
        if (i % 100 == 99) report();
    }
    report();
    const bool good =
        tally.open + tally.twice + tally.inverted + tally.in_obstacle + tally.changed == 0;
    return good ? 0 : 1;
}
