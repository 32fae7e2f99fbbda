// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/splitting.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/mesh/transform.h"
#include "core/split/along_obstacles.h"
#include "core/stages/base_of_tiles.h"
#include "core/stages/cap_notices.h"
#include "core/stages/inside_material.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

SplitFrame frame_of(const Splitting& splitting)
{
    const glm::dvec3 u = glm::normalize(splitting.opening);
    const glm::dvec3 v = glm::normalize(splitting.way - u * glm::dot(u, splitting.way));
    return {glm::dvec3(0), glm::dmat3(u, v, glm::cross(u, v))};
}

// The mesh of a part in the world, with points.
const Mesh& mesh_in_world(const Part& part, SplitPartMemory& memory)
{
    const bool is_there = part.to_world == glm::dmat4(1);
    if (is_there && !part.mesh()->points.empty()) return *part.mesh();
    const bool mirrored = glm::determinant(glm::dmat3(part.to_world)) < 0;
    if (memory.of == part.mesh() && memory.mirrored == mirrored) {
        transform_again(memory.in_world, *part.mesh(), part.to_world);
        return memory.in_world;
    }
    memory.of = part.mesh();
    memory.mirrored = mirrored;
    memory.in_world = transformed(*part.mesh(), part.to_world);
    // Vertices at one place are one point if a file gives each face vertices of its own
    if (memory.in_world.points.empty())
        memory.in_world.points = points_by_position(part.mesh()->positions);
    return memory.in_world;
}

Part parted(const Part& part, SplitMesh made, bool filled, SplitPartMemory& memory)
{
    Part out;
    out.key = part.key;
    out.above_cuts = part.above_cuts;
    out.bounds = bounding_box(made.mesh);
    if (filled) { // patterns stay with the body while it moves
        Mesh before = made.mesh;
        before.positions = std::move(made.rest_positions);
        out.before_split = make_ref(transformed(before, glm::inverse(part.to_world)));
    }
    out.rest = memory.made.lend(std::move(made.mesh));
    return out;
}

Stage split_stage(const Stage& before, const Splitting& splitting, bool filled, bool of_tiles,
                  const Ref<SplitField>& field, std::vector<SplitPartMemory>& memory)
{
    Stage out = before;
    out.split_field = field;
    const InsideMaterial inside = inside_material(before, splitting.inside);
    SplitOptions options;
    options.tolerance = splitting.tolerance;
    options.closing = splitting.closing;
    options.material = inside.number;
    CapCounts counts;
    bool any = false;
    options.keep_rest = filled;
    memory.resize(out.parts.size());
    for (std::size_t i = 0; i < out.parts.size(); ++i) {
        Part& part = out.parts[i];
        const Mesh& world = mesh_in_world(part, memory[i]);
        if (of_tiles && splitting.inside == Filling::none)
            options.material = world.face_material.empty() ? 0 : world.face_material.front();
        if (std::optional<Mesh> back = memory[i].made.take_back())
            memory[i].split.mesh = *std::move(back);
        std::optional<SplitMesh> made = split(world, *field, options, memory[i].split);
        if (!made) continue;
        any = true;
        counts.open += made->open;
        counts.gaps += made->gaps;
        counts.fans += made->fans;
        out.split_off = std::max(out.split_off, made->off);
        part = parted(part, std::move(*made), filled, memory[i]);
    }
    if (!any) return out;
    out.split_apart = true;
    out.whole_parts = before.whole();
    out.mixed_materials = inside.beside;
    std::ranges::move(notices_of(counts), std::back_inserter(out.notices));
    if (out.split_off > splitting.tolerance)
        out.notices.push_back(fmt::format("its triangles are up to {} m from the true walls, "
                                          "more than its tolerance",
                                          number_text(out.split_off)));
    return out;
}

// Returns the splitting of an object; for a layer of tiles without one that of its base, or of the
// base of that, so that tiles part with the surface that they are painted on.
std::optional<Splitting> splitting_of(const StepInput& input)
{
    if (input.object.splitting || !input.object.tiles) return input.object.splitting;
    const Id base = base_that(input.document, input.object,
                              [](const Object& o) { return o.splitting.has_value(); });
    if (base == 0) return {};
    Splitting out = *object(input.document, base).splitting;
    out.inside = Filling::none;
    return out;
}

} // namespace

Ref<Stage> SplittingStep::operator()(const Ref<Stage>& before, const StepInput& input)
{
    const std::optional<Splitting> splitting = splitting_of(input);
    if (!splitting || before->parts.empty()) {
        memory_.clear();
        return before;
    }
    FieldKey key{{}, *splitting};
    std::vector<std::string> names;
    std::optional<glm::dvec3> origin;
    for (std::size_t i = 0; i < splitting->obstacles.size(); ++i) {
        const Id id = splitting->obstacles[i].object;
        names.push_back(object(input.document, id).name);
        const auto found = input.done.find(id);
        if (found == input.done.end()) continue;
        for (const Part& part : found->second->parts) {
            if (!origin) origin = glm::dvec3(part.to_world[3]);
            glm::dmat4 to_origin = part.to_world;
            to_origin[3] -= glm::dvec4(*origin, 0);
            key.bodies.push_back(
                {input.ray_meshes(mesh_of(part, input.timings), input.timings), to_origin, i});
        }
    }
    if (key.bodies.empty()) {
        Stage out = *before;
        out.notices.push_back("nothing of its obstacles is there, so it is parted by nothing");
        return make_ref(std::move(out));
    }
    const bool filled = is_filled(*before, splitting->inside, input.object.surfacing);
    try {
        return timed(input.timings, "split", [&] {
            const Ref<SplitField> field = fields_(key, [&] {
                std::vector<SplitObstacle> obstacles;
                for (std::size_t i = 0; i < splitting->obstacles.size(); ++i) {
                    const ObstacleUse& use = splitting->obstacles[i];
                    SplitObstacle each{names[i],  {},         use.clearance,
                                       use.reach, use.kernel, {use.object}};
                    each.ends = splitting->ends;
                    if (each.ends == SplitEnds::smooth) each.margin = smooth_margin;
                    for (const Body& body : key.bodies)
                        if (body.obstacle == i) each.bodies.push_back({body.mesh, body.to_origin});
                    if (!each.bodies.empty()) obstacles.push_back(std::move(each));
                }
                SplitFrame frame = frame_of(*splitting);
                if (splitting->closing == SplitClosing::stitched)
                    frame = along_obstacles(obstacles, frame);
                return make_ref(split_field(obstacles, frame));
            });
            return known_({before, field, *origin, *splitting, filled}, [&] {
                SplitField there = *field;
                there.frame.origin += *origin;
                return make_ref(split_stage(*before, *splitting, filled,
                                            input.object.tiles.has_value(),
                                            make_ref(std::move(there)), memory_));
            });
        });
    } catch (const Rejected& error) {
        Stage out = *before;
        out.notices.push_back(std::string("it is not parted: ") + error.what());
        return make_ref(std::move(out));
    }
}

} // namespace trivar
