// Stuffs that fill a body: SOLID 1 wood, 2 flesh. They follow from where a point is before the body
// is deformed, over the radius of the body at rest, so they bend and stretch with it.
in vec3 at_rest;

uint hash_of(ivec3 cell)
{
    uvec3 v = uvec3(cell) * uvec3(1664525u, 22695477u, 2891336453u) + 1013904223u;
    uint h = v.x ^ (v.y * 747796405u) ^ (v.z * 277803737u);
    h = (h ^ (h >> 15)) * 2246822519u;
    h = (h ^ (h >> 13)) * 3266489917u;
    return h ^ (h >> 16);
}
float at_corner(ivec3 cell) { return float(hash_of(cell) >> 8) / 16777216.0; }

// Random values at whole numbers with smooth ways between them, 0..1.
float noise(vec3 p)
{
    vec3 f = floor(p);
    ivec3 c = ivec3(f);
    f = p - f;
    f = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    const ivec2 o = ivec2(0, 1);
    vec4 low = vec4(at_corner(c), at_corner(c + o.xyx), at_corner(c + o.xxy), at_corner(c + o.xyy));
    vec4 high = vec4(at_corner(c + o.yxx), at_corner(c + o.yyx), at_corner(c + o.yxy), at_corner(c + o.yyy));
    vec4 x = mix(low, high, f.x);
    vec2 y = mix(x.xz, x.yw, f.y);
    return mix(y.x, y.y, f.z);
}

// Sums of it, each twice as fine, half as strong and turned, so that no grid shows.
float clouds(vec3 p, int octaves)
{
    const mat3 finer = 2.03 * mat3(0.00, -0.80, -0.60, 0.80, 0.36, -0.48, 0.60, -0.48, 0.64);
    float sum = 0.0, size = 0.5;
    for (int i = 0; i < octaves; i++) {
        sum += size * noise(p);
        p = finer * p + 17.1;
        size *= 0.5;
    }
    return sum;
}

// What lies finer than a pixel is not drawn.
float drawn(float cycles) { return 1.0 - smoothstep(0.25, 0.7, cycles * length(fwidth(at_rest))); }

#if SOLID == 1
// The pith lies along the body, a little tilted and beside its middle.
vec3 solid_color(vec3 p, out float roughness)
{
    vec3 q = vec3(p.x - 0.18 * p.y + 0.12 * p.z, p.y + 0.18 * p.x, p.z - 0.12 * p.x);
    q += 0.08 * (vec3(clouds(p * 2.3, 2), clouds(p * 2.3 + 9.1, 2), clouds(p * 2.3 + 4.7, 2)) - 0.4);
    vec2 across = q.yz - vec2(0.22, -0.31);
    float rings = length(across) * 15.0 + 0.5 * clouds(q * vec3(0.5, 3.0, 3.0), 2), ring = fract(rings);
    // Pale early wood, a dark thin band of late wood, and an end as sharp as a pixel allows.
    float late = smoothstep(0.35, 0.9, ring) * (1.0 - smoothstep(0.93, 1.0, ring));
    late = mix(0.3, late, drawn(15.0)) * (0.65 + 0.35 * noise(vec3(floor(rings) * 7.3)));
    float rays = clouds(vec3(q.x * 6.0, atan(across.y, across.x) * 40.0, length(across) * 5.0), 2);
    float pores = smoothstep(0.60, 0.85, noise(q * vec3(20.0, 230.0, 230.0))) * drawn(115.0);
    vec3 color = mix(vec3(0.62, 0.40, 0.215), vec3(0.335, 0.165, 0.068), late);
    roughness = 0.5 + 0.2 * late + 0.15 * pores;
    return color * (0.88 + 0.24 * rays) * (1.0 - 0.3 * pores);
}
#else
// Fibres along the body, and septa of fat between the muscles: thin level sets of the noise.
vec3 solid_color(vec3 p, out float roughness)
{
    float large = clouds(p * 5.0, 3), bent = 3.0 * large;
    float fibres = mix(0.45, clouds(p * vec3(7.0, 34.0, 34.0) + bent, 3), drawn(34.0));
    float wander = clouds(p * 9.0 + 3.0, 2);
    float wide = abs(clouds(p * 4.2 + 11.0 + 0.5 * wander, 3) - 0.44);
    float thin = abs(clouds(p * 13.0 + 5.0, 2) - 0.38);
    float fat = smoothstep(0.022, 0.004, wide);
    fat = max(fat, 0.55 * smoothstep(0.016, 0.0, thin) * smoothstep(0.34, 0.5, wander) * drawn(26.0));
    vec3 color = mix(vec3(0.235, 0.028, 0.026), vec3(0.42, 0.075, 0.060), smoothstep(0.3, 0.62, fibres));
    color = mix(color, vec3(0.66, 0.43, 0.31), 0.8 * fat) * (0.82 + 0.36 * large);
    roughness = 0.36 + 0.14 * fat;
    return color;
}
#endif
