// The uniforms of every program of one sample. gpu/frame.h mirrors it field by field. Scene space is
// world space moved to the middle of the scene: Z up, world units. Colours and light are linear.
const float PI = 3.14159265359;

layout(std140, binding = 0) uniform Frame {
    mat4 view;         // scene -> view
    mat4 clip;         // view -> clip, with the sample's shift inside the pixel
    mat4 view_clip;    // scene -> clip
    mat4 from_view;    // view -> scene
    mat4 key_clip;     // scene -> clip space of the key light (orthographic)
    vec4 eye;          // perspective: xyz the eye, w 1; orthographic: xyz unit towards it, w 0
    vec4 size_px;      // width, height, 1/width, 1/height
    vec4 key_dir;      // xyz unit towards the key light, w tangent of its half angle
    vec4 key_light;    // rgb irradiance on a facing plane, w 1: casts shadows
    vec4 ambient[9];   // irradiance of everything but the key in spherical harmonics
    vec4 box_dir[3];   // softboxes: xyz unit towards the middle; box 0 is the key
    vec4 box_right[3]; // xyz unit, w half width at distance 1
    vec4 box_up[3];    // xyz unit, w half height at distance 1
    vec4 box_light[3]; // rgb radiance, w softness of the edge
    vec4 zenith;       // rgb radiance of the dome overhead
    vec4 horizon;      // rgb radiance added in a band round the horizon
    vec4 floor_light;  // rgb radiance of the dome from below
    vec4 ground;       // height, grid step, radius where it has faded (world), 1: catches shadows
    vec4 contact;      // contact map: xy its corner, 1/side, side (world)
    vec4 shadow_map;   // 1/resolution, width, depth range (world), tangent of the light's half angle
    vec4 scene;        // radius (world), exposure factor, occlusion radius (world), noise seed
    vec4 backdrop[3];  // rgb display-linear: top (w: darker in the corners), middle, bottom
    vec4 centre;       // xyz centre of the ground's fade, w width of the grid's finest lines in pixels
    vec4 ground_share; // share of the ambient light in all that reaches the open ground, rgb
    vec4 grid_lines[4]; // grid, every fifth line, the axes u and v: display-linear, share of the encoded colour
    vec4 grid_at;      // xy a crossing of fifth lines, zw of the axes, both along u and v (scene)
    vec4 grid_u;       // xyz unit of the grid's plane, w the plane's height along cross(u, v) (scene)
    vec4 grid_v;       // xyz unit of the grid's plane, w 1: seen face to face, so it does not fade
} frame;

float saturate(float x) { return clamp(x, 0.0, 1.0); }
vec3 saturate(vec3 x) { return clamp(x, 0.0, 1.0); }
float luma(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0722)); }

// The unit direction from a point of the scene to the eye.
vec3 towards_eye(vec3 p) { return normalize(frame.eye.xyz - p * frame.eye.w); }

// The point of view space at a place of the picture (0..1) and a distance along the view direction.
vec3 view_point(vec2 uv, float depth)
{
    bool perspective = frame.eye.w > 0.5;
    vec2 shift = perspective ? frame.clip[2].xy : -frame.clip[3].xy;
    vec2 slope = (uv * 2.0 - 1.0 + shift) / vec2(frame.clip[0][0], frame.clip[1][1]);
    return vec3(slope * (perspective ? depth : 1.0), -depth);
}

// Interleaved gradient noise (Jimenez 2014); the seed moves it from sample to sample.
float noise_at(vec2 p_px, float seed)
{
    p_px += 5.588238 * mod(seed, 64.0);
    return fract(52.9829189 * fract(dot(p_px, vec2(0.06711056, 0.00583715))));
}

// Adds one triangular step of 8-bit noise in the encoded domain: no bands in gradients.
// d(linear)/d(encoded) is taken as 2 sqrt(linear): no pow, wrong by less than half a step.
vec3 dithered(vec3 linear, vec2 p_px, float seed)
{
    float n = noise_at(p_px, seed) + noise_at(p_px + 47.3, seed + 7.0) - 1.0;
    vec3 noise = 2.0 * sqrt(max(linear, 0.0)) * (n / 255.0);
    return saturate(linear + mix(noise, vec3(0.0), greaterThanEqual(linear, vec3(1.0)))); // white is white
}

// The points i of n of a sunflower disk (Vogel 1979), one after another: `toward` is the direction
// of the present one and goes on by the golden angle; `out_by`, 0 to 1, moves the points outwards by
// a part of their spacing.
vec2 sunflower(int i, int n, float out_by, inout vec2 toward)
{
    const mat2 GOLDEN = mat2(-0.7373688780, 0.6754902943, -0.6754902943, -0.7373688780);
    vec2 at = sqrt((float(i) + out_by) / float(n)) * toward;
    toward = GOLDEN * toward;
    return at;
}
