// Soft shadows of the key light by percentage closer filtering with a searched width (Fernando
// 2005), on sunflower disks turned by noise. SHADOW_BLOCKERS 0 gives a fixed width.
layout(binding = 4) uniform sampler2DShadow shadow_compare; // compared and bilinear
layout(binding = 5) uniform sampler2D shadow_depth;         // the same texture, plain

// x: the share of the key that reaches p; y: the radius of the penumbra there in the map's uv, 0
// where none is. The disk of taps is turned by phi and moved outwards by out_by.
vec2 key_reaching(vec3 p, vec3 n, float phi, float out_by)
{
    if (frame.key_light.w < 0.5) return vec2(1.0, 0.0);
    float texel = frame.shadow_map.x, width = frame.shadow_map.y, range = frame.shadow_map.z;
    float facing = saturate(dot(n, frame.key_dir.xyz));
    // Leave the surface a little: one texel, and more where the light grazes, or the terminator speckles.
    vec3 lifted = p + n * (width * texel * (1.5 - facing) + 0.008 * frame.scene.x * (1.0 - facing));
    vec3 q = (frame.key_clip * vec4(lifted, 1.0)).xyz * 0.5 + 0.5;
    bool outside = any(lessThanEqual(q.xy, vec2(0.0))) || any(greaterThanEqual(q, vec3(1.0)));
    const float FARTHEST = 0.999999; // where nothing is the map holds 1, which must not block
    // The receiver's own plane: depth change per uv, so that wide kernels do not shadow themselves.
    vec3 in_light = (frame.key_clip * vec4(n, 0.0)).xyz * vec3(width, width, -range) * 0.5;
    vec2 slope = in_light.xy / max(in_light.z, 0.25) * (width / range);
    slope = clamp(slope, -6.0 * width / range, 6.0 * width / range);
    float bias = 0.6 * texel * width / range;
#if SHADOW_BLOCKERS > 0
    vec2 towards_blocker = vec2(cos(phi), sin(phi));
    float reach = min(frame.shadow_map.w * q.z * range / width, 0.12), sum = 0.0, count = 0.0;
    // Software GL runs both sides of a branch but leaves a loop when no lane is alive.
    int blockers = outside ? 0 : SHADOW_BLOCKERS;
    for (int i = 0; i < blockers; i++) {
        vec2 o = sunflower(i, SHADOW_BLOCKERS, out_by, towards_blocker);
        o *= dot(o, o) * reach; // denser about p: most of what blocks is not far above it
        float z = textureLod(shadow_depth, q.xy + o, 0.0).r;
        float hit = step(z, min(q.z + dot(slope, o) - bias - 0.0015, FARTHEST));
        sum += z * hit;
        count += hit;
    }
    float wide = frame.shadow_map.w * (q.z - sum / max(count, 1.0)) * range / width;
    float radius = clamp(wide, 1.2 * texel, max(reach, 1.2 * texel));
    int taps = count < 0.5 ? 0 : SHADOW_TAPS;
#else
    float radius = SHADOW_RADIUS * texel;
    int taps = outside ? 0 : SHADOW_TAPS;
#endif
    float seen = 0.0;
    vec2 towards_tap = vec2(cos(phi + 1.7), sin(phi + 1.7));
    for (int i = 0; i < taps; i++) {
        vec2 o = sunflower(i, SHADOW_TAPS, out_by, towards_tap) * radius;
        float z = min(q.z + dot(slope, o) - bias, FARTHEST);
        seen += texture(shadow_compare, vec3(q.xy + o, z));
    }
    return taps == 0 ? vec2(1.0, 0.0) : vec2(seen / float(SHADOW_TAPS), radius);
}

// Returns the key's visibility for items drawn straight into the picture, with noise that evens out
// over the samples.
float key_visibility(vec3 p, vec3 n, vec2 p_px)
{
    float phi = 6.2831853 * noise_at(p_px, frame.scene.w);
    return key_reaching(p, n, phi, fract(0.5 + 0.754878 * frame.scene.w)).x;
}
