// The two evaluations of Schein 2006 that Trivar is compared with.   GLSL and C++
// (core/kernel/volume_kernel.h). Both are slower and less exact than jet_at() on what we measured.
//
// Order raising, section 4.4: a basis function of order o is made of two of order o - 1, so
//   D = sum_m N_m^{o-1} mix(D_{m-1}, D_m, a_m),   a_m = (x - x_m) / (x_{m+o-1} - x_m),
// o - 1 terms an axis, each a trilinear look-up between control points.
//
// Supplied besides: vec3 lattice_between(int first, vec3 at), the trilinear look-up at `at` control
// points from the first one: lerped_between(), or the device's filter.
// Rows of cells: 5..7 of t^0..t^2 in the functions of lower order, 8 and 9 of t^0 and t^1 in a_m.

// Functions of lower order, and a_m counted from the first control point.
struct RaisedBasis {
    vec4 weight, at;
};

RaisedBasis raised_basis(int cell, float t)
{
    RaisedBasis b;
    b.weight = (cell_row(cell, 7) * t + cell_row(cell, 6)) * t + cell_row(cell, 5);
    b.at = cell_row(cell, 9) * t + cell_row(cell, 8) + vec4(0.0f, 1.0f, 2.0f, 3.0f);
    return b;
}

vec3 lerped_between(int first, vec3 at)
{
    ivec3 low = min(ivec3(floor(at)), ivec3(order_u, order_v, order_w) - 2);
    vec3 f = at - vec3(low);
    int i = first + low.x * volume.stride[0] + low.y * volume.stride[1] + low.z;
    int u = volume.stride[0], v = volume.stride[1];
    vec3 v0 = mix(mix(lattice_point(i), lattice_point(i + 1), f.z),
                  mix(lattice_point(i + v), lattice_point(i + v + 1), f.z), f.y);
    vec3 v1 = mix(mix(lattice_point(i + u), lattice_point(i + u + 1), f.z),
                  mix(lattice_point(i + u + v), lattice_point(i + u + v + 1), f.z), f.y);
    return mix(v0, v1, f.x);
}

vec3 raised_displacement(Spot spot)
{
    RaisedBasis bu = raised_basis(spot.cell.x, spot.t.x);
    RaisedBasis bv = raised_basis(spot.cell.y, spot.t.y);
    RaisedBasis bw = raised_basis(spot.cell.z, spot.t.z);
    int first = first_point(spot);
    vec3 sum = vec3(0.0f);
    for (int i = 0; i < order_u - 1; ++i)
        for (int j = 0; j < order_v - 1; ++j)
            for (int k = 0; k < order_w - 1; ++k)
                sum += lattice_between(first, vec3(bu.at[i], bv.at[j], bw.at[k])) *
                       (bu.weight[i] * bv.weight[j] * bw.weight[k]);
    return sum;
}

// Section 4.3: the normal by differences. Two more points are deformed, volume.difference_step from
// the first in the plane of the normal, which leaves errors of a good part of a degree.
struct NormalPlane {
    vec3 along, across; // right-handed with the normal
};

NormalPlane plane_of(vec3 normal)
{
    vec3 axis = abs(normal.x) < 0.5f ? vec3(1.0f, 0.0f, 0.0f) : vec3(0.0f, 1.0f, 0.0f);
    NormalPlane plane;
    plane.along = normalize(cross(axis, normal));
    plane.across = cross(normal, plane.along);
    return plane;
}

vec3 difference_normal(vec3 at, vec3 at_along, vec3 at_across)
{
    return normalize(cross(at_along - at, at_across - at));
}
