// A 4 x 4 box, one full period of the noise, that follows the slope of the surface and stops at
// its edge. Shadows are blurred no wider than their penumbra.
#include "frame.glsl"
layout(location = 0) out vec4 out_open;
layout(binding = 1) uniform sampler2D noisy; // as occlusion.frag leaves it

// Change of distance from a pixel to the next: the smaller one of both sides, which is not an edge.
float slope(float before, float here, float after)
{
    return abs(here - before) < abs(after - here) ? here - before : after - here;
}

void main()
{
    ivec2 p_px = ivec2(gl_FragCoord.xy), last = textureSize(noisy, 0) - 1;
    vec4 here = texelFetch(noisy, p_px, 0);
    ivec2 before = max(p_px - 1, ivec2(0)), after = min(p_px + 1, last);
    vec2 grad = vec2(slope(texelFetch(noisy, ivec2(before.x, p_px.y), 0).g, here.g,
                           texelFetch(noisy, ivec2(after.x, p_px.y), 0).g),
                     slope(texelFetch(noisy, ivec2(p_px.x, before.y), 0).g, here.g,
                           texelFetch(noisy, ivec2(p_px.x, after.y), 0).g));
    grad = clamp(grad, -0.2 * frame.scene.x, 0.2 * frame.scene.x);
    vec2 sum = vec2(0.0), weights = vec2(0.0);
    ivec2 first = (ivec2(frame.scene.w) >> ivec2(0, 1) & 1) - 2; // balanced over the samples
    for (int y = 0; y < 4; y++)
        for (int x = 0; x < 4; x++) {
            ivec2 o = first + ivec2(x, y);
            vec4 a = texelFetch(noisy, clamp(p_px + o, ivec2(0), last), 0);
            float wide = max(a.a, here.a), along = here.g + dot(grad, vec2(o));
#ifdef KEY_ALONE // all of the ambient light reaches everything
            vec2 both = vec2(exp2(-abs(a.g - along) * 40.0 / frame.scene.x
                                  - float(o.x * o.x + o.y * o.y) / max(wide * wide, 0.05)));
#else
            float w = exp2(-abs(a.g - along) * 40.0 / frame.scene.x);
            vec2 both = w * vec2(1.0, exp2(-float(o.x * o.x + o.y * o.y) / max(wide * wide, 0.05)));
#endif
            sum += a.rb * both;
            weights += both;
        }
    sum /= max(weights, 1e-4);
    out_open = vec4(sum.x, here.g, sum.y, 0.0); // KEY_ALONE: x is a mean of ones
}
