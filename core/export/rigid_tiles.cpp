// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/rigid_tiles.h"

#include "core/base/finite.h"
#include "core/base/parallel.h"
#include "core/base/text.h"
#include "core/certificate/certificate.h"
#include "core/files/file_sentences.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

using Way = RigidTile::Way;

// Fits a tile as an instance.
void fit_parts(RigidTile& tile, const std::vector<const Part*>& parts,
               const std::vector<BentPlaces>& places, StoredParts stored)
{
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const Mesh& unit = *parts[k]->tiles->model->mesh;
        const std::optional<NodeTransform> fitted = fitted_parts(unit, places[k]);
        if (!fitted) {
            tile.parts.clear();
            tile.matrices.clear();
            tile.off_instance = infinite;
            return;
        }
        tile.parts.push_back(stored(*fitted));
        tile.matrices.push_back(tile.parts.back().matrix());
        tile.off_instance =
            std::max(tile.off_instance, furthest(unit, places[k], tile.matrices.back()));
    }
}

RigidTile rigid_tile(const std::vector<const Part*>& parts, std::size_t number, double tolerance,
                     StoredParts stored)
{
    RigidTile out;
    out.off = out.off_instance = infinite;
    // An instance has no colour of its own.
    if (is_tinted((*parts.front()->tiles->tiles)[number])) return out;
    out.off_instance = 0;
    std::vector<BentPlaces> places;
    for (const Part* part : parts)
        places.push_back(
            bent_places(*part->tiles->model->mesh, (*part->tiles->tiles)[number], part->to_world));
    fit_parts(out, parts, places, stored);
    out.off = out.off_instance;
    out.way = Way::instance;
    if (out.off_instance <= tolerance) return out;
    std::vector<glm::dmat4> sheared;
    double off = 0;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const Mesh& unit = *parts[k]->tiles->model->mesh;
        sheared.push_back(fitted_matrix(unit, places[k]));
        if (!(glm::determinant(glm::dmat3(sheared.back())) > 0)) off = infinite;
        off = std::max(off, furthest(unit, places[k], sheared.back()));
    }
    out.way = off <= tolerance ? Way::sheared : Way::bent;
    if (out.way == Way::sheared) out.off = off;
    out.matrices = out.way == Way::sheared ? std::move(sheared) : std::vector<glm::dmat4>();
    return out;
}

void count(RigidCount& counts, const RigidTile& tile)
{
    counts.instances += tile.way == Way::instance;
    counts.sheared += tile.way == Way::sheared;
    counts.bent += tile.way == Way::bent;
    double& off = tile.way == Way::bent ? counts.off_bent : counts.off;
    if (tile.off < infinite) off = std::max(off, tile.off);
}

// Returns the tiles of a part that stay bent.
Part bent_rest(const Part& part, const std::vector<RigidTile>& rigid)
{
    std::vector<PlacedTile> bent;
    for (std::size_t i = 0; i < rigid.size(); ++i)
        if (rigid[i].way == Way::bent) bent.push_back((*part.tiles->tiles)[i]);
    Part out;
    out.rest = make_ref(bent_tiles(*part.tiles->model->mesh, bent));
    out.to_world = part.to_world;
    out.key = part.key;
    out.bounds = bounding_box(*out.rest);
    return out;
}

Part rigid_part(const Part& part, const glm::dmat4& to_world)
{
    Part out;
    out.rest = part.tiles->model->mesh;
    out.to_world = to_world;
    out.key = part.key;
    out.bounds = part.tiles->model->box;
    return out;
}

} // namespace

NodeTransform in_single_precision(const NodeTransform& parts)
{
    return {glm::dvec3(glm::vec3(parts.translation)), glm::dquat(glm::quat(parts.rotation)),
            glm::dvec3(glm::vec3(parts.scale))};
}

std::vector<RigidTile> rigid_tiles(const std::vector<const Part*>& parts, double tolerance,
                                   StoredParts stored)
{
    std::vector<RigidTile> out(parts.front()->tiles->tiles->size());
    parallel_blocks(out.size(), 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) out[i] = rigid_tile(parts, i, tolerance, stored);
    });
    return out;
}

std::vector<std::vector<std::size_t>> parts_of_tiles(const std::vector<Part>& parts)
{
    std::vector<std::vector<std::size_t>> out;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        if (!parts[p].drawn_from_tiles()) continue;
        const auto same = [&](const std::vector<std::size_t>& group) {
            return parts[group.front()].tiles->tiles == parts[p].tiles->tiles;
        };
        if (const auto group = std::ranges::find_if(out, same); group != out.end())
            group->push_back(p);
        else
            out.push_back({p});
    }
    return out;
}

RigidScene with_rigid_tiles(const Evaluation& evaluated, const Document& document, double tolerance)
{
    RigidScene out{evaluated, {}};
    for (auto& [id, ref] : out.evaluated.objects) {
        const auto groups = parts_of_tiles(ref->parts);
        if (groups.empty()) continue;
        EvaluatedObject changed = *ref;
        RigidCount counts{.name = object(document, id).name};
        for (const std::vector<std::size_t>& group : groups) {
            std::vector<const Part*> parts;
            for (const std::size_t p : group) parts.push_back(&ref->parts[p]);
            const std::vector<RigidTile> rigid = rigid_tiles(parts, tolerance, in_single_precision);
            for (const RigidTile& tile : rigid) count(counts, tile);
            for (std::size_t k = 0; k < group.size(); ++k) {
                changed.parts[group[k]] = bent_rest(*parts[k], rigid);
                for (const RigidTile& tile : rigid)
                    if (tile.way != Way::bent)
                        changed.parts.push_back(rigid_part(*parts[k], tile.matrices[k]));
            }
        }
        ref = make_ref(std::move(changed));
        out.counts.push_back(std::move(counts));
    }
    return out;
}

std::vector<std::string> sentences(const std::vector<RigidCount>& counts, double tolerance)
{
    std::vector<std::string> out;
    for (const RigidCount& each : counts) {
        const std::size_t rigid = each.instances + each.sheared;
        std::string words = fmt::format(
            "{}{}: {} of its {}", printable(each.name),
            each.meshes > 1 ? fmt::format(", {} meshes", each.meshes) : "", each.instances,
            counted(rigid + each.bent, "tile is an instance", "tiles are instances"));
        if (each.sheared > 0)
            words +=
                fmt::format(", {} with a matrix", counted(each.sheared, "is a node", "are nodes"));
        if (rigid > 0) words += fmt::format(", off by {} at most", bound_text(each.off));
        if (each.bent > 0) words += "; " + counted(each.bent, "stays bent", "stay bent");
        if (each.bent > 0 && each.off_bent > 0)
            words += fmt::format(": instances would be off by more than {}, by up to {}",
                                 bound_text(tolerance), bound_text(each.off_bent));
        out.push_back(std::move(words));
    }
    return out;
}

} // namespace trivar
