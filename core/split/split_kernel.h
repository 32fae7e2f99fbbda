// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace trivar {

// A kernel says how the opening of a split fades from the cut surface (x = 0: 1) to its reach (x =
// 1: 0). All are even, once continuously differentiable and never grow with |x|.
enum class SplitKernel {
    quadratic, // quadratic B-spline
    smooth,    // (1 - x^2)^2
    gaussian,  // exp(-2 x^2) (1 - x^2)^2
    hat,       // 1 - |x| with rounded corners: needs the least reach
};

struct KernelValue {
    double value = 0, first = 0; // and the derivative by x
};
KernelValue kernel_at(SplitKernel kernel, double x);

double steepest(SplitKernel kernel);  // nowhere less than |first derivative|
double most_bent(SplitKernel kernel); // nowhere less than |second derivative|

// Bounds of the value and of the absolute derivatives over an interval of x >= 0.
struct KernelBound {
    double value, first, second;
};
KernelBound kernel_bound(SplitKernel kernel, double from, double to);

} // namespace trivar
