// Computes the material inside the body: SOLID 1 wood, 2 flesh, 3 metal.
in vec3 at_rest;
uniform int turned_about; // of metal, the axis, 0..2

// Fades detail that is finer than a pixel.
float drawn(float cycles) { return 1.0 - smoothstep(0.25, 0.7, cycles * length(fwidth(at_rest))); }

#include "filling.glsl"

// The normal of a surface with that slope along the distance from the axis. What that direction is
// follows from how distance and place change over the screen (Mikkelsen 2010).
vec3 grooved(vec3 n, float slope)
{
    float away = length(about(at_rest, turned_about).xy);
    vec3 px = dFdx(at_scene), py = dFdy(at_scene), ax = dFdx(at_rest), ay = dFdy(at_rest);
    vec3 rx = cross(py, n), ry = cross(n, px);
    float area = dot(px, rx), rate = dot(ax, ax) + dot(ay, ay);
    if (abs(area) < 1e-20 || rate < 1e-20) return n;
    vec3 outwards = (rx * dFdx(away) + ry * dFdy(away)) / area;
    return normalize(n - slope * sqrt((dot(px, px) + dot(py, py)) / rate) * outwards);
}

void fill(inout Surface s)
{
#if SOLID == 1
    Stuff stuff = wood_at(at_rest);
#elif SOLID == 2
    Stuff stuff = flesh_at(at_rest);
#else
    Stuff stuff = metal_at(at_rest, turned_about);
    s.normal = grooved(s.normal, stuff.groove);
#endif
    s.base = saturate(stuff.color * s.base / 0.8);
    s.roughness = stuff.roughness;
    s.metallic = stuff.metallic;
}
