// Blends see-through surfaces in any order. A first pass adds up the optical depth, -log(1 - coverage),
// at eight nodes between the nearest and the farthest of them; a second one weighs every layer by the
// light that reaches the eye past the others. All are sums, so no order changes them. LAYERS_AT_ONCE, of
// drafts, weighs by distance alone, without the first pass: as good where one layer covers the next,
// and together they hide as much of what is behind.
#if defined(LAYERS_AT_ONCE)
layout(location = 0) out vec4 out_weighed;
layout(location = 1) out float out_depth;
#elif defined(LAYER_DEPTHS)
layout(location = 0) out vec4 out_near_depths;
layout(location = 1) out vec4 out_far_depths;
#else
layout(location = 0) out vec4 out_weighed;
layout(binding = 6) uniform sampler2D near_depths;
layout(binding = 7) uniform sampler2D far_depths;
#endif
layout(binding = 2) uniform sampler2D scene_depth;
uniform vec2 range;         // nearest and farthest distance along the view direction
uniform float hidden_share; // of the coverage where a solid surface is nearer

// The share of a layer at place z, 0..7, that each node takes.
vec4 near_shares(float z) { return max(1.0 - abs(z - vec4(0.0, 1.0, 2.0, 3.0)), 0.0); }
vec4 far_shares(float z) { return max(1.0 - abs(z - vec4(4.0, 5.0, 6.0, 7.0)), 0.0); }
// The share of what lies at each node that is in front of z.
vec4 near_in_front(float z) { return clamp(0.5 + 0.5 * (z - vec4(0.0, 1.0, 2.0, 3.0)), 0.0, 1.0); }
vec4 far_in_front(float z) { return clamp(0.5 + 0.5 * (z - vec4(4.0, 5.0, 6.0, 7.0)), 0.0, 1.0); }

// The coverage that is left of a layer here once solid surfaces are minded.
float past_solids(float coverage)
{
    float solid = texelFetch(scene_depth, ivec2(gl_FragCoord.xy), 0).r;
    return min(coverage, 0.98) * (gl_FragCoord.z > solid ? hidden_share : 1.0);
}

void add_layer(vec3 color, float coverage, float distance)
{
    float z = 7.0 * saturate((distance - range.x) / max(range.y - range.x, 1e-6 * range.y));
    float depth = -log(1.0 - coverage);
    vec4 near = near_shares(z), far = far_shares(z);
#if defined(LAYERS_AT_ONCE)
    float weight = coverage * exp(-0.5 * z);
    out_weighed = vec4(color * weight, weight);
    out_depth = depth;
#elif defined(LAYER_DEPTHS)
    out_near_depths = depth * near;
    out_far_depths = depth * far;
#else
    ivec2 p = ivec2(gl_FragCoord.xy);
    vec4 others_near = texelFetch(near_depths, p, 0) - depth * near;
    vec4 others_far = texelFetch(far_depths, p, 0) - depth * far;
    float in_front = dot(others_near, near_in_front(z)) + dot(others_far, far_in_front(z));
    float weight = coverage * exp(-max(in_front, 0.0));
    out_weighed = vec4(color * weight, weight);
#endif
}
