// Coverage from the distance to the segment: round caps, soft edges, dashes where asked for.
// HELPERS are mixed as encoded colours; IDS and MASK are what is covered by half at least, with WHOLE
// ink by nearly all; COVER is how much is. BEFORE_OWN is only where the surface of the same object
// lies before the line.
#include "frame.glsl"
#include "encode.glsl"
#include "distance.glsl"
flat in vec4 start_along;
flat in vec3 length_halves;
flat in vec2 distances;
flat in vec4 joints;
flat in vec4 at_color_from;
flat in vec4 at_color_to;
flat in vec4 at_along;
flat in vec2 taper;
flat in vec4 dash_opacity;
flat in uint line_id;
#ifdef BEFORE_OWN
flat in float own_reach;
layout(binding = 3) uniform usampler2D ids_depths;
const uint CURVE = 1u << 31; // gpu/curve.h

bool is_before_own()
{
    uvec2 there = texelFetch(ids_depths, ivec2(gl_FragCoord.xy), 0).rg;
    return (there.x | CURVE) == line_id && there.x != line_id
        && distance_here() - uintBitsToFloat(there.y) <= own_reach;
}
#endif
#if defined(IDS)
layout(location = 0) out uvec2 out_id_depth;
#elif defined(MASK)
layout(location = 0) out float out_mask;
uniform float value;
#elif defined(COVER)
layout(location = 0) out vec2 out_cover;
#else
layout(location = 0) out vec4 out_color;
#endif

// Colours are mixed in linear light, where dark lines on white look thinner than they are and white
// ones on black wider. Returns the opacity that looks like `a` mixed as encoded colours, as files
// have it: exactly for black on white and white on black, in between for others.
float seen_opacity(float a, vec3 linear)
{
    const float GAMMA = 2.2;
    float light = encoded(vec3(dot(linear, vec3(0.2126, 0.7152, 0.0722)))).x;
    return mix(1.0 - pow(1.0 - a, GAMMA), pow(a, GAMMA), light);
}

// The share of the full width at a place along the whole line.
float grown(float share)
{
    float begun = taper.x > 0.0 ? share / taper.x : 1.0, left = taper.y > 0.0 ? (1.0 - share) / taper.y : 1.0;
    return saturate(min(begun, left));
}

void main()
{
    const float THINNEST = 0.25; // half a width in pixels; what is thinner is fainter
    const float BOTH = 0.01;     // beside a bisector, in pixels, so that rounding leaves no gap
#ifdef BEFORE_OWN
    if (!is_before_own()) discard;
#endif
    float len = length_halves.x;
    // Not interpolated, for some clippers do that badly between ends of very different distances.
    vec2 p = gl_FragCoord.xy - start_along.xy, at_px = mat2(start_along.z, -start_along.w, start_along.wz) * p;
    vec2 from_end = at_px - vec2(len, 0.0);
    if (dot(at_px, joints.xy) < -BOTH * length(joints.xy)) discard;
    if (joints.zw != vec2(0.0) && dot(from_end, joints.zw) >= 0.0) discard;

    float on_screen = len > 1e-4 ? saturate(at_px.x / len) : 0.0;
    // The share of the segment in space that this share on the screen is.
    float t = on_screen * distances.x / mix(distances.y, distances.x, on_screen);
    float half_width = mix(length_halves.y, length_halves.z, on_screen) * grown(mix(at_along.z, at_along.w, t));
    float fainter = saturate(half_width / THINNEST);
    half_width = max(half_width, THINNEST);
    float past = max(max(-at_px.x, from_end.x), 0.0);
    float a = saturate(half_width + 0.5 - length(vec2(past, at_px.y))) * fainter;
    if (dash_opacity.x > 0.0) {
        float arc = at_along.x + (at_along.y - at_along.x) * (len > 1e-4 ? at_px.x / len : 0.0);
        float dash = dash_opacity.x, u = mod(arc, 2.0 * dash), e = abs(u - dash * 0.5) - dash * 0.5;
        float rounded = 1.0 - (length(vec2(max(e, 0.0), at_px.y)) - half_width);
        a *= saturate(dash_opacity.y > 0.5 ? 0.5 - min(e, 2.0 * dash - u) : rounded);
    }
#ifdef WHOLE
    if (a < (dash_opacity.w > 0.5 ? 0.95 : 0.5)) discard; // ink has mostly one colour
#elif defined(IDS) || defined(MASK)
    if (a < 0.5) discard;
#endif
#if defined(IDS)
    out_id_depth = uvec2(line_id, floatBitsToUint(distance_here()));
#elif defined(MASK)
    out_mask = value;
#elif defined(COVER)
    out_cover = vec2(0.0, a);
#else
    vec4 color = mix(at_color_from, at_color_to, t);
    if (a <= 0.003) discard;
    float opacity = color.a * a * dash_opacity.z;
#ifdef HELPERS
    out_color = vec4(encoded(color.rgb), opacity);
#else
    out_color = vec4(color.rgb, dash_opacity.w > 0.5 ? seen_opacity(opacity, color.rgb) : opacity);
#endif
#endif
}
