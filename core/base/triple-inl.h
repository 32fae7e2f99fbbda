// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors of three registers, for kernels that are compiled once for each instruction set. It is
// read once for each of them, which this guard allows (Highway's pattern for such headers), and
// after hwy/highway.h.
#if defined(TRIVAR_BASE_TRIPLE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIVAR_BASE_TRIPLE_INL
#undef TRIVAR_BASE_TRIPLE_INL
#else
#define TRIVAR_BASE_TRIPLE_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace trivar {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::ScalableTag<float>;
using Vec = hn::Vec<Tag>;

// A Triple holds as many points as a register has numbers.
struct Triple {
    Vec x, y, z;
};

HWY_INLINE Vec dot(const Triple& a, const Triple& b)
{
    return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}

HWY_INLINE Triple cross(const Triple& a, const Triple& b)
{
    return {hn::MulSub(a.y, b.z, hn::Mul(a.z, b.y)), hn::MulSub(a.z, b.x, hn::Mul(a.x, b.z)),
            hn::MulSub(a.x, b.y, hn::Mul(a.y, b.x))};
}

// Sums x a + y b + z c.
HWY_INLINE Triple combine(const Triple& a, Vec x, const Triple& b, Vec y, const Triple& c, Vec z)
{
    const auto sum = [&](Vec p, Vec q, Vec r)
                         HWY_ATTR { return hn::MulAdd(p, x, hn::MulAdd(q, y, hn::Mul(r, z))); };
    return {sum(a.x, b.x, c.x), sum(a.y, b.y, c.y), sum(a.z, b.z, c.z)};
}

} // namespace HWY_NAMESPACE
} // namespace trivar
HWY_AFTER_NAMESPACE();

#endif
