// Light for every pixel that holds a surface.
#include "frame.glsl"
#include "studio.glsl"
#include "tonemap.glsl"
#include "encode.glsl"
#include "material.glsl"
#include "pack.glsl"
#include "shade.glsl"
in vec2 uv;
layout(location = 0) out vec4 out_color;
layout(binding = 2) uniform usampler2D surfaces;
layout(binding = 3) uniform usampler2D ids_depths;
#include "open.glsl"

void main()
{
    ivec2 p_px = ivec2(gl_FragCoord.xy);
    float depth = uintBitsToFloat(texelFetch(ids_depths, p_px, 0).g);
    Surface s = unpacked_surface(texelFetch(surfaces, p_px, 0));
    vec3 p = (frame.from_view * vec4(view_point(uv, depth), 1.0)).xyz;
    vec2 share = open_share(depth);
    out_color = vec4(shaded(s, p, share.x, share.y), 1.0);
}
