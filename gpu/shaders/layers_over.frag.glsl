// Lays the sums of the see-through layers over the picture.
layout(location = 0) out vec4 out_color;
layout(binding = 0) uniform sampler2D weighed;
layout(binding = 6) uniform sampler2D near_depths; // LAYERS_AT_ONCE: of all
layout(binding = 7) uniform sampler2D far_depths;

void main()
{
    ivec2 p = ivec2(gl_FragCoord.xy);
#ifdef LAYERS_AT_ONCE
    float depth = texelFetch(near_depths, p, 0).r;
#else
    float depth = dot(texelFetch(near_depths, p, 0) + texelFetch(far_depths, p, 0), vec4(1.0));
#endif
    if (depth < 1e-4) discard;
    vec4 sum = texelFetch(weighed, p, 0);
    out_color = vec4(clamp(sum.rgb / max(sum.a, 1e-6), 0.0, 1.0), 1.0 - exp(-depth));
}
