// One deformed vertex, as the variant wants it: NORMALS 0 none, 1 exact, 2 by differences; TANGENTS
// only with exact normals; RAISED and FILTERED: by order raising.
#include "volume_inputs.glsl"
#include "raised_inputs.glsl"

struct DeformedVertex {
    vec3 position, normal;
    vec4 tangent;
};

vec3 position_at(vec3 p)
{
#ifdef RAISED
    return displaced(p, raised_displacement(spot_at(x_of(p))));
#else
    return deformed_point(p).position;
#endif
}

DeformedVertex deformed_vertex(vec3 p, vec3 normal, vec4 tangent)
{
    DeformedVertex v;
    v.normal = normal;
    v.tangent = tangent;
#if NORMALS == 1
    DeformedPoint there = deformed_point(p);
    v.position = there.position;
    v.normal = deformed_normal(there.jacobian, normal);
#ifdef TANGENTS
    v.tangent = deformed_tangent(there.jacobian, tangent, v.normal);
#endif
#else
    v.position = position_at(p);
#if NORMALS == 2
    NormalPlane plane = plane_of(normal);
    v.normal = difference_normal(v.position, position_at(p + volume.difference_step * plane.along),
                                 position_at(p + volume.difference_step * plane.across));
#endif
#endif
    return v;
}
