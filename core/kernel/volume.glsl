// A tensor-product B-spline of displacements.   GLSL and C++: see core/kernel/volume_kernel.h
//
//   D(x) = sum_ijk N_i(x_u) N_j(x_v) N_k(x_w) D_ijk
//
// Supplied: what axis.glsl asks for, const int order_u, order_v, order_w, and
// vec3 lattice_point(int at), control points by unwrapped index: closed axes are laid out in length,
// the last axis fastest, volume.stride[0] and [1] apart on the other two.

// Where a point lies.
struct Spot {
    ivec3 cell;
    vec3 t;     // in the cells, -1/2..1/2
    vec3 sense; // -1 where an axis runs backwards there
};

// x may be anything: open axes end, closed ones go round, and round a twisted one an odd number of
// times the other axes run backwards.
Spot spot_at(vec3 x)
{
    Spot spot;
    spot.sense = vec3(1.0f);
    for (int axis = 0; axis < 3; ++axis) {
        if (volume.closure[axis] == OPEN) continue;
        float turns = floor(x[axis] + 0.5f);
        x[axis] -= turns;
        if (volume.closure[axis] != TWISTED || turns == 2.0f * floor(turns * 0.5f)) continue;
        vec3 back = vec3(-1.0f);
        back[axis] = 1.0f;
        x *= back;
        spot.sense *= back;
    }
    for (int axis = 0; axis < 3; ++axis) {
        // An axis that was turned round may end at its other end.
        if (volume.closure[axis] != OPEN) x[axis] -= floor(x[axis] + 0.5f);
        spot.cell[axis] = cell_at(axis, x[axis]);
        vec4 head = cell_row(spot.cell[axis], 0);
        spot.t[axis] = clamp((x[axis] - head.y) * head.z, -0.5f, 0.5f);
    }
    return spot;
}

// The control point of lowest index among those that matter at a spot.
int first_point(Spot spot)
{
    return int(cell_row(spot.cell.x, 0).w) * volume.stride[0] +
           int(cell_row(spot.cell.y, 0).w) * volume.stride[1] + int(cell_row(spot.cell.z, 0).w);
}

// D and its derivatives by x.
struct Jet {
    vec3 value, by_u, by_v, by_w;
};

// Contracted over w, then v, then u: 192 multiply-adds a coordinate for a tri-cubic. Derivatives
// that are not used cost nothing: compilers drop them.
Jet jet_at(Spot spot)
{
    Basis bu = basis_at(spot.cell.x, spot.t.x, order_u);
    Basis bv = basis_at(spot.cell.y, spot.t.y, order_v);
    Basis bw = basis_at(spot.cell.z, spot.t.z, order_w);
    int first = first_point(spot);
    Jet jet;
    jet.value = vec3(0.0f);
    jet.by_u = vec3(0.0f);
    jet.by_v = vec3(0.0f);
    jet.by_w = vec3(0.0f);
    for (int i = 0; i < order_u; ++i) {
        vec3 plane = vec3(0.0f), plane_v = vec3(0.0f), plane_w = vec3(0.0f);
        for (int j = 0; j < order_v; ++j) {
            int row = first + i * volume.stride[0] + j * volume.stride[1];
            vec3 line = vec3(0.0f), line_w = vec3(0.0f);
            for (int k = 0; k < order_w; ++k) {
                vec3 point = lattice_point(row + k);
                line += point * bw.value[k];
                line_w += point * bw.slope[k];
            }
            plane += line * bv.value[j];
            plane_v += line * bv.slope[j];
            plane_w += line_w * bv.value[j];
        }
        jet.value += plane * bu.value[i];
        jet.by_u += plane * bu.slope[i];
        jet.by_v += plane_v * bu.value[i];
        jet.by_w += plane_w * bu.value[i];
    }
    jet.by_u *= spot.sense.x;
    jet.by_v *= spot.sense.y;
    jet.by_w *= spot.sense.z;
    return jet;
}
