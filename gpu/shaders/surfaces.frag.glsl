// The surface of every pixel, its id and its distance. Light comes later, once a pixel: triangles
// of a pixel or two would otherwise pay for it several times over. PLAIN variants have their
// material packed by mesh.vert already, for the same reason.
#define READS_MATERIAL
#include "frame.glsl"
#include "mesh_inputs.glsl"
#include "material.glsl"
#ifdef PLAIN
flat in uvec3 at_material;
#else
#include "surface.glsl"
#endif
#include "pack.glsl"
layout(location = 0) out uvec4 out_surface;
layout(location = 1) out uvec2 out_id_depth;

void main()
{
#ifdef PLAIN
    bool away = !gl_FrontFacing;
    vec3 n = normalize(at_normal);
    uvec3 words = at_material;
    if (shows_back(away)) words.z |= BACK;
    out_surface = uvec4(packed_normal(away ? -n : n), words);
#else
    Surface s = surface_here();
#if defined(CLAY) && !defined(VALUES)
    s = as_clay(s);
#endif
    out_surface = uvec4(packed_normal(s.normal), packed_material(s));
#endif
    out_id_depth = uvec2(id_here(), floatBitsToUint(distance_here()));
}
