// Writes the ids of see-through items, for picking. MASKED variants leave out parts that are cut
// away.
#include "frame.glsl"
#include "mesh_inputs.glsl"
#ifdef MASKED
#define READS_MATERIAL
#include "surface.glsl"
#endif
layout(location = 0) out uvec2 out_id_depth;

void main()
{
#ifdef MASKED
    surface_here();
#endif
    if (id_here() == 0u) discard; // what cannot be picked stands in nobody's way
    out_id_depth = uvec2(id_here(), floatBitsToUint(distance_here()));
}
