// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/patches/tile_kernel.h"

#include "core/patches/pinch.h"

#include <algorithm>

// This file is compiled once for each instruction set, each time in a namespace of its own; the
// part under HWY_ONCE picks one when the program runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/patches/tile_kernel.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "core/base/triple-inl.h"

HWY_BEFORE_NAMESPACE();
namespace trivar {
namespace HWY_NAMESPACE {

HWY_INLINE Vec at(const std::vector<float>& values, std::size_t i)
{
    return hn::LoadU(Tag(), values.data() + i);
}

// v / |v|, or up where v is zero or not a number.
HWY_INLINE Triple unit_or_up(const Triple& v)
{
    const Tag d;
    const Vec square = dot(v, v), one = hn::Set(d, 1.0f);
    const auto good = hn::Gt(square, hn::Set(d, 1e-36f));
    const Vec inverse = hn::IfThenElseZero(good, hn::Div(one, hn::Sqrt(square)));
    return {hn::IfThenElseZero(good, hn::Mul(v.x, inverse)),
            hn::IfThenElseZero(good, hn::Mul(v.y, inverse)),
            hn::IfThenElse(good, hn::Mul(v.z, inverse), one)};
}

// One component of P' or N' with its derivatives. `d2` and `d3` are its coefficients of x^2 and
// x^3, times 2 and 3.
struct Component {
    std::array<float, 16> c;
    std::array<float, 4> d2, d3;
};

struct Jet {
    Vec value, x, y;
};

HWY_INLINE Jet jet(const Component& of, Vec x, Vec y)
{
    const Tag d;
    const auto set = [&](float value) HWY_ATTR { return hn::Set(d, value); };
    Vec p[4], e[4];
    HWY_UNROLL(4)
    for (std::size_t j = 0; j < 4; ++j) {
        const float* c = of.c.data() + 4 * j;
        const Vec c1 = set(c[1]);
        p[j] = hn::MulAdd(hn::MulAdd(hn::MulAdd(set(c[3]), x, set(c[2])), x, c1), x, set(c[0]));
        e[j] = hn::MulAdd(hn::MulAdd(set(of.d3[j]), x, set(of.d2[j])), x, c1);
    }
    const Vec two = set(2), three = set(3);
    return {hn::MulAdd(hn::MulAdd(hn::MulAdd(p[3], y, p[2]), y, p[1]), y, p[0]),
            hn::MulAdd(hn::MulAdd(hn::MulAdd(e[3], y, e[2]), y, e[1]), y, e[0]),
            hn::MulAdd(hn::MulAdd(hn::Mul(three, p[3]), y, hn::Mul(two, p[2])), y, p[1])};
}

struct Tile {
    std::array<Component, 6> components;
    float scale;
    glm::vec3 offset;
};

HWY_INLINE Tile prepared(const TilePowers& powers, const glm::vec3& offset)
{
    Tile out{{}, powers.scale, offset};
    for (std::size_t k = 0; k < 6; ++k) {
        Component& to = out.components[k];
        to.c = powers.c[k];
        for (std::size_t j = 0; j < 4; ++j) {
            to.d2[j] = 2 * to.c[4 * j + 2];
            to.d3[j] = 3 * to.c[4 * j + 3];
        }
    }
    return out;
}

// T' with its derivatives.
struct BentPoint {
    Triple p, x, y, z;
};

HWY_INLINE BentPoint bent_point(const Tile& tile, Vec x, Vec y, Vec z)
{
    Vec t[3], a[3], b[3], c[3];
    HWY_UNROLL(3)
    for (std::size_t k = 0; k < 3; ++k) {
        const Jet p = jet(tile.components[k], x, y), n = jet(tile.components[k + 3], x, y);
        t[k] = hn::MulAdd(z, n.value, p.value);
        a[k] = hn::MulAdd(z, n.x, p.x);
        b[k] = hn::MulAdd(z, n.y, p.y);
        c[k] = n.value;
    }
    return {{t[0], t[1], t[2]}, {a[0], a[1], a[2]}, {b[0], b[1], b[2]}, {c[0], c[1], c[2]}};
}

HWY_INLINE Triple where(hn::Mask<Tag> chosen, const Triple& one, const Triple& other)
{
    return {hn::IfThenElse(chosen, one.x, other.x), hn::IfThenElse(chosen, one.y, other.y),
            hn::IfThenElse(chosen, one.z, other.z)};
}

// The vertices of one register from `i` on, to arrays that have room for all of it.
HWY_INLINE void bend_register(const TileVertices& vertices, const Tile& tile, std::size_t i,
                              float* positions, float* normals, float* tangents)
{
    const Tag d;
    const Vec x = at(vertices.position[0], i), y = at(vertices.position[1], i),
              z = at(vertices.position[2], i);
    const BentPoint there = bent_point(tile, x, y, z);
    const Vec scale = hn::Set(d, tile.scale);
    hn::StoreInterleaved3(hn::MulAdd(scale, there.p.x, hn::Set(d, tile.offset.x)),
                          hn::MulAdd(scale, there.p.y, hn::Set(d, tile.offset.y)),
                          hn::MulAdd(scale, there.p.z, hn::Set(d, tile.offset.z)), d, positions);
    Triple by_x = there.x, by_y = there.y, by_z = there.z;
    const Vec xx = dot(by_x, by_x), yy = dot(by_y, by_y);
    const auto none =
        hn::Lt(hn::Min(xx, yy), hn::Mul(hn::Set(d, pinched * pinched), hn::Max(xx, yy)));
    if (!hn::AllFalse(d, none)) { // a side of the patch has no length there
        const Vec share = hn::Set(d, pinch_inside), half = hn::Set(d, 0.5f);
        const BentPoint inside = bent_point(tile, hn::MulAdd(share, hn::Sub(half, x), x),
                                            hn::MulAdd(share, hn::Sub(half, y), y), z);
        by_x = where(none, inside.x, by_x);
        by_y = where(none, inside.y, by_y);
        by_z = where(none, inside.z, by_z);
    }
    if (normals != nullptr) {
        const Triple n = unit_or_up(combine(cross(by_y, by_z), at(vertices.normal[0], i),
                                            cross(by_z, by_x), at(vertices.normal[1], i),
                                            cross(by_x, by_y), at(vertices.normal[2], i)));
        hn::StoreInterleaved3(n.x, n.y, n.z, d, normals);
    }
    if (tangents != nullptr) {
        const Triple along =
            unit_or_up(combine(by_x, at(vertices.tangent[0], i), by_y, at(vertices.tangent[1], i),
                               by_z, at(vertices.tangent[2], i)));
        hn::StoreInterleaved4(along.x, along.y, along.z, at(vertices.tangent[3], i), d, tangents);
    }
}

void bend_vertices_on_target(const TileVertices& vertices, const TilePowers& powers,
                             const glm::vec3& offset, const BentVertices& out)
{
    constexpr std::size_t most = hn::MaxLanes(Tag());
    static_assert(most <= TileVertices::slack);
    const std::size_t lanes = hn::Lanes(Tag());
    const Tile tile = prepared(powers, offset);
    const bool normals = out.normals != nullptr, tangents = out.tangents != nullptr;
    std::size_t i = 0;
    for (; i + lanes <= vertices.count; i += lanes)
        bend_register(vertices, tile, i, &out.positions[i].x, normals ? &out.normals[i].x : nullptr,
                      tangents ? &out.tangents[i].x : nullptr);
    if (i == vertices.count) return;
    // The next tile may be written by another thread meanwhile.
    std::array<glm::vec3, most> last_positions, last_normals;
    std::array<glm::vec4, most> last_tangents;
    bend_register(vertices, tile, i, &last_positions[0].x, normals ? &last_normals[0].x : nullptr,
                  tangents ? &last_tangents[0].x : nullptr);
    const auto count = static_cast<std::ptrdiff_t>(vertices.count - i);
    std::copy_n(last_positions.begin(), count, out.positions + i);
    if (normals) std::copy_n(last_normals.begin(), count, out.normals + i);
    if (tangents) std::copy_n(last_tangents.begin(), count, out.tangents + i);
}

} // namespace HWY_NAMESPACE
} // namespace trivar
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace trivar {

HWY_EXPORT(bend_vertices_on_target);

void bend_vertices(const TileVertices& vertices, const TilePowers& tile, const glm::vec3& offset,
                   const BentVertices& out)
{
    HWY_DYNAMIC_DISPATCH(bend_vertices_on_target)(vertices, tile, offset, out);
}

} // namespace trivar
#endif
