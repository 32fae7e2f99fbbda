// A line of constant width outside the mask, weaker where the instance is hidden.
#include "frame.glsl"
in vec2 uv;
layout(location = 0) out vec4 out_color;
layout(binding = 0) uniform sampler2D mask; // 0.5: hidden, 1: visible
uniform vec4 color;
uniform float width_px;
uniform int taps; // on the outer ring; a draft has fewer, and no inner ring

void main()
{
    if (texelFetch(mask, ivec2(gl_FragCoord.xy), 0).r > 0.25) discard;
    float m = 0.0;
    // Two rings of bilinear taps: a full search costs four times as much.
    for (int i = 0; i < taps; i++) {
        float a = 6.2832 / float(taps) * float(i) + 0.2;
        m = max(m, textureLod(mask, uv + vec2(cos(a), sin(a)) * width_px * frame.size_px.zw, 0.0).r);
    }
    for (int i = 0; i < 8 && taps > 8; i++) {
        float a = 0.7854 * float(i);
        m = max(m, textureLod(mask, uv + vec2(cos(a), sin(a)) * width_px * 0.55 * frame.size_px.zw, 0.0).r);
    }
    if (m < 0.02) discard;
    out_color = vec4(color.rgb, color.a * (m > 0.55 ? m : 0.8 * m));
}
