// Light for every pixel that holds a surface.
#include "frame.glsl"
#include "studio.glsl"
#include "tonemap.glsl"
#include "shadow.glsl"
#include "material.glsl"
#include "pack.glsl"
#include "shade.glsl"
in vec2 uv;
layout(location = 0) out vec4 out_color;
layout(binding = 2) uniform usampler2D surfaces;
layout(binding = 3) uniform usampler2D ids_depths;
#ifdef OCCLUSION
layout(binding = 1) uniform sampler2D occlusion_map; // half size: open share, view distance

// Bilinear weights times likeness of depth, so that nothing leaks over silhouettes.
float open_share(float depth)
{
    vec2 p = gl_FragCoord.xy * 0.5 - 0.5, f = fract(p);
    ivec2 i = ivec2(floor(p)), last = textureSize(occlusion_map, 0) - 1;
    float sum = 0.0, weights = 0.0;
    for (int k = 0; k < 4; k++) {
        ivec2 o = ivec2(k & 1, k >> 1);
        vec2 a = texelFetch(occlusion_map, clamp(i + o, ivec2(0), last), 0).rg;
        float w = mix(1.0 - f.x, f.x, float(o.x)) * mix(1.0 - f.y, f.y, float(o.y));
        w = (w + 0.02) * exp2(-abs(a.g - depth) * 60.0 / frame.scene.x);
        sum += a.r * w;
        weights += w;
    }
    return weights > 1e-5 ? sum / weights
                          : texelFetch(occlusion_map, clamp(ivec2(p + 0.5), ivec2(0), last), 0).r;
}
#endif

void main()
{
    ivec2 p_px = ivec2(gl_FragCoord.xy);
    float depth = uintBitsToFloat(texelFetch(ids_depths, p_px, 0).g);
    Surface s = unpacked_surface(texelFetch(surfaces, p_px, 0));
    vec3 p = (frame.from_view * vec4(view_point(uv, depth), 1.0)).xyz;
    float open = 1.0;
#ifdef OCCLUSION
    open = open_share(depth);
#endif
    out_color = vec4(shaded(s, p, open, gl_FragCoord.xy), 1.0);
}
