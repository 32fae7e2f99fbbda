// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplex/simplex_product.h"

// This file is compiled once for each instruction set, each time in a namespace of its own; the
// part under HWY_ONCE picks one when the program runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/simplex/simplex_product.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace trivar {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <int Rows>
void sum(std::span<const std::uint32_t> functions, const float* weights,
         std::span<const glm::vec4> displacements, EightPoints& out)
{
    const hn::CappedTag<float, 8> d;
    const std::size_t lanes = hn::Lanes(d);
    using Vec = hn::Vec<decltype(d)>;
    for (std::size_t part = 0; part < 8; part += lanes) {
        Vec acc[3 * Rows]; // NOLINT: registers go into no std::array
        for (Vec& each : acc) each = hn::Zero(d);
        const float* w = weights + part;
        for (const std::uint32_t f : functions) {
            const glm::vec4& by = displacements[f];
            const Vec x = hn::Set(d, by.x), y = hn::Set(d, by.y), z = hn::Set(d, by.z);
            for (int r = 0; r < Rows; ++r, w += 8) {
                const Vec weight = hn::LoadU(d, w);
                acc[3 * r] = hn::MulAdd(weight, x, acc[3 * r]);
                acc[3 * r + 1] = hn::MulAdd(weight, y, acc[3 * r + 1]);
                acc[3 * r + 2] = hn::MulAdd(weight, z, acc[3 * r + 2]);
            }
        }
        for (std::size_t i = 0; i < 3 * Rows; ++i) hn::StoreU(acc[i], d, out[i].data() + part);
    }
}

void product(std::span<const std::uint32_t> functions, const float* weights, int rows,
             std::span<const glm::vec4> displacements, EightPoints& out)
{
    if (rows == 1)
        sum<1>(functions, weights, displacements, out);
    else
        sum<4>(functions, weights, displacements, out);
}

} // namespace HWY_NAMESPACE
} // namespace trivar
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace trivar {

HWY_EXPORT(product);

EightPoints simplex_product(std::span<const std::uint32_t> functions, const float* weights,
                            int rows, std::span<const glm::vec4> displacements)
{
    EightPoints out;
    HWY_DYNAMIC_DISPATCH(product)(functions, weights, rows, displacements, out);
    return out;
}

} // namespace trivar
#endif
