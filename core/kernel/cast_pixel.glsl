// Casts the ray of one pixel through volume data.   GLSL and C++: see CastView, whose names these are
//
// Supplied: what casting.glsl has, and float open_at(vec3 brick), the share of the light from all around
// that reaches a place, in bricks; vec3 toward_eye, a variable for the ray at hand.

vec3 ray_part(int first, vec2 uv)
{
    return vec3(rays[first] + uv.x * rays[first + 1] + uv.y * rays[first + 2]);
}

// Irradiance but that of the key light by 9 spherical harmonics (Ramamoorthi and Hanrahan 2001).
vec3 light_around(vec3 n)
{
    vec4 sum = lights[0] + lights[1] * n.y + lights[2] * n.z + lights[3] * n.x + lights[4] * (n.x * n.y) +
               lights[5] * (n.y * n.z) + lights[6] * (3.0f * n.z * n.z - 1.0f) +
               lights[7] * (n.x * n.z) + lights[8] * (n.x * n.x - n.y * n.y);
    return max(vec3(sum), vec3(0.0f));
}

// Lights a value as a surface across the slope, where values change, from the side of the eye.
vec3 lit(vec3 color, vec3 p, vec3 slope)
{
    const float FAINT = 0.02f; // slope at which half of the light is that of a surface
    const float BY_PI = 0.318309886f;
    vec3 g = to_normals * slope;
    float steep = dot(g, g);
    if (steep < 1e-10f) return color;
    vec3 n = g * (1.0f / sqrt(steep));
    float side = dot(n, toward_eye) < 0.0f ? -1.0f : 1.0f;
    n *= side;
    // A brick outside of what is seen there; a plane lets half of the light through.
    float open = min(1.5f * open_at(p / BRICK + slope * (side / sqrt(max(dot(slope, slope), 1e-12f)))), 1.0f);
    vec3 key = vec3(lights[9]);
    float x = dot(n, key), soft = lights[9].w * 0.9f;
    float facing = x > soft ? x : x < -soft ? 0.0f : (x + soft) * (x + soft) / (4.0f * soft);
    vec3 light = light_around(n) * open + vec3(lights[10]) * (facing * sqrt(open));
    vec3 mirror = 2.0f * dot(n, toward_eye) * n - toward_eye;
    float away = 1.0f - dot(n, toward_eye), away2 = away * away, glint = max(dot(mirror, key), 0.0f);
    glint *= glint;
    glint *= glint;
    glint *= glint;
    glint *= glint * glint; // the power 24
    vec3 shine = light_around(mirror) * (0.02f + 0.2f * away2 * away2) + vec3(lights[10]) * (0.12f * glint);
    return mix(color, (color * light + shine * open) * BY_PI, look.y * steep / (steep + FAINT * FAINT));
}

float step_share(vec2 p_px)
{
    // Interleaved gradient noise (Jimenez 2014); samples share the step among them, by the golden ratio.
    float noise = fract(52.9829189f * fract(dot(p_px, vec2(0.06711056f, 0.00583715f))));
    return 1.0f - low.w * fract(noise + 0.618034f * look.w);
}

// `hit` is the distance along the view direction where half of the light is held back, 0: nowhere.
// `solid`: the nearest surface or curve, and its distance; 0: none.
Gathered cast_pixel(vec2 uv, vec2 p_px, uint solid_id, float solid)
{
    const float CURVE_AIR = 2.5f; // voxels before a curve that do not veil it
    vec3 from = ray_part(0, uv), along = ray_part(3, uv), ahead = ray_part(6, uv);
    if (abs(along.x) < 1e-9f) along.x = 1e-9f;
    if (abs(along.y) < 1e-9f) along.y = 1e-9f;
    if (abs(along.z) < 1e-9f) along.z = 1e-9f;
    toward_eye = -normalize(ahead);
    vec3 a = (vec3(low) - from) / along, b = (vec3(high) - from) / along;
    vec3 first = min(a, b), past = max(a, b);
    float begin = max(first.x, max(first.y, first.z)), end = min(past.x, min(past.y, past.z));
    if (rays[0].w > 0.5f) begin = max(begin, 0.0f); // of perspective: not behind the eye
    float by_voxel = 1.0f / length(along);
    if (solid != 0.0f) end = min(end, solid - ((solid_id >> 31) != 0u ? CURVE_AIR * by_voxel : 0.0f));
    Gathered g;
    g.color = vec3(0.0f);
    g.opacity = 0.0f;
    g.hit = 0.0f;
    if (begin >= end) return g;
    g = cast_ray(from + along * begin, along, end - begin, look.z * by_voxel, step_share(p_px),
                 length(ahead) * look.x);
    g.hit = g.opacity >= 0.5f ? begin + g.hit : 0.0f;
    return g;
}
