// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/sharp.h"

#include <cmath>

namespace trivar {
namespace {

constexpr int newton_steps = 2, gradient_steps = 40;
constexpr double stay_put = 1e-3; // weight of not moving, relative to the weight 1 of each point

// A Pull says how control points move the surface at points of the scene toward the eye.
struct Pull {
    std::vector<std::size_t> first; // index of each point's first weight, and the end
    std::vector<std::size_t> control;
    std::vector<double> weight;

    std::vector<double> moved(const std::vector<double>& by) const
    {
        std::vector<double> out(first.size() - 1, 0);
        for (std::size_t f = 0; f < out.size(); ++f)
            for (std::size_t n = first[f]; n < first[f + 1]; ++n)
                out[f] += weight[n] * by[control[n]];
        return out;
    }
    std::vector<double> pulled(const std::vector<double>& at, std::size_t count) const
    {
        std::vector<double> out(count, 0);
        for (std::size_t f = 0; f < at.size(); ++f)
            for (std::size_t n = first[f]; n < first[f + 1]; ++n)
                out[control[n]] += weight[n] * at[f];
        return out;
    }
};

double dot(const std::vector<double>& a, const std::vector<double>& b)
{
    double sum = 0;
    for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
    return sum;
}

// Finds the moves x that minimize |B x - wanted|^2 + stay_put |x|^2 by conjugate gradients.
std::vector<double> least_moves(const Pull& pull, const std::vector<double>& wanted,
                                std::size_t count)
{
    std::vector<double> x(count, 0), r = pull.pulled(wanted, count), d = r;
    double squares = dot(r, r);
    const double enough = 1e-20 * squares;
    for (int step = 0; step < gradient_steps && squares > enough; ++step) {
        std::vector<double> q = pull.pulled(pull.moved(d), count);
        for (std::size_t k = 0; k < count; ++k) q[k] += stay_put * d[k];
        const double by = squares / dot(d, q);
        for (std::size_t k = 0; k < count; ++k) {
            x[k] += by * d[k];
            r[k] -= by * q[k];
        }
        const double now = dot(r, r);
        for (std::size_t k = 0; k < count; ++k) d[k] = r[k] + now / squares * d[k];
        squares = now;
    }
    return x;
}

} // namespace

Surface<glm::dvec3> drawn_to(Surface<glm::dvec3> contact, const View& view,
                             const std::vector<SceneSample>& features, double clearance)
{
    std::vector<SceneSample> samples = features;
    const SurfaceTable table(contact);
    for (int step = 0; step < newton_steps; ++step) {
        const std::vector<Gap> at = gaps(table, view, samples);
        Pull pull{{0}, {}, {}};
        std::vector<double> wanted;
        for (const Gap& g : at) {
            if (!g.inside) continue;
            table.each_weight(g.uv, [&](std::size_t k, double weight) {
                pull.control.push_back(k);
                pull.weight.push_back(weight);
            });
            pull.first.push_back(pull.control.size());
            wanted.push_back(clearance - g.gap);
        }
        if (wanted.empty()) return contact;
        const std::vector<double> moves = least_moves(pull, wanted, contact.points.size());
        for (std::size_t k = 0; k < moves.size(); ++k)
            contact.points[k] += moves[k] * view.toward_eye(contact.points[k]);
    }
    return contact;
}

} // namespace trivar
