// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/curve.h"
#include "core/spline/insert.h"
#include "core/spline/surface.h"
#include "core/spline/trivariate.h"

#include <random>

namespace trivar::testing {

// Numbers in [-1, 1), the same on every machine.
class Noise {
public:
    explicit Noise(unsigned seed = 1) : engine_(seed) {}
    double operator()() { return static_cast<double>(engine_()) / 2147483648.0 - 1; }
    double between(double low, double high) { return low + (high - low) * ((*this)() + 1) / 2; }
    glm::dvec2 vec2() { return {(*this)(), (*this)()}; }
    glm::dvec3 vec3() { return {(*this)(), (*this)(), (*this)()}; }

private:
    std::mt19937 engine_;
};

// Clamped, unevenly spaced, with a double knot where the order allows one that stays continuous.
inline Knots uneven_knots(int order)
{
    std::vector<double> t(static_cast<std::size_t>(order), 0.0);
    for (const double k : {0.15, 0.4, 0.4, 0.55, 0.9})
        if (order > 2 || t.back() != k) t.push_back(k);
    t.insert(t.end(), static_cast<std::size_t>(order), 1.0);
    return Knots::general(order, t);
}

// An axis of each kind for every order.
inline std::vector<Knots> all_axes()
{
    std::vector<Knots> out;
    for (int order = 2; order <= max_order; ++order) {
        out.push_back(Knots::uniform(order, order + 4, -1, 2));
        out.push_back(uneven_knots(order));
        std::vector<double> t;
        for (int i = 0; i < 2 * order + 3; ++i) t.push_back(0.1 * i + 0.01 * (i % 3));
        out.push_back(Knots::general(order, t));
        out.push_back(Knots::periodic(order, order + 3, 0, 2));
        out.push_back(Knots::periodic(order, order + 3, 0, 2, Closure::twisted));
    }
    return out;
}

// Splines of random points, every coordinate in [-1, 1), or up to `size`.
template <class Point = glm::dvec3> Curve<Point> random_curve(const Knots& knots, unsigned seed = 1)
{
    Noise noise(seed);
    Curve<Point> c{knots, {}};
    for (int i = 0; i < knots.count(); ++i) {
        Point p(0);
        for (int a = 0; a < Point::length(); ++a) p[a] = noise();
        c.points.push_back(p);
    }
    return c;
}
inline Surface<glm::dvec3> random_surface(const std::array<Knots, 2>& axes, unsigned seed = 1)
{
    Noise noise(seed);
    Surface<glm::dvec3> s{axes, {}};
    for (int i = 0; i < axes[0].count() * axes[1].count(); ++i) s.points.push_back(noise.vec3());
    return s;
}
inline Trivariate<glm::dvec3> random_volume(const std::array<Knots, 3>& axes, unsigned seed = 1,
                                            double size = 1)
{
    Noise noise(seed);
    Trivariate<glm::dvec3> f{axes, {}};
    for (int i = 0; i < axes[0].count() * axes[1].count() * axes[2].count(); ++i)
        f.points.push_back(size * noise.vec3());
    return f;
}

// Equally spaced parameters, both ends of the domain among them.
inline std::vector<double> inside(const Knots& k, int count)
{
    std::vector<double> out;
    for (int i = 0; i < count; ++i)
        out.push_back(k.begin() + (k.end() - k.begin()) * i / (count - 1));
    return out;
}

// With one knot more.
template <class T> Curve<T> insert_knot(const Curve<T>& c, double t)
{
    return insert_knots(c, 0, std::span(&t, 1));
}

} // namespace trivar::testing
