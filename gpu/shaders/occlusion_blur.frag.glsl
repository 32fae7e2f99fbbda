// A 4 x 4 box that respects depth: one full period of the noise.
#include "frame.glsl"
layout(location = 0) out vec4 out_open;
layout(binding = 1) uniform sampler2D noisy; // open share, view distance

void main()
{
    ivec2 p_px = ivec2(gl_FragCoord.xy), last = textureSize(noisy, 0) - 1;
    float depth = texelFetch(noisy, p_px, 0).g, sum = 0.0, weights = 0.0;
    for (int y = -2; y <= 1; y++)
        for (int x = -2; x <= 1; x++) {
            vec2 a = texelFetch(noisy, clamp(p_px + ivec2(x, y), ivec2(0), last), 0).rg;
            float w = exp2(-abs(a.g - depth) * 40.0 / frame.scene.x);
            sum += a.r * w;
            weights += w;
        }
    out_open = vec4(sum / max(weights, 1e-4), depth, 0.0, 0.0);
}
