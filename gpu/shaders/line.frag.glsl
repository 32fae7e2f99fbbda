// Coverage from the distance to the segment: round caps, soft edges, dashes where asked for.
#include "frame.glsl"
#include "encode.glsl"
noperspective in vec2 at_px;
flat in vec2 length_width;
flat in vec4 at_color;
noperspective in float at_arc;
layout(location = 0) out vec4 out_color;
uniform vec2 dash_px; // period and stroke; 0: none
uniform float opacity;

void main()
{
    float past = max(max(-at_px.x, at_px.x - length_width.x), 0.0), half_width = length_width.y * 0.5;
    float a = saturate(half_width + 0.5 - length(vec2(past, at_px.y)));
    if (dash_px.x > 0.0) {
        float u = mod(at_arc, dash_px.x), e = max(abs(u - dash_px.y * 0.5) - dash_px.y * 0.5, 0.0);
        a *= saturate(1.0 - (length(vec2(e, at_px.y)) - half_width));
    }
    if (a <= 0.003) discard;
    out_color = vec4(encoded(at_color.rgb), at_color.a * a * opacity);
}
