// Stuffs that fill a body: wood, flesh, metal.      GLSL and C++: see core/mesh/filling_colors.cpp
//
// They follow from where a point is before the body is deformed, from the middle of its box over
// half the diagonal of that, so they bend and stretch with it and go on across cuts.
//
// Supplied: float drawn(float cycles): how much is shown of what repeats so often over that length,
// 0..1; what lies finer than a pixel, or than the vertices that show it, is not.

struct Stuff {
    vec3 color; // linear
    float roughness, metallic;
    float groove; // slope of the surface along the distance from the axis
};

uint hash_of(ivec3 cell)
{
    uvec3 v = uvec3(cell) * uvec3(1664525u, 22695477u, 2891336453u) + 1013904223u;
    uint h = v.x ^ (v.y * 747796405u) ^ (v.z * 277803737u);
    h = (h ^ (h >> 15)) * 2246822519u;
    h = (h ^ (h >> 13)) * 3266489917u;
    return h ^ (h >> 16);
}
float at_corner(ivec3 cell) { return float(hash_of(cell) >> 8) / 16777216.0f; }

// Random values at whole numbers with smooth ways between them, 0..1.
float noise(vec3 p)
{
    vec3 f = floor(p);
    ivec3 c = ivec3(f);
    f = p - f;
    f = f * f * f * (f * (f * 6.0f - 15.0f) + 10.0f);
    vec4 low = vec4(at_corner(c), at_corner(c + ivec3(0, 1, 0)), at_corner(c + ivec3(0, 0, 1)),
                    at_corner(c + ivec3(0, 1, 1)));
    c = c + ivec3(1, 0, 0);
    vec4 high = vec4(at_corner(c), at_corner(c + ivec3(0, 1, 0)), at_corner(c + ivec3(0, 0, 1)),
                     at_corner(c + ivec3(0, 1, 1)));
    vec4 x = mix(low, high, f.x);
    return mix(mix(x.x, x.y, f.y), mix(x.z, x.w, f.y), f.z);
}

// Sums of it, each twice as fine, half as strong and turned, so that no grid shows.
float clouds(vec3 p, int octaves)
{
    mat3 finer = 2.03f * mat3(0.00f, -0.80f, -0.60f, 0.80f, 0.36f, -0.48f, 0.60f, -0.48f, 0.64f);
    float sum = 0.0f, size = 0.5f;
    for (int i = 0; i < octaves; i++) {
        sum += size * noise(p);
        p = finer * p + 17.1f;
        size *= 0.5f;
    }
    return sum;
}

// The pith lies along the body, a little tilted and beside its middle.
Stuff wood_at(vec3 p)
{
    vec3 q = vec3(p.x - 0.18f * p.y + 0.12f * p.z, p.y + 0.18f * p.x, p.z - 0.12f * p.x);
    q += 0.08f *
         (vec3(clouds(p * 2.3f, 2), clouds(p * 2.3f + 9.1f, 2), clouds(p * 2.3f + 4.7f, 2)) - 0.4f);
    vec2 across = vec2(q.y - 0.22f, q.z + 0.31f);
    float rings = length(across) * 15.0f + 0.5f * clouds(q * vec3(0.5f, 3.0f, 3.0f), 2);
    float ring = fract(rings);
    // Pale early wood, a dark thin band of late wood, and an end as sharp as a pixel allows.
    float late = smoothstep(0.35f, 0.9f, ring) * (1.0f - smoothstep(0.93f, 1.0f, ring));
    late = mix(0.3f, late, drawn(15.0f)) * (0.65f + 0.35f * noise(vec3(floor(rings) * 7.3f)));
    float rays =
        clouds(vec3(q.x * 6.0f, atan(across.y, across.x) * 40.0f, length(across) * 5.0f), 2);
    float pores =
        smoothstep(0.60f, 0.85f, noise(q * vec3(20.0f, 230.0f, 230.0f))) * drawn(115.0f);
    vec3 color = mix(vec3(0.62f, 0.40f, 0.215f), vec3(0.335f, 0.165f, 0.068f), late);
    Stuff s;
    s.color = color * (0.88f + 0.24f * rays) * (1.0f - 0.3f * pores);
    s.roughness = 0.5f + 0.2f * late + 0.15f * pores;
    s.metallic = s.groove = 0.0f;
    return s;
}

// Fibres along the body, and septa of fat between the muscles: thin level sets of the noise.
Stuff flesh_at(vec3 p)
{
    float large = clouds(p * 5.0f, 3), bent = 3.0f * large;
    float fibres = mix(0.45f, clouds(p * vec3(7.0f, 34.0f, 34.0f) + bent, 3), drawn(34.0f));
    float wander = clouds(p * 9.0f + 3.0f, 2);
    float wide = abs(clouds(p * 4.2f + 11.0f + 0.5f * wander, 3) - 0.44f);
    float thin = abs(clouds(p * 13.0f + 5.0f, 2) - 0.38f);
    float fat = smoothstep(0.022f, 0.004f, wide);
    fat = max(fat, 0.55f * smoothstep(0.016f, 0.0f, thin) * smoothstep(0.34f, 0.5f, wander) *
                       drawn(26.0f));
    vec3 color = mix(vec3(0.235f, 0.028f, 0.026f), vec3(0.42f, 0.075f, 0.060f),
                     smoothstep(0.3f, 0.62f, fibres));
    Stuff s;
    s.color = mix(color, vec3(0.66f, 0.43f, 0.31f), 0.8f * fat) * (0.82f + 0.36f * large);
    s.roughness = 0.36f + 0.14f * fat;
    s.metallic = s.groove = 0.0f;
    return s;
}

// The place of a point about an axis, 0..2, which becomes the third.
vec3 about(vec3 p, int axis)
{
    return axis == 0 ? vec3(p.y, p.z, p.x) : axis == 1 ? vec3(p.z, p.x, p.y) : p;
}

// Forged, so not the same all over, and then turned: a tool went round the axis and left marks as
// fine as its steps, in broader bands from pass to pass. Grooves that are not drawn make it rougher.
Stuff metal_at(vec3 place, int axis)
{
    vec3 p = about(place, axis);
    float away = length(vec2(p.x, p.y));
    float forged = clouds(p * 3.1f + 5.0f, 3) - 0.44f;
    float passes = (noise(vec3(away * 19.0f, p.z * 7.0f, 3.5f)) - 0.5f) * drawn(10.0f);
    float marks = (noise(vec3(away * 92.0f, p.z * 30.0f, 7.5f)) - 0.5f) * drawn(46.0f);
    float fine = (noise(vec3(away * 220.0f, p.z * 70.0f, 11.5f)) - 0.5f) * drawn(110.0f);
    float tone = 0.9f + 0.18f * forged + 0.14f * passes + 0.26f * marks + 0.28f * fine;
    Stuff s;
    s.color = vec3(0.70f, 0.69f, 0.67f) * tone;
    s.roughness = 0.35f + 0.08f * forged + 0.06f * passes + 0.05f * (1.0f - drawn(110.0f));
    s.metallic = 0.6f;
    s.groove = 0.11f * marks + 0.12f * fine;
    return s;
}
