// The ids of what one can see through, for picking. MASKED variants leave out what is cut away.
#include "frame.glsl"
#include "mesh_inputs.glsl"
#ifdef MASKED
#define READS_MATERIAL
#include "surface.glsl"
#endif
layout(location = 0) out uvec2 out_id_depth;
uniform uint id;

void main()
{
#ifdef MASKED
    surface_here();
#endif
    out_id_depth = uvec2(id, floatBitsToUint(distance_here()));
}
