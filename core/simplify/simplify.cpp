// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplify/simplify.h"

#include "core/base/box.h"
#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/mesh/shading.h"
#include "core/simplify/kept_mesh.h"
#include "core/simplify/proof.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace trivar {
namespace {

// Returns the positions of the vertices at rest, with each morph target and in each pose.
VertexPlaces places_of(const Mesh& mesh, const SimplifyOptions& options)
{
    VertexPlaces out;
    const glm::dvec3 middle = bounding_box(mesh).center();
    const auto add = [&](const auto& position) {
        auto& places = out.emplace_back(mesh.vertex_count());
        for (std::size_t v = 0; v < places.size(); ++v)
            places[v] = glm::dvec3(position(v)) - middle;
    };
    add([&](std::size_t v) { return mesh.positions[v]; });
    for (const Mesh::MorphTarget& target : mesh.morph_targets)
        if (!target.positions.empty())
            add([&](std::size_t v) {
                return glm::dvec3(mesh.positions[v]) + glm::dvec3(target.positions[v]);
            });
    for (const auto& pose : options.poses) add([&](std::size_t v) { return pose[v]; });
    return out;
}

NodePlaces by_node(const Fans& fans, const VertexPlaces& places)
{
    NodePlaces out;
    for (const auto& pose : places) {
        auto& at = out.emplace_back();
        for (const std::uint32_t v : fans.vertex) at.push_back(pose[v]);
    }
    return out;
}

void check(const Mesh& mesh, const SimplifyOptions& options)
{
    if (options.error && !(*options.error >= 0 && std::isfinite(*options.error)))
        throw Rejected(
            fmt::format("the error of a simplification must be 0 or more, not {}", *options.error));
    for (const auto& pose : options.poses)
        if (pose.size() != mesh.vertex_count())
            throw Rejected(fmt::format("a pose to simplify for has {} vertices, the mesh has {}",
                                       with_commas(pose.size()), with_commas(mesh.vertex_count())));
}

// Returns the distance below which single precision cannot separate two places.
double rounding_of(const Mesh& mesh)
{
    return 0x1p-24 * glm::length(bounding_box(mesh).size());
}

// Decimates until no triangle is further away than the error. The tolerance of quadrics is a mean
// and not a bound, so that each node that is not proven gets half its tolerance and decimation
// starts again; nodes that still fail after some rounds are left unchanged. Two or three rounds are
// usual.
Decimation decimated_within(double error, const Mesh& mesh, const Fans& fans,
                            const VertexPlaces& places, std::size_t triangles,
                            const Progress& progress)
{
    constexpr double first_share = 0.5; // of the error: more means more rounds, less more triangles
    constexpr int halvings = 5, most_rounds = 12;
    const NodePlaces nodes = by_node(fans, places);
    DecimationTarget target{triangles,
                            std::vector<double>(fans.vertex.size(), first_share * error)};
    Proof proof(fans, places, error);
    double done = 0;
    for (int round = 0; round < most_rounds; ++round) {
        const double next = (done + 1) / 2;
        Decimation left =
            decimated(mesh, fans, nodes, target, part_of(progress, done, (done + next) / 2));
        const std::vector<std::uint32_t> bad = proof.unproven_nodes(left);
        if (bad.empty()) return left;
        for (const std::uint32_t n : bad)
            target.tolerance[n] = round < halvings ? target.tolerance[n] / 2 : -1;
        report(progress, done = next, "Simplifying");
    }
    std::ranges::fill(target.tolerance, -1);
    return decimated(mesh, fans, nodes, target);
}

// Simplifies a mesh whose normals follow from its faces as if it were smooth: edges of noise, as of
// a scan, must not stay because normals differ there, which says nothing that the faces do not.
SimplifiedMesh simplified_as_smooth(const Mesh& mesh, const SimplifyOptions& options,
                                    const Progress& progress)
{
    Mesh smooth = mesh;
    smooth.normals = smooth_normals(mesh);
    return simplified(make_ref(std::move(smooth)), options, progress);
}

} // namespace

SimplifiedMesh simplified(const Ref<Mesh>& mesh, const SimplifyOptions& options,
                          const Progress& progress)
{
    check(*mesh, options);
    const std::size_t before = mesh->corners.size() - 2 * mesh->face_count();
    SimplifiedMesh out{mesh, before, before, 0, 0};
    const std::size_t wanted = options.triangles.value_or(options.error ? 0 : before);
    if (wanted >= before) return out;
    const std::optional<float> by = shading_of(*mesh);
    const Progress first = by ? part_of(progress, 0, 0.5) : progress;
    const Fans fans = fans_of(*mesh);
    out.left_out = fans.left_out;
    const VertexPlaces places = places_of(*mesh, options);
    // The part left out keeps all its triangles, and the rest its own share of them.
    const std::size_t rest = before - fans.left_out;
    const auto triangles = static_cast<std::size_t>(std::ceil(
        static_cast<double>(wanted) * static_cast<double>(rest) / static_cast<double>(before)));
    const double error = std::max(options.error.value_or(0), rounding_of(*mesh));
    const Decimation left =
        options.error ? decimated_within(error, *mesh, fans, places, triangles, first)
                      : decimated(*mesh, fans, by_node(fans, places), {triangles, {}}, first);
    out.triangles = left.count + fans.left_out;
    if (out.triangles < before) {
        out.error = options.error ? error : std::numeric_limits<double>::infinity();
        if (options.measured && !options.error)
            out.error = proven_error(fans, left, places, rounding_of(*mesh));
        out.mesh = make_ref(kept_mesh(*mesh, fans, left));
    }
    if (!by) return out;
    if (out.triangles > triangles + fans.left_out)
        if (SimplifiedMesh other = simplified_as_smooth(*mesh, options, part_of(progress, 0.5, 1));
            other.triangles < out.triangles)
            out = std::move(other);
    if (out.mesh != mesh) out.mesh = make_ref(shaded(*out.mesh, *by));
    return out;
}

} // namespace trivar
