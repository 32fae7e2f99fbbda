// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/split_kernel.h"

#include <cmath>

namespace trivar {
namespace {

constexpr double hat_slope = 1.1;
constexpr double hat_round = (hat_slope - 1) / hat_slope; // of its length, at either end

KernelValue hat_at(double x)
{
    if (x < hat_round) // parabolas that meet the straight part with its slope
        return {1 - hat_slope * x * x / (2 * hat_round), -hat_slope * x / hat_round};
    if (x > 1 - hat_round) {
        const double y = 1 - x;
        return {hat_slope * y * y / (2 * hat_round), -hat_slope * y / hat_round};
    }
    return {1 - hat_slope * (x - hat_round / 2), -hat_slope};
}

} // namespace

KernelValue kernel_at(SplitKernel kernel, double x)
{
    const double sign = x < 0 ? -1 : 1;
    x = std::abs(x);
    if (!(x < 1)) return {};
    KernelValue out;
    const double rest = 1 - x * x;
    switch (kernel) {
    case SplitKernel::quadratic:
        out = x <= 1.0 / 3 ? KernelValue{1 - 3 * x * x, -6 * x}
                           : KernelValue{1.5 * (1 - x) * (1 - x), -3 * (1 - x)};
        break;
    case SplitKernel::smooth: out = {rest * rest, -4 * x * rest}; break;
    case SplitKernel::gaussian: {
        const double bell = std::exp(-2 * x * x);
        out = {bell * rest * rest, -4 * x * rest * bell * (1 + rest)};
        break;
    }
    case SplitKernel::hat: out = hat_at(x); break;
    }
    out.first *= sign;
    return out;
}

double steepest(SplitKernel kernel)
{
    switch (kernel) {
    case SplitKernel::quadratic: return 2;
    case SplitKernel::smooth: return 1.5397; // 8 / (3 sqrt 3)
    case SplitKernel::gaussian: return 1.83;
    case SplitKernel::hat: return hat_slope;
    }
    return 2;
}

double most_bent(SplitKernel kernel)
{
    switch (kernel) {
    case SplitKernel::quadratic: return 6;
    case SplitKernel::smooth: return 8;
    case SplitKernel::gaussian: return 8;
    case SplitKernel::hat: return hat_slope / hat_round;
    }
    return 6;
}

KernelBound kernel_bound(SplitKernel kernel, double from, double to)
{
    if (from >= 1) return {0, 0, 0};
    if (kernel == SplitKernel::quadratic) { // whose slope grows up to 1/3 and falls beyond
        constexpr double knot = 1.0 / 3;
        const double left = 1 - from;
        if (from > knot) return {1.5 * left * left, 3 * left, 3};
        return {1 - 3 * from * from, to < knot ? 6 * to : 2, 6};
    }
    KernelBound out{kernel_at(kernel, from).value, steepest(kernel), most_bent(kernel)};
    if (kernel == SplitKernel::hat) {
        if (from > hat_round && to < 1 - hat_round) out.second = 0;
        if (to < hat_round) out.first = std::abs(kernel_at(kernel, to).first);
        if (from > 1 - hat_round) out.first = std::abs(kernel_at(kernel, from).first);
    }
    return out;
}

} // namespace trivar
