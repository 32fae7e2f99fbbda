// Every pass that draws meshes.
#include "frame.glsl"
#include "place.glsl"
#ifdef PLAIN
#define READS_MATERIAL
#include "material.glsl"
#include "pack.glsl"
flat out uvec3 at_material;
#endif
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 tangent; // w 0: none given
layout(location = 3) in vec4 color;   // linear
layout(location = 4) in vec2 uv_first;
layout(location = 5) in vec2 uv_second;
#ifdef SOLID
layout(location = 6) in vec3 rest;
uniform vec4 rest_middle; // and 1 / radius
out vec3 at_rest;
#endif
#ifdef VALUES
layout(location = 7) in float value;
out float at_value;
#endif
#ifdef ORDER_U // deforms as it draws
#define NORMALS 1
#ifdef TEXTURES
#define TANGENTS
#endif
#include "deform_vertex.glsl"
#endif
uniform mat4 scene_to_clip;
out vec3 at_scene;
out vec3 at_normal;
out vec4 at_color;
#ifdef COPIES
flat out uint copy_id;
#endif
#ifdef TEXTURES
out vec4 at_tangent;
out vec4 at_uv;
#endif

void main()
{
    vec3 p = position, n = normal, t = tangent.xyz;
    vec4 tint = vec4(1.0, 1.0, 1.0, 0.0);
#ifdef ORDER_U
    DeformedVertex v = deformed_vertex(position, normal, tangent);
    p = v.position;
    n = v.normal;
    t = v.tangent.xyz;
#endif
#ifdef TILES
    TileVertex bent = tile_vertex(position, normal, tangent.xyz);
    p = bent.position;
    n = bent.normal;
    t = bent.tangent;
    tint = tile_tint();
#endif
    mat4 to_there = scene_from_mesh();
    at_scene = (to_there * vec4(p, 1.0)).xyz;
    at_normal = scene_from_normals() * n;
    at_color = vec4(mix(color.rgb, vec3(1.0), tint.a) * tint.rgb, color.a);
#ifdef SOLID
#ifdef TILES
    at_rest = (p - rest_middle.xyz) * rest_middle.w; // of them all as they lie
#else
    at_rest = (rest - rest_middle.xyz) * rest_middle.w;
#endif
#endif
#ifdef VALUES
    at_value = value;
#endif
#ifdef TEXTURES
    // A mirroring matrix turns the bitangent's sense round.
    at_tangent = vec4(mat3(to_there) * t, tangent.w * sign(determinant(mat3(to_there))));
    at_uv = vec4(uv_first, uv_second);
#endif
#ifdef COPIES
    copy_id = id_of_copy;
#endif
#ifdef PLAIN
    Surface s = plain_surface(n, vec4(tint.rgb, 1.0));
#ifdef CLAY
    s = as_clay(s);
#endif
    at_material = packed_material(s);
#endif
    gl_Position = scene_to_clip * vec4(at_scene, 1.0);
}
