// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/silhouette/polish.h"

#include <cmath>

namespace trivar {
namespace {

constexpr int most_polishing_steps = 8;
constexpr double longest_step = 0.5, longest_way = 1; // voxels
constexpr double touching = 1e-6;                     // squared sine between the two gradients
constexpr double is_quadratic = 0.02; // a step from which the next one is its square

} // namespace

template <class Real>
bool polish(const ScalarField<Real>& field, Real level, const ViewPoint& view, glm::vec<3, Real>& p,
            ScalarJet<Real>& jet, Real tolerance)
{
    using Vec = glm::vec<3, Real>;
    const Vec begin = p, end(field.size() - 1);
    for (int step = 0; step < most_polishing_steps; ++step) {
        jet = field.template at<2>(p);
        const Vec sight(view.sight(glm::dvec3(p))), a = gradient_of(jet);
        const Vec b = hessian_of(jet) * sight + static_cast<Real>(view.at.w) * a;
        const Real f = jet.value - level, g = glm::dot(a, sight);
        const Real aa = glm::dot(a, a), ab = glm::dot(a, b), bb = glm::dot(b, b),
                   det = aa * bb - ab * ab;
        if (!(det > static_cast<Real>(touching) * aa * bb)) return false;
        const Vec move = -((bb * f - ab * g) / det) * a - ((aa * g - ab * f) / det) * b;
        const Real length = glm::length(move);
        p += length > static_cast<Real>(longest_step)
                 ? move * (static_cast<Real>(longest_step) / length)
                 : move;
        for (int k = 0; k < 3; ++k)
            if (!(p[k] >= 0 && p[k] <= end[k])) return false;
        if (glm::distance(p, begin) > static_cast<Real>(longest_way)) return false;
        if (length < tolerance) return true;
        if (step > 0 && length < static_cast<Real>(is_quadratic) && length * length < tolerance)
            return true;
    }
    return false;
}

template bool polish(const ScalarField<float>&, float, const ViewPoint&, glm::vec3&,
                     ScalarJet<float>&, float);
template bool polish(const ScalarField<double>&, double, const ViewPoint&, glm::dvec3&,
                     ScalarJet<double>&, double);

void finish(const ScalarField<float>& field, float level, const ViewPoint& view, bool polished,
            SilhouettePoint& point)
{
    ScalarJet<float> jet;
    glm::vec3 p = point.p;
    point.polished = polished && polish(field, level, view, p, jet);
    if (point.polished)
        point.p = p;
    else
        jet = field.at<2>(point.p);
    const glm::vec3 sight(view.sight(glm::dvec3(point.p)));
    point.slope = glm::length(gradient_of(jet));
    const float scale = glm::dot(sight, sight) * (point.slope > 0 ? point.slope : 1);
    point.bend = scale > 0 ? glm::dot(sight, hessian_of(jet) * sight) / scale : 0;
}

} // namespace trivar
