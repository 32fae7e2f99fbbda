// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spline/fit.h"

#include "core/base/rejected.h"

#include <cmath>

namespace trivar {
namespace {

template <class Point>
std::vector<double> lengths(std::span<const Point> points, double begin, double end,
                            double exponent)
{
    std::vector<double> out;
    double length = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i > 0) length += std::pow(glm::distance(points[i - 1], points[i]), exponent);
        out.push_back(length);
    }
    if (!(length > 0 && std::isfinite(length)))
        throw Rejected("the samples lie all in one place, or one is not a number");
    for (double& t : out) t = t == length ? end : begin + (end - begin) * (t / length);
    return out;
}

} // namespace

std::vector<double> chord_length_parameters(std::span<const glm::dvec2> points, double begin,
                                            double end, double exponent)
{
    return lengths(points, begin, end, exponent);
}

std::vector<double> chord_length_parameters(std::span<const glm::dvec3> points, double begin,
                                            double end, double exponent)
{
    return lengths(points, begin, end, exponent);
}

std::vector<double> corrected_parameters(const Curve<glm::dvec2>& c, std::vector<double> parameters,
                                         std::span<const glm::dvec2> points)
{
    for (std::size_t s = 0; s < parameters.size(); ++s) {
        const CurveJet<glm::dvec2> jet = evaluate(c, parameters[s], 2);
        const glm::dvec2 off = points[s] - jet.value;
        const double curvature = glm::dot(jet.first, jet.first) - glm::dot(off, jet.second);
        if (!(curvature > 0)) continue;
        const double t = parameters[s] + glm::dot(off, jet.first) / curvature;
        parameters[s] = c.knots.into_domain(t).t;
    }
    return parameters;
}

} // namespace trivar
