// Gathers along a ray through a volume, up to the nearest surface or curve. FIELD_ORDER is that of the
// spline, 2 to 4; ROUGH is for drafts.
in vec2 uv;
layout(location = 0) out vec4 out_gathered; // linear light times the opacity, opacity
layout(location = 1) out float out_hit;     // distance up to which half is held back; 0: nowhere
layout(binding = 3) uniform usampler2D ids_depths;
layout(binding = 0) uniform sampler3D voxel_samples;
layout(binding = 1) uniform sampler3D spline_coefficients; // with a border of one
layout(binding = 2) uniform sampler3D open_bricks;         // OpenBricks
layout(binding = 6) uniform sampler2D transfer;            // TransferTable
layout(binding = 7) uniform usampler3D empty_bricks;       // EmptyBricks
uniform vec4 rays[9]; // these six: CastView
uniform vec4 lights[11];
uniform vec4 low;
uniform vec4 high;
uniform vec4 look;
uniform mat3 to_normals;
uniform vec4 last_place; // the greatest coordinates
uniform vec4 shares;     // x a + y: share of the range for a sample a of the texture; zw: coefficients

int order() { return FIELD_ORDER; }
#ifdef ROUGH
bool rough() { return true; }
#else
bool rough() { return false; }
#endif
vec3 last() { return last_place.xyz; }
float sample_at(vec3 p)
{
    return textureLod(voxel_samples, (p + 0.5) / (last_place.xyz + 1.0), 0.0).r * shares.x + shares.y;
}
float coefficient_at(vec3 p)
{
    return textureLod(spline_coefficients, (p + 1.5) / (last_place.xyz + 3.0), 0.0).r * shares.z + shares.w;
}
int empty_reach(ivec3 brick)
{
    return int(texelFetch(empty_bricks, min(brick, textureSize(empty_bricks, 0) - 1), 0).r);
}
vec4 transfer_before(float u) { return textureLod(transfer, vec2((u * 1024.0 + 0.5) / 1025.0, 0.5), 0.0); }
float open_at(vec3 brick) { return textureLod(open_bricks, brick / vec3(textureSize(open_bricks, 0)), 0.0).r; }
vec3 toward_eye = vec3(0.0, 0.0, 1.0); // scene, unit

#include "spline_taps.glsl"
vec3 lit(vec3 color, vec3 p, vec3 slope);
#include "casting.glsl"
#include "cast_pixel.glsl"

void main()
{
    ivec2 size = textureSize(ids_depths, 0);
    uvec2 solid = texelFetch(ids_depths, min(ivec2(uv * vec2(size)), size - 1), 0).rg;
    Gathered g = cast_pixel(uv, gl_FragCoord.xy, solid.r, uintBitsToFloat(solid.g));
    out_gathered = vec4(g.color, g.opacity);
    out_hit = g.hit;
}
