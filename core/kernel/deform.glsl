// Free-form deformation of a point, a normal and a tangent.    GLSL and C++: see core/kernel/volume_kernel.h
//
//   F(p) = rest(p) + D(x(p))        J = rest' + D' x'        n' = cof(J) n / |cof(J) n|
//
// The displacement is added to an affine rest, so a lattice of zeros is that map and its sum loses
// no digits. Affine maps are taken of p less a point in the middle, for the same reason.

vec3 x_of(vec3 p)
{
    return mat3(volume.x_by_p) * (p - vec3(volume.x_middle)) + vec3(volume.x_by_p[3]);
}

// Displacement first: it is small, and where the rest is a shift it is all there is.
vec3 displaced(vec3 p, vec3 displacement)
{
    vec3 moved = mat3(volume.rest_by_p) * (p - vec3(volume.rest_middle)) + displacement;
    return moved + vec3(volume.rest_by_p[3]);
}

struct DeformedPoint {
    vec3 position;
    mat3 jacobian; // of the position by p, times volume.jacobian_scale
};

DeformedPoint deformed_point(vec3 p)
{
    Jet jet = jet_at(spot_at(x_of(p)));
    DeformedPoint there;
    there.position = displaced(p, jet.value);
    mat3 by_x = mat3(jet.by_u, jet.by_v, jet.by_w);
    there.jacobian =
        (mat3(volume.rest_by_p) + by_x * mat3(volume.x_by_p)) * volume.jacobian_scale;
    return there;
}

// Cofactors map normals where J maps tangents: exactly, without a division, and also where J has
// rank 2 (Barr 1984). Where even |cof(J) n| vanishes, the normal stays what it was.
vec3 deformed_normal(mat3 j, vec3 normal)
{
    vec3 n = cross(j[1], j[2]) * normal.x + cross(j[2], j[0]) * normal.y +
             cross(j[0], j[1]) * normal.z;
    float size = dot(j[0], j[0]) + dot(j[1], j[1]) + dot(j[2], j[2]), square = dot(n, n);
    return square > 1e-13f * size * size ? n / sqrt(square) : normal;
}

// Made orthogonal to the deformed normal; the handedness stays.
vec4 deformed_tangent(mat3 j, vec4 tangent, vec3 normal)
{
    vec3 along = j * vec3(tangent);
    vec3 t = along - normal * dot(along, normal);
    if (!(dot(t, t) > 1e-13f * dot(along, along))) {
        vec3 axis = abs(normal.x) < 0.5f ? vec3(1.0f, 0.0f, 0.0f) : vec3(0.0f, 1.0f, 0.0f);
        t = axis - normal * dot(axis, normal);
    }
    return vec4(t / sqrt(dot(t, t)), tangent.w);
}
