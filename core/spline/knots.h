// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

namespace trivar {

// A Closure is the kind of ends of an axis. Periodic: the control points repeat. Twisted: they
// repeat mirrored in the other axes, as round a Moebius band.
enum class Closure { open, periodic, twisted };

inline constexpr int max_order = 6;

// The knots of one axis. order = degree + 1, 2..6; `count` control points are stored.
// Open: count + order knots, domain [t[order-1], t[count]].
// Closed: the sequence is unwrapped, order - 1 control points longer, and index i stands for the
// stored point i mod count (see wrapped). Every constructor throws Rejected for orders
// outside 2..6, count < order (closed: count < order as well), decreasing or non-finite knots,
// multiplicity above order, or more than 2^20 control points.
class Knots {
public:
    // Clamped: `order` equal knots at each end, the interior equally spaced.
    static Knots uniform(int order, int count, double begin = 0, double end = 1);
    static Knots general(int order, std::vector<double> knots);
    // Closed, equally spaced.
    static Knots periodic(int order, int count, double begin = 0, double end = 1,
                          Closure closure = Closure::periodic);
    // Closed, with the knots of one period: begin <= t < end, one a control point.
    static Knots closed(int order, const std::vector<double>& one_period, double end,
                        Closure closure = Closure::periodic);

    int order() const { return order_; }
    int degree() const { return order_ - 1; }
    int count() const { return count_; }
    int unwrapped_count() const { return static_cast<int>(knots_.size()) - order_; }
    Closure closure() const { return closure_; }
    const std::vector<double>& values() const { return knots_; }
    double begin() const { return knots_[static_cast<std::size_t>(order_ - 1)]; }
    double end() const { return knots_[static_cast<std::size_t>(unwrapped_count())]; }

    // An InDomain is t brought into the domain: limited on an open axis, modulo the period on a
    // closed one. `odd` says that an odd number of periods was removed and the axis is twisted: the
    // other axes are mirrored there. A NaN stays a NaN.
    struct InDomain {
        double t;
        bool odd;
    };
    InDomain into_domain(double t) const;

    // The s with values()[s] <= t < values()[s+1]; at the end of the domain the last non-empty
    // span. t must lie in the domain. O(log count).
    int span(double t) const;

    // Greville abscissa of unwrapped control point i: the mean of values()[i+1 .. i+order-1].
    double greville(int i) const;

    // Stored index of unwrapped control point i, and whether the other axes are mirrored there.
    struct WrappedIndex {
        int index;
        bool mirrored;
    };
    WrappedIndex wrapped(int i) const
    {
        if (closure_ == Closure::open) return {i, false};
        return {i % count_, closure_ == Closure::twisted && (i / count_) % 2 == 1};
    }

    // The number of times that t stands in values().
    int multiplicity(double t) const;

    // The parameters where non-empty spans start, and the end of the domain: ascending, distinct.
    std::vector<double> breaks() const;

    bool operator==(const Knots&) const = default;

private:
    Knots(int order, int count, Closure closure, std::vector<double> knots);
    int order_, count_;
    Closure closure_;
    std::vector<double> knots_;
};

// The `order` basis functions that are not zero at t, and their derivatives, for unwrapped control
// points first .. first + order - 1. Derivatives above the degree are zero.
// de Boor 1972; Piegl and Tiller, The NURBS Book, A2.2 and A2.3.
struct Basis {
    int first = 0;
    std::array<double, max_order> value{}, first_derivative{}, second_derivative{};
};
Basis basis(const Knots& knots, double t, int derivatives = 0);

} // namespace trivar
