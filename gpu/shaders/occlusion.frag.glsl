// Finds the light that reaches a surface or the ground, at half size: the share of the key, by
// shadow.glsl, and of the ambient light, by visibility bitmasks (Therrien, Levesque, Gilet 2023) in the
// slices of GTAO (Jimenez et al. 2016): the 32 sectors are uniform in sin(angle), so their free
// share is cosine weighted; surfaces have a thickness, so thin parts throw no dark halo.
#include "frame.glsl"
#include "bits.glsl"
#include "material.glsl"
#include "pack.glsl"
#include "shadow.glsl"
#include "ground.glsl"
#include "open.glsl"
layout(location = 0) out vec4 out_open; // open share, distance, key's share, penumbra in pixels
layout(binding = 2) uniform usampler2D surfaces;
layout(binding = 3) uniform usampler2D ids_depths; // full size

const int STEPS = 3; // to each side of each of SLICES slices

float quick_acos(float x)
{
    float a = abs(x);
    float r = (1.5707288 + a * (-0.2121144 + a * (0.0742610 - a * 0.0187293))) * sqrt(1.0 - min(a, 1.0));
    return x < 0.0 ? PI - r : r;
}

#if SLICES > 0
// Returns the share of the ambient light at the point p of view space with normal n.
float ambient_reaching(vec3 p, vec3 n, vec2 uv, float turn, float push)
{
    ivec2 size = textureSize(ids_depths, 0);
    bool perspective = frame.eye.w > 0.5;
    vec3 v = perspective ? normalize(-p) : vec3(0.0, 0.0, 1.0);
    p += n * 0.002 * frame.scene.x;
    float radius = frame.scene.z, thickness = radius * 0.5;
    float radius_px = radius * frame.clip[1][1] * 0.5 * float(size.y) / (perspective ? -p.z : 1.0);
    radius_px = min(radius_px, 0.25 * float(size.y));
    float open = 0.0, weights = 0.0;
    for (int s = 0; s < SLICES; s++) {
        float phi = (float(s) + turn) * PI / float(SLICES);
        vec2 w = vec2(cos(phi), sin(phi));
        vec3 dv = vec3(w, 0.0), across = dv - dot(dv, v) * v, axis = normalize(cross(dv, v));
        vec3 pn = n - axis * dot(n, axis);
        float len = length(pn), cosine = clamp(dot(pn, v) / max(len, 1e-5), -1.0, 1.0);
        float tilt = sign(dot(across, pn)) * quick_acos(cosine);
        uint blocked = 0u;
        for (int side = -1; side <= 1; side += 2)
            for (int j = 0; j < STEPS; j++) {
                float t = (float(j) + push + 0.25) / float(STEPS);
                vec2 q = uv + float(side) * w * (t * t * radius_px + 2.0) / vec2(size);
                ivec2 q_px = clamp(ivec2(q * vec2(size)), ivec2(0), size - 1);
                float z = uintBitsToFloat(texelFetch(ids_depths, q_px, 0).g);
                if (z == 0.0) continue;
                vec3 d = view_point((vec2(q_px) + 0.5) / vec2(size), z) - p;
                float l2 = dot(d, d);
                if (l2 > radius * radius * 1.6) continue;
                float front = quick_acos(dot(d, v) * inversesqrt(l2));
                float back = quick_acos(dot(normalize(d - v * thickness), v));
                vec2 h = clamp(vec2(front, back) * float(side) - tilt, -0.5 * PI, 0.5 * PI);
                h = sin(h) * 0.5 + 0.5;
                if (h.x > h.y) h = h.yx;
                uint first = uint(h.x * 32.0), count = uint(clamp(round((h.y - h.x) * 32.0), 0.0, 32.0));
                blocked |= count == 0u ? 0u : (0xFFFFFFFFu >> (32u - count)) << min(first, 31u);
            }
        open += len * (1.0 - float(bits_set(blocked)) / 32.0);
        weights += len;
    }
    return saturate(open / max(weights, 1e-4));
}
#endif

void main()
{
    ivec2 size = textureSize(ids_depths, 0);
    ivec2 here = min(ivec2(gl_FragCoord.xy) * 2 + looked_at(), size - 1);
    vec2 uv = (vec2(here) + 0.5) / vec2(size);
    float depth = uintBitsToFloat(texelFetch(ids_depths, here, 0).g);
    bool surface = depth > 0.0;
    Ground ground = ground_behind(uv);
    if (!surface && !(ground.seen && frame.ground.w > 0.5)) {
        out_open = vec4(1.0, -1e9, 1.0, 0.0);
        return;
    }
    vec3 n = surface ? unpacked_normal(texelFetch(surfaces, here, 0).x) : vec3(0.0, 0.0, 1.0);
    vec3 in_view = view_point(uv, depth);
    vec3 p = surface ? (frame.from_view * vec4(in_view, 1.0)).xyz : ground.at;
    depth = surface ? depth : ground.depth;
    ivec2 c = ivec2(gl_FragCoord.xy) & 3; // a 4 x 4 pattern, which the blur averages
    float turn = fract((float((c.x ^ c.y) * 4 + c.y) + 0.5) / 16.0 + frame.scene.w * 0.618034);
    float push = fract(float((c.y * 4 + c.x) * 7 % 16) / 16.0 + frame.scene.w * 0.754878);

    vec2 key = vec2(0.0); // nothing reaches what is turned away
    if (dot(n, frame.key_dir.xyz) > -frame.key_dir.w) key = key_reaching(p, n, 2.0 * PI * turn, push);
    float pixel_world = (frame.eye.w > 0.5 ? depth : 1.0) * 4.0 * frame.size_px.w / frame.clip[1][1];
    float open = 1.0;
#if SLICES > 0
    if (surface) open = ambient_reaching(in_view, mat3(frame.view) * n, uv, turn, push);
#endif
    out_open = vec4(open, surface ? depth : -depth, key.x, key.y * frame.shadow_map.y / pixel_world);
}
