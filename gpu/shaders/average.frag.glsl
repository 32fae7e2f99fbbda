// Adds a sample to the average with its weight, or brings the average out with its noise; or goes
// from linear to encoded colours and back, where a picture is deep.
#include "frame.glsl"
#include "encode.glsl"
layout(location = 0) out vec4 out_color;
layout(binding = 0) uniform sampler2D sample_color;
uniform float weight;
uniform int change; // 0: none, 1: dithered to 8 bits, 2: encoded, 3: decoded

vec3 decoded(vec3 c)
{
    return mix(pow((c + 0.055) / 1.055, vec3(2.4)), c / 12.92, lessThanEqual(c, vec3(0.04045)));
}

void main()
{
    vec3 c = texelFetch(sample_color, ivec2(gl_FragCoord.xy), 0).rgb;
    if (change == 1) c = dithered(c, gl_FragCoord.xy, 3.0);
    if (change == 2) c = encoded(c);
    if (change == 3) c = decoded(c);
    out_color = vec4(c, weight);
}
