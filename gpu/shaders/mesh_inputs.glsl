// The inputs of fragment programs from mesh.vert.
#include "distance.glsl"
in vec3 at_scene;
in vec3 at_normal;
in vec4 at_color;
#ifdef TEXTURES
in vec4 at_tangent;
in vec4 at_uv; // both sets
#endif
#ifdef COPIES
flat in uint copy_id; // 0: as the instance
#endif
uniform uint id;      // of the instance; 0: not pickable

uint id_here()
{
#ifdef COPIES
    if (copy_id != 0u) return copy_id;
#endif
    return id;
}
