// Adds a sample to the average with its weight, or brings the average out with its noise; or goes
// from linear to encoded colours and back, where a picture is deep.
#include "frame.glsl"
#include "encode.glsl"
layout(location = 0) out vec4 out_color;
layout(binding = 0) uniform sampler2D sample_color;
layout(binding = 2) uniform usampler2D surfaces;
uniform float weight;
uniform int change; // 0: none, 1: dithered to 8 bits, 2: encoded, 3: decoded

// Noise is for what lies between two bytes: a colour that is one stays as it is, and so does a
// flat colour, which was one before half floats averaged it.
vec3 dithered_between(vec3 c)
{
    uint kind = texelFetch(surfaces, ivec2(gl_FragCoord.xy), 0).w >> 24;
    float same = kind > 64u && kind < 192u ? 0.5 : 0.1; // of a step; pack.glsl
    vec3 steps = encoded(c) * 255.0;
    return mix(dithered(c, gl_FragCoord.xy, 3.0), c, lessThanEqual(abs(steps - round(steps)), vec3(same)));
}

void main()
{
    vec3 c = texelFetch(sample_color, ivec2(gl_FragCoord.xy), 0).rgb;
    if (change == 1) c = dithered_between(c);
    if (change == 2) c = encoded(c);
    if (change == 3) c = decoded(c);
    out_color = vec4(c, weight);
}
