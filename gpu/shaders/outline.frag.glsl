// A line of constant width outside the mask and a dark halo round it, so that it reads on any
// ground; weaker where the instance is hidden. DRAFT costs a third and is rougher.
#include "frame.glsl"
#include "encode.glsl"
in vec2 uv;
layout(location = 0) out vec4 out_color;
layout(binding = 0) uniform sampler2D mask; // r 0.5: hidden, 1: visible; g: covered by lines
uniform vec4 color, halo;
uniform float width_px, halo_px;
uniform int taps; // on each ring
uniform float closed_px; // radius of holes in the mask that have no outline; 0: all have one

// The most of the mask on a ring of bilinear taps, and the share of the ring that lies in it: a
// full search costs four times as much.
vec2 ring(float radius_px, int count)
{
    vec2 found = vec2(0.0);
    for (int i = 0; i < count; i++) {
        float a = 6.2832 / float(count) * float(i) + 0.2;
        float m = textureLod(mask, uv + vec2(cos(a), sin(a)) * radius_px * frame.size_px.zw, 0.0).r;
        found = vec2(max(found.x, m), found.y + m);
    }
    found.y /= float(count) * max(found.x, 0.5);
    found.x = found.x > 0.55 ? found.x : 0.8 * found.x;
    return found;
}

// Returns how much a place is open to the outside: little in a gap between things that are outlined
// as one.
float openness()
{
    if (closed_px <= 0.0) return 1.0;
    const int count = 24;
    float inside = 0.0;
    for (int i = 0; i < count; i++) {
        float a = 6.2832 / float(count) * float(i);
        vec2 there = uv + vec2(cos(a), sin(a)) * closed_px * frame.size_px.zw;
        inside += textureLod(mask, there, 0.0).r > 0.25 ? 1.0 : 0.0;
    }
    return 1.0 - smoothstep(0.78, 0.86, inside / float(count));
}

void main()
{
    vec2 here = texelFetch(mask, ivec2(gl_FragCoord.xy), 0).rg;
    if (here.r > 0.25) discard;
    vec2 outer = ring(width_px + halo_px, taps);
#ifdef DRAFT
    // Beside a straight edge at distance d the share of the ring in the mask is acos(d / radius) / pi.
    float share = acos(width_px / (width_px + halo_px)) / PI;
    float line = outer.x * smoothstep(share - 0.1, share + 0.06, outer.y);
#else
    float line = max(ring(width_px, taps).x, ring(width_px * 0.55, 8).x);
#endif
    float open = outer.x > 0.0 ? (1.0 - here.g) * openness() : 0.0; // lines lie over it
    line *= color.a * open;
    float dark = outer.x * halo.a * open * (1.0 - line);
    if (line + dark < 0.01) discard;
    out_color = vec4(mix(encoded(halo.rgb), encoded(color.rgb), line / (line + dark)), line + dark);
}
