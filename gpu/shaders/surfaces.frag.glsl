// The surface of every pixel, its id and its distance. Light comes later, once a pixel: triangles
// of a pixel or two would otherwise pay for it several times over.
#define READS_MATERIAL
#include "frame.glsl"
#include "mesh_inputs.glsl"
#include "surface.glsl"
#include "pack.glsl"
layout(location = 0) out uvec4 out_surface;
layout(location = 1) out uvec2 out_id_depth;
uniform uint id;

void main()
{
    Surface s = surface_here();
#ifdef CLAY
    s.base = vec3(0.56, 0.385, 0.30);
    s.roughness = 0.58;
    s.metallic = 0.0;
    s.emissive = vec3(0.0);
#endif
    out_surface = packed_surface(s);
    out_id_depth = uvec2(id, floatBitsToUint(-(frame.view * vec4(at_scene, 1.0)).z));
}
