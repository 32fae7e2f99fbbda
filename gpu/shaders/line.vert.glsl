// One instance a segment: a quad on the screen with room for round caps and soft edges. See
// gpu/passes/segments.h.
#include "frame.glsl"
layout(location = 0) in vec3 before;
layout(location = 1) in vec3 from;
layout(location = 2) in vec3 to;
layout(location = 3) in vec3 after;
layout(location = 4) in vec4 color_from;
layout(location = 5) in vec4 color_to;
layout(location = 6) in vec4 along;
layout(location = 7) in vec4 width_taper;
layout(location = 8) in uvec2 id_hidden;
layout(location = 9) in vec4 shares_dash_reach; // of the width, at both ends; Segment
uniform int parts;          // 0: seen, 1: of what something hides, 2: behind their own surface
flat out vec4 start_along;    // where it begins and its unit direction on the screen; pixels
flat out vec3 length_halves;  // of the segment; half widths at both ends; pixels
flat out vec2 distances;      // of both ends, as perspective has them
flat out vec4 joints;         // xy: p of a joint's bisector where dot(p, xy) = 0, at the beginning; zw: at the end
flat out vec4 at_color_from;
flat out vec4 at_color_to;
flat out vec4 at_along;
flat out vec2 taper;
flat out vec4 dash_opacity; // length in pixels, 0: none; 1: with flat ends; opacity; 1: as ink
flat out float own_reach;
flat out uint line_id;
invariant gl_Position;

// The distance of the near plane; in a parallel view all w are 1.
float nearest() { return frame.eye.w > 0.5 ? frame.clip[3].z / (frame.clip[2].z - 1.0) : 0.5; }
// The share of the way to b at which a line from a comes before the eye.
float cut(vec4 a, vec4 b)
{
    float near = nearest();
    return a.w < near ? clamp((near - a.w) / (b.w - a.w), 0.0, 1.0) : 0.0;
}
vec2 on_screen(vec4 c) { return c.xy / c.w * frame.size_px.xy * 0.5; }
float px_per_unit(vec4 c) { return frame.clip[1][1] * 0.5 * frame.size_px.y / c.w; }

// Where two segments meet, each pixel belongs to one: to that on its side of the bisector. `other`
// is the far end of the neighbour, `towards` the direction of this segment.
vec2 bisector(vec3 other, vec4 joint, vec2 joint_px, vec2 towards, float sense)
{
    vec4 c = frame.view_clip * vec4(other, 1.0);
    vec2 d = (joint_px - on_screen(mix(c, joint, cut(c, joint)))) * sense;
    float len = length(d);
    return len > 1e-4 ? d / len + towards : vec2(0.0);
}

void main()
{
    const float PULL = 4e-5; // a line on a surface wins against it
    const float DASHED_WIDTH = 0.66, DASHED = 0.55, FAINT = 0.25;
    const uint IS_DASHED = 0u, IS_FAINT = 1u, IS_LEFT_OUT = 2u, AS_INK = 16u; // segments.cpp
    vec4 first = frame.view_clip * vec4(from, 1.0), second = frame.view_clip * vec4(to, 1.0);
    uint kind = id_hidden.y & ~AS_INK;
    bool hidden = parts == 1, dashed = hidden && kind == IS_DASHED;
    own_reach = shares_dash_reach.w;
    if (max(first.w, second.w) < nearest() || (hidden && kind == IS_LEFT_OUT)
        || (parts == 2 && own_reach <= 0.0)) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
        return;
    }
    vec2 part = vec2(cut(first, second), 1.0 - cut(second, first));
    vec4 a = mix(first, second, part.x), b = mix(first, second, part.y);
    vec2 pa = on_screen(a), pb = on_screen(b), d = pb - pa;
    float len = length(d);
    vec2 t = len > 1e-4 ? d / len : vec2(1.0, 0.0), n = vec2(-t.y, t.x);

    vec2 width = width_taper.x + width_taper.y * vec2(px_per_unit(a), px_per_unit(b));
    width *= mix(shares_dash_reach.xx, shares_dash_reach.yy, part);
    width *= dashed ? DASHED_WIDTH : 1.0;
    float r = min(max(width.x, width.y) * 0.5, 4.0 * frame.size_px.y) + 1.0; // as wide as the picture will do
    float end = float(gl_VertexID & 1), side = float(gl_VertexID >> 1) * 2.0 - 1.0, out_end = end * 2.0 - 1.0;
    vec4 c = end < 0.5 ? a : b;
    vec2 at = (end < 0.5 ? pa : pb) + (n * side + t * out_end) * r;
    vec4 pulled = c;
#ifndef HELPERS // which overlap at their corners and lie at their points' depth
    // A surface on which it lies may turn towards the eye by half a right angle beside it.
    pulled += min((end < 0.5 ? width.x : width.y) * 0.5 / px_per_unit(c), 0.1 * c.w) * frame.clip[2];
#endif
    gl_Position = vec4(at * 2.0 * frame.size_px.zw * c.w, max(pulled.z / pulled.w - PULL, -1.0) * c.w, c.w);

    start_along = vec4(pa + frame.size_px.xy * 0.5, t);
    length_halves = vec3(len, width * 0.5);
    distances = vec2(a.w, b.w);
    joints = vec4(0.0);
#ifndef HELPERS
    vec2 m0 = from == before ? vec2(0.0) : bisector(before, first, on_screen(first), t, 1.0);
    vec2 m1 = to == after ? vec2(0.0) : bisector(after, second, on_screen(second), t, -1.0);
    if (part.x > 0.0) m0 = vec2(0.0);
    if (part.y < 1.0) m1 = vec2(0.0);
    joints = vec4(dot(m0, t), dot(m0, n), dot(m1, t), dot(m1, n));
#endif
    at_color_from = mix(color_from, color_to, part.x);
    at_color_to = mix(color_from, color_to, part.y);
    at_along = vec4(mix(along.xx, along.yy, part), mix(along.zz, along.ww, part));
    taper = width_taper.zw;
    bool faint = hidden && kind == IS_FAINT;
    float ink = float(id_hidden.y / AS_INK);
    dash_opacity = dashed ? vec4(3.5, 0.0, DASHED, ink) : vec4(shares_dash_reach.z, 1.0, faint ? FAINT : 1.0, ink);
    line_id = id_hidden.x;
}
