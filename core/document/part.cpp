// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/part.h"

namespace trivar {

const Ref<Mesh>& mesh_of(const Part& part, Timings& timings)
{
    if (!part.bent || part.bent->mesh.ready()) return part.mesh();
    timings.add("deform", 0, part.bent->rest->vertex_count());
    return timed(timings, "deform", [&]() -> const Ref<Mesh>& { return part.mesh(); });
}

} // namespace trivar
