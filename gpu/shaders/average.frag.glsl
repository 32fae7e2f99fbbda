// Adds a sample to the average with its weight, or brings the average out with its noise.
#include "frame.glsl"
layout(location = 0) out vec4 out_color;
layout(binding = 0) uniform sampler2D sample_color;
uniform float weight;
uniform int last; // 1: dithered to 8 bits

void main()
{
    vec3 c = texelFetch(sample_color, ivec2(gl_FragCoord.xy), 0).rgb;
    out_color = vec4(last == 1 ? dithered(c, gl_FragCoord.xy, 3.0) : c, weight);
}
