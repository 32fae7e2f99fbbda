// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplex/precise_volume.h"

#include <cmath>

namespace trivar {
namespace {

// A Twofold is the sum of two doubles of which the second is at most half a unit of the first one's
// last digit.
struct Twofold {
    double high = 0, low = 0;
};

Twofold sum(double a, double b) // exact
{
    const double s = a + b, part = s - a;
    return {s, (a - (s - part)) + (b - part)};
}

Twofold operator+(const Twofold& a, const Twofold& b)
{
    const Twofold high = sum(a.high, b.high), low = sum(a.low, b.low);
    const Twofold all = sum(high.high, high.low + low.high);
    return sum(all.high, all.low + low.low);
}

Twofold operator-(const Twofold& a)
{
    return {-a.high, -a.low};
}

Twofold operator*(const Twofold& a, const Twofold& b)
{
    const double product = a.high * b.high;
    const double rest = std::fma(a.high, b.high, -product) + (a.high * b.low + a.low * b.high);
    return sum(product, rest);
}

template <int S> using Side = std::array<Twofold, S>;

template <int S> Side<S> edge(const glm::vec<S, double>& from, const glm::vec<S, double>& to)
{
    Side<S> out;
    for (int i = 0; i < S; ++i) out[static_cast<std::size_t>(i)] = sum(to[i], -from[i]);
    return out;
}

Twofold minor(const Twofold& a, const Twofold& b, const Twofold& c, const Twofold& d)
{
    return a * d + -(b * c);
}

double volume(const std::array<glm::dvec2, 3>& c)
{
    const Side<2> a = edge<2>(c[0], c[1]), b = edge<2>(c[0], c[2]);
    return minor(a[0], a[1], b[0], b[1]).high;
}

double volume(const std::array<glm::dvec3, 4>& at)
{
    const Side<3> a = edge<3>(at[0], at[1]), b = edge<3>(at[0], at[2]), c = edge<3>(at[0], at[3]);
    return (a[0] * minor(b[1], b[2], c[1], c[2]) + -(a[1] * minor(b[0], b[2], c[0], c[2])) +
            a[2] * minor(b[0], b[1], c[0], c[1]))
        .high;
}

} // namespace

double volume_ratio(const std::array<glm::dvec2, 3>& simplex,
                    const std::array<glm::dvec2, 3>& whole)
{
    return volume(simplex) / volume(whole);
}

double volume_ratio(const std::array<glm::dvec3, 4>& simplex,
                    const std::array<glm::dvec3, 4>& whole)
{
    return volume(simplex) / volume(whole);
}

} // namespace trivar
