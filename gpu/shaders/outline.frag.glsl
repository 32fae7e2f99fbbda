// A line of constant width outside the mask and a dark halo round it, so that it reads on any
// ground; weaker where the instance is hidden.
#include "frame.glsl"
#include "encode.glsl"
in vec2 uv;
layout(location = 0) out vec4 out_color;
layout(binding = 0) uniform sampler2D mask; // 0.5: hidden, 1: visible
uniform vec4 color, halo;
uniform float width_px, halo_px;
uniform int taps; // on the rings of line and halo; a draft has fewer, and no ring within the line

// The most of the mask on a ring of bilinear taps: a full search costs four times as much.
float ring(float radius_px, int count)
{
    float m = 0.0;
    for (int i = 0; i < count; i++) {
        float a = 6.2832 / float(count) * float(i) + 0.2;
        m = max(m, textureLod(mask, uv + vec2(cos(a), sin(a)) * radius_px * frame.size_px.zw, 0.0).r);
    }
    return m > 0.55 ? m : 0.8 * m;
}

void main()
{
    if (texelFetch(mask, ivec2(gl_FragCoord.xy), 0).r > 0.25) discard;
    float line = ring(width_px, taps);
    if (taps > 8) line = max(line, ring(width_px * 0.55, 8));
    float dark = ring(width_px + halo_px, taps);
    line *= color.a;
    dark *= halo.a * (1.0 - line);
    if (line + dark < 0.01) discard;
    out_color = vec4(mix(encoded(halo.rgb), encoded(color.rgb), line / (line + dark)), line + dark);
}
