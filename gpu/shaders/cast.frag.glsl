// What a ray gathers on its way through a volume, up to the nearest surface or curve. FIELD_ORDER is
// that of the spline, 2 to 4; ROUGH is for drafts.
#include "frame.glsl"
#include "studio.glsl"
#include "tonemap.glsl"
in vec2 uv;
layout(location = 0) out vec4 out_gathered; // display-linear, times the opacity
layout(location = 1) out float out_hit;     // distance up to which half is held back; 0: nowhere
layout(binding = 3) uniform usampler2D ids_depths;
layout(binding = 0) uniform sampler3D voxel_samples;
layout(binding = 1) uniform sampler3D spline_coefficients; // with a border of one
layout(binding = 2) uniform sampler3D open_bricks; // see OpenBricks
layout(binding = 6) uniform sampler2D transfer;
layout(binding = 7) uniform usampler3D empty_bricks;
uniform mat4 to_voxels;  // of the scene
uniform mat3 to_normals; // slopes per voxel to slopes along the scene's axes, per length of a voxel
uniform vec4 low, high;  // the box that is seen, in voxels
uniform vec4 last_per_length; // greatest coordinates, voxel lengths in a unit of the scene times density
uniform vec2 shading_pace;    // pace: voxels in a step
uniform vec4 shares;          // x a + y: share of the range for a sample a of the texture; zw: coefficients

int order() { return FIELD_ORDER; }
#ifdef ROUGH
bool rough() { return true; }
#else
bool rough() { return false; }
#endif
vec3 last() { return last_per_length.xyz; }
float sample_at(vec3 p)
{
    return textureLod(voxel_samples, (p + 0.5) / (last_per_length.xyz + 1.0), 0.0).r * shares.x + shares.y;
}
float coefficient_at(vec3 p)
{
    return textureLod(spline_coefficients, (p + 1.5) / (last_per_length.xyz + 3.0), 0.0).r * shares.z + shares.w;
}
int empty_reach(ivec3 brick)
{
    return int(texelFetch(empty_bricks, min(brick, textureSize(empty_bricks, 0) - 1), 0).r);
}
vec4 transfer_before(float u) { return textureLod(transfer, vec2((u * 1024.0 + 0.5) / 1025.0, 0.5), 0.0); }

vec3 toward_eye = vec3(0.0, 0.0, 1.0); // scene, unit

// Where values change, what is seen is a surface across the slope, and lit from the side of the eye.
vec3 lit(vec3 color, vec3 p, vec3 slope)
{
    const float FAINT = 0.02; // slope at which half of the light is that of a surface
    vec3 g = to_normals * slope;
    float steep = dot(g, g);
    if (steep < 1e-10) return color;
    vec3 n = g * inversesqrt(steep);
    if (dot(n, toward_eye) < 0.0) n = -n;
    // A brick outside of what is seen there; a plane lets half of the light through.
    vec3 outside = p + slope * (sign(dot(g, n)) * 4.0 / sqrt(max(dot(slope, slope), 1e-12)));
    float open = saturate(1.5 * textureLod(open_bricks, outside / (4.0 * vec3(textureSize(open_bricks, 0))), 0.0).r);
    float x = dot(n, frame.key_dir.xyz), soft = frame.key_dir.w * 0.9;
    float facing = x > soft ? x : x < -soft ? 0.0 : (x + soft) * (x + soft) / (4.0 * soft);
    vec3 shaded = color * (studio_irradiance(n) * open + frame.key_light.rgb * (facing * sqrt(open))) / PI;
#ifndef ROUGH
    const float ALPHA = 0.16;
    Reflected mirror = studio_reflected(reflect(-toward_eye, n), ALPHA);
    float away = 1.0 - max(dot(n, toward_eye), 0.0);
    shaded += (0.03 + 0.25 * away * away * away * away) * (mirror.ambient + mirror.key) * open;
#endif
    return mix(color, shaded, shading_pace.x * steep / (steep + FAINT * FAINT));
}

#include "casting.glsl"

void main()
{
    const float CURVE_AIR = 2.5; // voxels before a curve that do not veil it
    out_gathered = vec4(0.0);
    out_hit = 0.0;
    bool perspective = frame.eye.w > 0.5;
    vec3 foot = view_point(uv, 0.0), to_next = view_point(uv, 1.0) - foot;
    vec3 from = (to_voxels * (frame.from_view * vec4(foot, 1.0))).xyz;
    vec3 ahead = mat3(frame.from_view) * to_next, along = mat3(to_voxels) * ahead;
    along = mix(along, vec3(1e-9), lessThan(abs(along), vec3(1e-9)));
    toward_eye = -normalize(ahead);

    vec3 a = (low.xyz - from) / along, b = (high.xyz - from) / along;
    vec3 near = min(a, b), far = max(a, b);
    float begin = max(near.x, max(near.y, near.z)), end = min(far.x, min(far.y, far.z));
    if (perspective) begin = max(begin, 0.0);
    uvec2 solid = texelFetch(ids_depths, min(ivec2(uv * frame.size_px.xy), ivec2(frame.size_px.xy) - 1), 0).rg;
    float by_voxel = 1.0 / length(along);
    if (solid.g != 0u) {
        float air = (solid.r >> 31) != 0u ? CURVE_AIR * by_voxel : 0.0;
        end = min(end, uintBitsToFloat(solid.g) - air);
    }
    if (begin >= end) return;
    // The samples of a pixel share the step among them, by the golden ratio.
    float jitter = fract(noise_at(gl_FragCoord.xy, 0.0) + 0.618034 * frame.scene.w);
    Gathered g = cast_ray(from + along * begin, along, end - begin, shading_pace.y * by_voxel, jitter,
                          length(ahead) * last_per_length.w);
    if (g.opacity <= 0.0) return;
    out_gathered = vec4(tone_mapped(g.color / g.opacity), 1.0) * g.opacity;
    out_hit = g.opacity >= 0.5 ? begin + g.hit : 0.0;
}
