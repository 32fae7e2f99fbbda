// One axis of a lattice.                        GLSL and C++: see core/kernel/volume_kernel.h
//
// A parameter x runs from -1/2 to 1/2 over the domain of the axis, so that single precision has as
// many digits at one end as at the other. The domain is cut in cells at the knots, with one more
// cell at each end for what lies beyond; in each the basis functions are polynomials in t, which
// runs from -1/2 to 1/2 over the cell. So all knots and all orders are one text, without divisions.
//
// Supplied: volume (VolumeFrame) and vec4 cell_row(int cell, int row), row 0..9 of a cell:
//   0      x where it begins, x of its middle, dt/dx, its first control point
//   1..4   of t^0..t^3 in the basis functions of the first to fourth control point
//   5..9   for raised.glsl

const int OPEN = 0, TWISTED = 2; // and 1: periodic

// Open axes: beyond the ends by more than this the displacement is that of the end, for good.
const float END_SLACK = 1e-6f;

// The cell that x lies in, counted over all axes. Not a number: in some cell.
int cell_at(int axis, float x)
{
    int low = volume.cell_begin[axis] + 1, high = low + volume.cell_count[axis] - 3;
    if (volume.closure[axis] == OPEN && x < -0.5f - END_SLACK) return low - 1;
    if (volume.closure[axis] == OPEN && x > 0.5f + END_SLACK) return high + 1;
    // Equally spaced knots, the usual case, are found without a search.
    int guess = low + int(floor((x + 0.5f) * float(high - low + 1)));
    guess = clamp(guess, low, high);
    if (cell_row(guess, 0).x <= x && x < cell_row(guess + 1, 0).x) return guess;
    while (low < high) {
        int middle = (low + high + 1) / 2;
        if (cell_row(middle, 0).x <= x)
            low = middle;
        else
            high = middle - 1;
    }
    return low;
}

// Basis functions that are not zero, and their derivatives by x. Those beyond the order are zero.
struct Basis {
    vec4 value, slope;
};

Basis basis_at(int cell, float t, int order)
{
    vec4 highest = cell_row(cell, order);
    Basis b;
    b.value = highest;
    b.slope = vec4(0.0f);
    for (int row = order - 1; row >= 1; --row) {
        b.slope = b.slope * t + b.value;
        b.value = b.value * t + cell_row(cell, row);
    }
    b.slope = b.slope * cell_row(cell, 0).z;
    return b;
}
