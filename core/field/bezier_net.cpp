// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/field/bezier_net.h"

#include <algorithm>

namespace trivar {
namespace {

using Row = Row4<float>;
using Four = std::array<Row, 4>;

Four turned(const Four& r)
{
    const Row p = __builtin_shufflevector(r[0], r[1], 0, 4, 1, 5),
              q = __builtin_shufflevector(r[0], r[1], 2, 6, 3, 7),
              s = __builtin_shufflevector(r[2], r[3], 0, 4, 1, 5),
              t = __builtin_shufflevector(r[2], r[3], 2, 6, 3, 7);
    return {__builtin_shufflevector(p, s, 0, 1, 4, 5), __builtin_shufflevector(p, s, 2, 3, 6, 7),
            __builtin_shufflevector(q, t, 0, 1, 4, 5), __builtin_shufflevector(q, t, 2, 3, 6, 7)};
}

// The four lines of a net along an axis that are number i of four, side by side.
struct Lines {
    Lines(int axis, std::size_t i)
        : first(axis == 2 ? i : 4 * i),
          step(axis == 2 ? 4 : 1),
          turns(axis == 0)
    {
    }
    Four of(const BezierNet& net) const
    {
        const Four rows{net.rows[first], net.rows[first + step], net.rows[first + 2 * step],
                        net.rows[first + 3 * step]};
        return turns ? turned(rows) : rows;
    }
    void put(const Four& lines, BezierNet& net) const
    {
        const Four rows = turns ? turned(lines) : lines;
        for (std::size_t k = 0; k < 4; ++k) net.rows[first + k * step] = rows[k];
    }

    std::size_t first, step;
    bool turns;
};

} // namespace

bool BezierNet::may_vanish(float margin) const
{
    Row least = rows[0], greatest = rows[0];
    for (const Row& row : rows) {
        least = row < least ? row : least;
        greatest = row > greatest ? row : greatest;
    }
    return std::min({least[0], least[1], least[2], least[3]}) <= margin &&
           std::max({greatest[0], greatest[1], greatest[2], greatest[3]}) >= -margin;
}

void make_bezier(BezierNet& net)
{
    constexpr float sixth = 1.0f / 6, third = 1.0f / 3;
    for (int axis = 0; axis < 3; ++axis)
        for (std::size_t i = 0; i < 4; ++i) {
            const Lines lines(axis, i);
            const Four c = lines.of(net);
            lines.put({sixth * (c[0] + 4.0f * c[1] + c[2]), third * (2.0f * c[1] + c[2]),
                       third * (c[1] + 2.0f * c[2]), sixth * (c[1] + 4.0f * c[2] + c[3])},
                      net);
        }
}

BezierNet sight_net(const BezierNet& f, const glm::vec3& from, Sight sight)
{
    constexpr float third = 1.0f / 3;
    BezierNet out{};
    for (int axis = 0; axis < 3; ++axis)
        for (std::size_t i = 0; i < 4; ++i) {
            const Lines lines(axis, i);
            const Four a = lines.of(f);
            const Row p = 3.0f * (a[1] - a[0]), q = 3.0f * (a[2] - a[1]), r = 3.0f * (a[3] - a[2]);
            const float s = from[axis], place = sight == Sight::from_eye ? 1.0f : 0.0f;
            // The slope, of degree 2, raised; and times the place, with the coefficients 0 and 1.
            const Four part{s * p, s * third * (p + 2.0f * q) + place * third * p,
                            s * third * (2.0f * q + r) + 2.0f * place * third * q,
                            s * r + place * r};
            Four sum = lines.of(out);
            for (std::size_t k = 0; k < 4; ++k) sum[k] += part[k];
            lines.put(sum, out);
        }
    return out;
}

void halve(const BezierNet& net, int axis, BezierNet& lower, BezierNet& upper)
{
    for (std::size_t i = 0; i < 4; ++i) {
        const Lines lines(axis, i);
        const Four c = lines.of(net);
        const Row ab = 0.5f * (c[0] + c[1]), bc = 0.5f * (c[1] + c[2]), cd = 0.5f * (c[2] + c[3]),
                  abc = 0.5f * (ab + bc), bcd = 0.5f * (bc + cd), middle = 0.5f * (abc + bcd);
        lines.put({c[0], ab, abc, middle}, lower);
        lines.put({middle, bcd, cd, c[3]}, upper);
    }
}

} // namespace trivar
