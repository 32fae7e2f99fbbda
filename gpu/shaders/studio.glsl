// The studio: a smooth dome and three rectangular softboxes, in closed form for any roughness, so
// there is no environment texture and no prefiltering. gpu/studio.cpp integrates the same formulas.
//
// For n = v = r the GGX reflection lobe in the tangent plane of r is about (1 + t^2 / s^2)^-2 with
// s = 2 alpha (put t = 2 tan(theta_h) into D). Its marginal along one axis integrates to
//     C(x) = 1/2 (1 + x / sqrt(x^2 + s^2)),
// so a half plane is exact and a rectangle is nearly the product of two differences of C.
float lobe_step(float x, float s) { return x * inversesqrt(x * x + s * s); }

float softbox(int i, vec3 r, float alpha)
{
    float d = dot(r, frame.box_dir[i].xyz), k = 1.0 / max(d, 0.08);
    vec2 p = vec2(dot(r, frame.box_right[i].xyz), dot(r, frame.box_up[i].xyz)) * k;
    vec2 h = vec2(frame.box_right[i].w, frame.box_up[i].w);
    vec2 s = vec2(2.0 * alpha + frame.box_light[i].w) * (1.0 + p * p); // the plane stretches off axis
    float x = lobe_step(p.x + h.x, s.x) - lobe_step(p.x - h.x, s.x);
    float y = lobe_step(p.y + h.y, s.y) - lobe_step(p.y - h.y, s.y);
    return 0.25 * x * y * smoothstep(-0.1, 0.25, d);
}

vec3 dome(vec3 r, float alpha)
{
    float w = sqrt(0.09 + 4.0 * alpha * alpha), q = r.z / w;
    float b = inversesqrt(1.0 + q * q), t = 0.5 + 0.5 * q * b; // C(x) again, with a wide step
    return mix(frame.floor_light.rgb, frame.zenith.rgb, t) + frame.horizon.rgb * (0.3 / w) * b * b * b;
}

// The light that a lobe round r receives from everything but the key, and from the key (which the
// shadow map may take away).
struct Reflected { vec3 ambient, key; };
Reflected studio_reflected(vec3 r, float alpha)
{
    Reflected light;
    light.key = frame.box_light[0].rgb * softbox(0, r, alpha);
    light.ambient = dome(r, alpha) + frame.box_light[1].rgb * softbox(1, r, alpha)
                  + frame.box_light[2].rgb * softbox(2, r, alpha);
    return light;
}

// Irradiance without the key by 9 spherical harmonics, the cosine folded in (Ramamoorthi and
// Hanrahan 2001).
vec3 studio_irradiance(vec3 n)
{
    return max(vec3(0.0), frame.ambient[0].rgb + frame.ambient[1].rgb * n.y
        + frame.ambient[2].rgb * n.z + frame.ambient[3].rgb * n.x
        + frame.ambient[4].rgb * (n.x * n.y) + frame.ambient[5].rgb * (n.y * n.z)
        + frame.ambient[6].rgb * (3.0 * n.z * n.z - 1.0) + frame.ambient[7].rgb * (n.x * n.z)
        + frame.ambient[8].rgb * (n.x * n.x - n.y * n.y));
}
