// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/foot_lock.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

glm::dvec3 origin(const Stance& stance, int node)
{
    return glm::dvec3(stance.to_model[static_cast<std::size_t>(node)][3]);
}

// What is added to a foot.
glm::dvec3 shift_at(const Gait& gait, const Foot& foot, double time_s)
{
    const double t = (time_s - gait.begin_s) / gait.period_s - foot.begin;
    const auto count = foot.shift.size();
    const double step = (t - std::floor(t)) * static_cast<double>(count);
    const auto i = std::min(static_cast<std::size_t>(step), count - 1);
    return glm::mix(foot.shift[i], foot.shift[(i + 1) % count], step - static_cast<double>(i));
}

// The middle of its sole.
glm::dvec3 sole_at(const Model& model, const Foot& foot, const Stance& stance)
{
    glm::dvec3 sum(0);
    for (const glm::dvec3& p : positions_of(model, foot.sole, stance)) sum += p;
    return sum / static_cast<double>(foot.sole.size());
}

// p moves by (a + b . p) d.
struct Shear {
    double a = 1;
    glm::dvec3 b{0};
    glm::dmat4 matrix(const glm::dvec3& d) const
    {
        glm::dmat4 out(1);
        for (int column = 0; column < 3; ++column) out[column] += glm::dvec4(d * b[column], 0);
        out[3] += glm::dvec4(d * a, 0);
        return out;
    }
};

// Of the nodes of a leg: each as much as its own joint at that joint, as the next at the next.
std::vector<Shear> shears(const Foot& foot, const Stance& stance)
{
    std::vector<double> length{0};
    for (std::size_t i = 1; i < foot.leg.size(); ++i)
        length.push_back(length.back() + glm::distance(origin(stance, foot.leg[i - 1]),
                                                       origin(stance, foot.leg[i])));
    std::vector<Shear> out(foot.leg.size());
    const double whole = length.back();
    for (std::size_t i = 0; whole > 0 && i + 1 < foot.leg.size(); ++i) {
        const glm::dvec3 o = origin(stance, foot.leg[i]), e = origin(stance, foot.leg[i + 1]) - o;
        out[i].a = length[i] / whole;
        if (const double square = glm::dot(e, e); square > 0) {
            out[i].b = (length[i + 1] - length[i]) / whole / square * e;
            out[i].a -= glm::dot(out[i].b, o);
        }
    }
    return out;
}

Stance moved(const Model& model, Stance stance, const Foot& foot, const glm::dvec3& d)
{
    const std::vector<Shear> shear = shears(foot, stance);
    std::vector<int> by(model.nodes.size(), -1); // which shear moves a node
    for (std::size_t i = 0; i < foot.leg.size(); ++i)
        by[static_cast<std::size_t>(foot.leg[i])] = static_cast<int>(i);
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        if (by[n] < 0 && model.nodes[n].parent >= 0)
            by[n] = by[static_cast<std::size_t>(model.nodes[n].parent)];
        if (by[n] >= 0)
            stance.to_model[n] =
                shear[static_cast<std::size_t>(by[n])].matrix(d) * stance.to_model[n];
    }
    return stance;
}

} // namespace

double share_of_sole(const Model& model, const Foot& foot, const Stance& stance)
{
    const Stance by_one = moved(model, stance, foot, {1, 0, 0});
    return sole_at(model, foot, by_one).x - sole_at(model, foot, stance).x;
}

Stance planted(const Model& model, const Clip& clip, const Gait& gait, double time_s)
{
    Stance out = stance_at(model, &clip, time_s);
    if (!gait.trouble.empty()) return out;
    for (const Foot& foot : gait.feet) {
        if (foot.leg.empty()) continue;
        const glm::dvec3 d = shift_at(gait, foot, time_s);
        if (d == glm::dvec3(0)) continue;
        const double share = share_of_sole(model, foot, out);
        out = moved(model, std::move(out), foot, share > least_share_of_sole ? d / share : d);
    }
    return out;
}

double largest_correction(const Gait& gait)
{
    double most = 0;
    for (const Foot& foot : gait.feet)
        if (!foot.leg.empty())
            for (const glm::dvec3& each : foot.shift) most = std::max(most, glm::length(each));
    return gait.stride > 0 ? most / gait.stride : 0;
}

} // namespace trivar
