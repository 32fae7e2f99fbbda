// One instance a segment: a quad on the screen with room for round caps and soft edges.
#include "frame.glsl"
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec4 color;
layout(location = 3) in vec3 arc_width; // arc length at both ends and width, pixels
uniform float width_factor;
noperspective out vec2 at_px; // along and across the segment
flat out vec2 length_width;   // pixels
flat out vec4 at_color;
noperspective out float at_arc;

void main()
{
    const float NEAREST = 1e-4, PULL = 4e-5; // a line on a surface wins against it
    vec4 a = frame.view_clip * vec4(from, 1.0), b = frame.view_clip * vec4(to, 1.0);
    if (a.w < NEAREST) a = mix(a, b, clamp((NEAREST - a.w) / (b.w - a.w), 0.0, 1.0));
    if (b.w < NEAREST) b = mix(b, a, clamp((NEAREST - b.w) / (a.w - b.w), 0.0, 1.0));
    vec2 pa = a.xy / a.w * frame.size_px.xy * 0.5, pb = b.xy / b.w * frame.size_px.xy * 0.5, d = pb - pa;
    float len = length(d), width = arc_width.z * width_factor, r = width * 0.5 + 1.0;
    vec2 t = len > 1e-4 ? d / len : vec2(1.0, 0.0), n = vec2(-t.y, t.x);
    float end = float(gl_VertexID & 1), side = float(gl_VertexID >> 1) * 2.0 - 1.0, out_end = end * 2.0 - 1.0;
    vec4 c = end < 0.5 ? a : b;
    c.xy += (n * side + t * out_end) * r * 2.0 * frame.size_px.zw * c.w;
    c.z -= PULL * c.w;
    gl_Position = c;
    at_px = vec2(end * len + out_end * r, side * r);
    length_width = vec2(len, width);
    at_color = color;
    at_arc = mix(arc_width.x, arc_width.y, end);
}
