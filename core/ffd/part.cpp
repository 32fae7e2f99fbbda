// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ffd/part.h"

namespace trivar {

const Part& innermost(const Part& part)
{
    const Part* out = &part;
    while (out->bent && out->bent->inner) out = out->bent->inner.get();
    return *out;
}

Part with_innermost(const Part& part, const Ref<Mesh>& mesh)
{
    if (!part.bent) return {.rest = mesh, .to_world = part.to_world, .key = part.key};
    const Ref<Deformation> bent = part.bent;
    Ref<Part> inner;
    if (bent->inner) inner = make_ref(with_innermost(*bent->inner, mesh));
    const Ref<Mesh> before = inner ? inner->mesh() : mesh;
    Embedding near = bent->embedding;
    if (part.to_world != glm::dmat4(1)) near.to_rest = glm::inverse(part.to_world) * near.to_rest;
    const Lazy<Ref<Mesh>> out([=] { return make_ref(deform(*before, near, *bent->volume)); });
    return {.rest = before,
            .to_world = part.to_world,
            .bent = make_ref(Deformation{bent->embedding, bent->volume, out, inner}),
            .key = part.key,
            .bounds = part.bounds};
}

DeformedPoint point_in_world(const Part& part, const glm::dvec3& p_object)
{
    if (!part.bent)
        return {glm::dvec3(part.to_world * glm::dvec4(p_object, 1)), glm::dmat3(part.to_world)};
    const DeformedPoint before = part.bent->inner ? point_in_world(*part.bent->inner, p_object)
                                                  : DeformedPoint{p_object, glm::dmat3(1)};
    DeformedPoint out = deform(before.position_world, part.bent->embedding, *part.bent->volume);
    out.jacobian = out.jacobian * before.jacobian;
    return out;
}

glm::dvec3 place_in_world(const Part& part, const glm::dvec3& p_object)
{
    return point_in_world(part, p_object).position_world;
}

Part part_of(const Ref<TileSet>& tiles, const PartKey& key)
{
    return {.rest = LaterMesh(tiles->mesh), .key = key, .bounds = tiles->box, .tiles = tiles};
}

Box bounds_in_world(const Part& part)
{
    if (!part.drawn_from_tiles()) return bounding_box(*part.mesh(), part.to_world);
    if (part.to_world == glm::dmat4(1) || part.bounds.empty()) return part.bounds;
    Box out;
    for (const glm::dvec3& corner : part.bounds.corners())
        out.add(glm::dvec3(part.to_world * glm::dvec4(corner, 1)));
    return out;
}

bool is_deformed(const Part& part)
{
    if (part.bent) return part.bent->mesh.ready();
    return part.posed ? part.posed->mesh.ready() : part.rest.ready();
}

const Ref<Mesh>& mesh_of(const Part& part, Timings& timings)
{
    if (part.posed && !part.posed->mesh.ready()) {
        timings.add("pose", 0, part.vertex_count());
        timed(timings, "pose", [&]() -> const Ref<Mesh>& { return *part.posed->mesh; });
    }
    if (is_deformed(part)) return part.mesh();
    timings.add("deform", 0, part.vertex_count());
    return timed(timings, "deform", [&]() -> const Ref<Mesh>& { return part.mesh(); });
}

} // namespace trivar
