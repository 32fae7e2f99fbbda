// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ffd/kernel.h"

#include <algorithm>

// This file is compiled once for each instruction set, each time in a namespace of its own; the
// part under HWY_ONCE picks one when the program runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/ffd/kernel.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "core/base/triple-inl.h"

HWY_BEFORE_NAMESPACE();
namespace trivar {
namespace HWY_NAMESPACE {

// Orders known at compile time; 0: the order of the lattice.
template <int U, int V, int W> struct Orders {
    std::array<int, 3> order;
    HWY_INLINE int u() const { return U > 0 ? U : order[0]; }
    HWY_INLINE int v() const { return V > 0 ? V : order[1]; }
    HWY_INLINE int w() const { return W > 0 ? W : order[2]; }
};

HWY_INLINE Triple load(const std::array<std::vector<float>, 3>& arrays, std::size_t i)
{
    const Tag d;
    return {hn::LoadU(d, arrays[0].data() + i), hn::LoadU(d, arrays[1].data() + i),
            hn::LoadU(d, arrays[2].data() + i)};
}

// Returns v / |v|, or zero if |v|^2 is not above `least`, as for NaN.
HWY_INLINE Triple unit(const Triple& v, Vec least)
{
    const Tag d;
    const Vec square = dot(v, v);
    const auto good = hn::Gt(square, least);
    const Vec inverse = hn::IfThenElseZero(good, hn::Div(hn::Set(d, 1.0f), hn::Sqrt(square)));
    const auto scaled = [&](Vec x)
                            HWY_ATTR { return hn::IfThenElseZero(good, hn::Mul(x, inverse)); };
    return {scaled(v.x), scaled(v.y), scaled(v.z)};
}

// Evaluates one component of the polynomial at N registers of t at once, by Horner's rule in w,
// then v, then u. Two registers share the load of a coefficient, which costs as much as a
// multiply-add.
template <std::size_t N, class O>
HWY_INLINE std::array<Vec, N> value(const O& o, const float* c, const std::array<Triple, N>& t)
{
    const Tag d;
    const int ou = o.u(), ov = o.v(), ow = o.w();
    std::array<Vec, N> p, q, r;
    p.fill(hn::Zero(d));
    q = r = p;
    HWY_UNROLL(4)
    for (int i = 0; i < ou; ++i) {
        HWY_UNROLL(4)
        for (int j = 0; j < ov; ++j) {
            for (Vec& x : r) x = hn::Set(d, *c);
            c += 4;
            HWY_UNROLL(4)
            for (int k = 1; k < ow; ++k, c += 4) {
                const Vec next = hn::Set(d, *c);
                for (std::size_t n = 0; n < N; ++n) r[n] = hn::MulAdd(r[n], t[n].z, next);
            }
            for (std::size_t n = 0; n < N; ++n)
                q[n] = j == 0 ? r[n] : hn::MulAdd(q[n], t[n].y, r[n]);
        }
        for (std::size_t n = 0; n < N; ++n) p[n] = i == 0 ? q[n] : hn::MulAdd(p[n], t[n].x, q[n]);
    }
    return p;
}

struct Jet1 {
    Vec value;
    Triple slope; // along the three axes of t
};

// Evaluates the same with derivatives: where p becomes p t + c, p' becomes p' t + p.
template <class O> HWY_INLINE Jet1 jet(const O& o, const float* c, const Triple& t)
{
    const Tag d;
    const Vec zero = hn::Zero(d);
    const int ou = o.u(), ov = o.v(), ow = o.w();
    Vec p = zero, pu = zero, pv = zero, pw = zero;
    HWY_UNROLL(4)
    for (int i = 0; i < ou; ++i) {
        Vec q = zero, qv = zero, qw = zero;
        HWY_UNROLL(4)
        for (int j = 0; j < ov; ++j) {
            Vec rw = hn::Set(d, c[0]);
            Vec r = hn::MulAdd(rw, t.z, hn::Set(d, c[4]));
            c += 8;
            HWY_UNROLL(4)
            for (int k = 2; k < ow; ++k, c += 4) {
                rw = hn::MulAdd(rw, t.z, r);
                r = hn::MulAdd(r, t.z, hn::Set(d, *c));
            }
            qv = j == 0 ? zero : j == 1 ? q : hn::MulAdd(qv, t.y, q);
            q = j == 0 ? r : hn::MulAdd(q, t.y, r);
            qw = j == 0 ? rw : hn::MulAdd(qw, t.y, rw);
        }
        pu = i == 0 ? zero : i == 1 ? p : hn::MulAdd(pu, t.x, p);
        p = i == 0 ? q : hn::MulAdd(p, t.x, q);
        pv = i == 0 ? qv : hn::MulAdd(pv, t.x, qv);
        pw = i == 0 ? qw : hn::MulAdd(pw, t.x, qw);
    }
    return {p, {pu, pv, pw}};
}

// Interleaves three registers into consecutive vec3. Lanes beyond the run are garbage that the next
// run overwrites.
HWY_INLINE void store(const Triple& v, glm::vec3* to)
{
    hn::StoreInterleaved3(v.x, v.y, v.z, Tag(), &to->x);
}

HWY_INLINE bool any_zero(const Triple& v, std::size_t count)
{
    const Tag d;
    const Vec zero = hn::Zero(d);
    const auto all = hn::And(hn::And(hn::Eq(v.x, zero), hn::Eq(v.y, zero)), hn::Eq(v.z, zero));
    return !hn::AllFalse(d, hn::And(all, hn::FirstN(d, count)));
}

// Returns a column of J: rest - slopes * t_by_p.
HWY_INLINE Triple column(const CellPolynomials::Frame& frame, std::size_t x, const Jet1& px,
                         const Jet1& py, const Jet1& pz)
{
    const Tag d;
    const Vec tu = hn::Set(d, frame.t_by_p[0][x]), tv = hn::Set(d, frame.t_by_p[1][x]),
              tw = hn::Set(d, frame.t_by_p[2][x]);
    const auto entry = [&](const Jet1& p, float rest) HWY_ATTR {
        return hn::NegMulAdd(
            p.slope.x, tu,
            hn::NegMulAdd(p.slope.y, tv, hn::NegMulAdd(p.slope.z, tw, hn::Set(d, rest))));
    };
    return {entry(px, frame.rest[0][x]), entry(py, frame.rest[1][x]), entry(pz, frame.rest[2][x])};
}

HWY_INLINE void store_position(const SortedVertices& vertices, std::size_t i, Vec x, Vec y, Vec z,
                               glm::vec3* to)
{
    const Triple rest = load(vertices.rest, i);
    store({hn::Sub(rest.x, x), hn::Sub(rest.y, y), hn::Sub(rest.z, z)}, to);
}

template <std::size_t N, class O>
HWY_INLINE void deform_registers(const O& o, const SortedVertices& vertices, std::size_t begin,
                                 const float* c, const ChunkResult& out)
{
    const std::size_t lanes = hn::Lanes(Tag());
    std::array<Triple, N> t;
    for (std::size_t n = 0; n < N; ++n) t[n] = load(vertices.t, begin + n * lanes);
    const auto x = value<N>(o, c, t), y = value<N>(o, c + 1, t), z = value<N>(o, c + 2, t);
    for (std::size_t n = 0; n < N; ++n)
        store_position(vertices, begin + n * lanes, x[n], y[n], z[n],
                       out.positions + (begin + n * lanes - out.begin));
}

template <class O>
void deform_positions(const O& o, const SortedVertices& vertices, const SortedVertices::Run& run,
                      const float* c, const ChunkResult& out)
{
    const std::size_t lanes = hn::Lanes(Tag());
    std::size_t i = run.begin;
    for (; i + lanes < run.end; i += 2 * lanes) deform_registers<2>(o, vertices, i, c, out);
    if (i < run.end) deform_registers<1>(o, vertices, i, c, out);
}

// A Jacobian holds the columns of J, from the slopes of the polynomial.
struct Jacobian {
    Triple a, b, c;
};

HWY_INLINE Jacobian jacobian(const CellPolynomials::Frame& frame, const Jet1& x, const Jet1& y,
                             const Jet1& z)
{
    return {column(frame, 0, x, y, z), column(frame, 1, x, y, z), column(frame, 2, x, y, z)};
}

HWY_INLINE Triple deformed_normal(const Jacobian& j, const Triple& n)
{
    // Where |cof(J) n| is below 3e-7 |J|^2, no digit of the normal is right in single precision.
    const Vec hopeless = hn::Set(Tag(), 1e-13f);
    const Vec size = hn::Add(dot(j.a, j.a), hn::Add(dot(j.b, j.b), dot(j.c, j.c)));
    return unit(combine(cross(j.b, j.c), n.x, cross(j.c, j.a), n.y, cross(j.a, j.b), n.z),
                hn::Mul(hn::Mul(hopeless, size), size));
}

HWY_INLINE Triple deformed_tangent(const Jacobian& j, const Triple& tangent, const Triple& normal)
{
    const Vec hopeless = hn::Set(Tag(), 1e-13f);
    const Triple along = combine(j.a, tangent.x, j.b, tangent.y, j.c, tangent.z);
    const Vec part = dot(along, normal);
    return unit({hn::NegMulAdd(part, normal.x, along.x), hn::NegMulAdd(part, normal.y, along.y),
                 hn::NegMulAdd(part, normal.z, along.z)},
                hn::Mul(hopeless, dot(along, along)));
}

template <class O>
bool deform_frames(const O& o, const SortedVertices& vertices, const SortedVertices::Run& run,
                   const float* c, const CellPolynomials::Frame& frame, const ChunkResult& out)
{
    const std::size_t lanes = hn::Lanes(Tag());
    bool missing = false;
    for (std::size_t i = run.begin; i < run.end; i += lanes) {
        const std::size_t count = std::min(lanes, run.end - i), to = i - out.begin;
        const Triple t = load(vertices.t, i);
        const Jet1 x = jet(o, c, t), y = jet(o, c + 1, t), z = jet(o, c + 2, t);
        store_position(vertices, i, x.value, y.value, z.value, out.positions + to);
        const Jacobian j = jacobian(frame, x, y, z);
        const Triple normal = deformed_normal(j, load(vertices.normal, i));
        missing |= any_zero(normal, count);
        store(normal, out.normals + to);
        if (out.tangents == nullptr) continue;
        const Triple tangent = deformed_tangent(j, load(vertices.tangent, i), normal);
        missing |= any_zero(tangent, count);
        store(tangent, out.tangents + to);
    }
    return missing;
}

void copy_frames(const SortedVertices& vertices, const SortedVertices::Run& run,
                 const ChunkResult& out)
{
    const std::size_t lanes = hn::Lanes(Tag());
    for (std::size_t i = run.begin; i < run.end; i += lanes) {
        store(load(vertices.normal, i), out.normals + (i - out.begin));
        if (out.tangents != nullptr)
            store(load(vertices.tangent, i), out.tangents + (i - out.begin));
    }
}

template <class O>
bool deform_runs(const O& o, const SortedVertices& vertices, std::size_t chunk,
                 const CellPolynomials& polynomials, const ChunkResult& out)
{
    bool missing = false;
    for (std::size_t r = vertices.chunk_begin[chunk]; r < vertices.chunk_begin[chunk + 1]; ++r) {
        const SortedVertices::Run& run = vertices.runs[r];
        const float* c = polynomials.coefficients.data() + run.cell * polynomials.stride();
        const CellPolynomials::Frame& frame = polynomials.frames[run.cell];
        if (out.normals != nullptr && !frame.still) {
            missing |= deform_frames(o, vertices, run, c, frame, out);
            continue;
        }
        deform_positions(o, vertices, run, c, out);
        if (out.normals != nullptr) copy_frames(vertices, run, out);
    }
    return missing;
}

bool deform_chunk_on_target(const SortedVertices& vertices, std::size_t chunk,
                            const CellPolynomials& polynomials, const ChunkResult& out)
{
    static_assert(hn::MaxLanes(Tag()) <= SortedVertices::slack);
    const std::array<int, 3>& order = polynomials.order;
    if (order == std::array{3, 3, 3})
        return deform_runs(Orders<3, 3, 3>{order}, vertices, chunk, polynomials, out);
    if (order == std::array{4, 4, 4})
        return deform_runs(Orders<4, 4, 4>{order}, vertices, chunk, polynomials, out);
    return deform_runs(Orders<0, 0, 0>{order}, vertices, chunk, polynomials, out);
}

} // namespace HWY_NAMESPACE
} // namespace trivar
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace trivar {

HWY_EXPORT(deform_chunk_on_target);

bool deform_chunk(const SortedVertices& vertices, std::size_t chunk,
                  const CellPolynomials& polynomials, const ChunkResult& out)
{
    return HWY_DYNAMIC_DISPATCH(deform_chunk_on_target)(vertices, chunk, polynomials, out);
}

} // namespace trivar
#endif
