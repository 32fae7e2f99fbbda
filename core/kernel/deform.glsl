// Free-form deformation of a point, a normal and a tangent.    GLSL and C++: see core/kernel/volume_kernel.h
//
//   F(p) = rest(p) + D(x(p))        J = rest' + D' x'        n' = cof(J) n / |cof(J) n| (normal.glsl)
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
