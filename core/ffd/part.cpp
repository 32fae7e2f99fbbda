// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ffd/part.h"

namespace trivar {

const Part& innermost(const Part& part)
{
    const Part* out = &part;
    while (out->bent && out->bent->inner) out = out->bent->inner.get();
    return *out;
}

glm::dvec3 place_in_world(const Part& part, const glm::dvec3& p_object)
{
    if (!part.bent) return glm::dvec3(part.to_world * glm::dvec4(p_object, 1));
    const glm::dvec3 p = part.bent->inner ? place_in_world(*part.bent->inner, p_object) : p_object;
    return deform(p, part.bent->embedding, *part.bent->volume).position_world;
}

bool is_deformed(const Part& part)
{
    return part.bent ? part.bent->mesh.ready() : !part.posed || part.posed->mesh.ready();
}

const Ref<Mesh>& mesh_of(const Part& part, Timings& timings)
{
    if (part.posed && !part.posed->mesh.ready()) {
        timings.add("pose", 0, part.rest->vertex_count());
        timed(timings, "pose", [&]() -> const Ref<Mesh>& { return *part.posed->mesh; });
    }
    if (!part.bent || part.bent->mesh.ready()) return part.mesh();
    timings.add("deform", 0, part.rest->vertex_count());
    return timed(timings, "deform", [&]() -> const Ref<Mesh>& { return part.mesh(); });
}

} // namespace trivar
