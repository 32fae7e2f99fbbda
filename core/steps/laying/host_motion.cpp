// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/laying/host_motion.h"

#include "core/placement/attachment.h"

#include <algorithm>

namespace trivar {
namespace {

// Share of the lengths below which a motion cannot be told from rounding
constexpr double same = 1e-9;

// Says whether the places under the stroke have not moved in the space of the main host.
bool feet_unmoved(const StrokeHosts& stroke)
{
    Box own;
    for (std::size_t i = 0; i < stroke.feet.size(); ++i)
        if (stroke.is_on_main(i)) own.add(stroke.attachment.samples[i].drawn);
    const double slack =
        own.empty()
            ? 0
            : 10 * same * (glm::length(own.size()) + glm::length(own.lo) + glm::length(own.hi));
    for (std::size_t i = 0; i < stroke.feet.size(); ++i)
        if (stroke.is_on_main(i) && stroke.feet[i].now &&
            glm::distance(stroke.feet[i].now->p, stroke.attachment.samples[i].drawn) > slack)
            return false;
    return true;
}

// Finds the rotation and translation that best explain how the places under the stroke and their
// normals moved, in the space of the stroke; `from` takes that space to the world.
glm::dmat4 nearest_motion(const StrokeHosts& stroke, const glm::dmat4& from)
{
    const HostNow& main = stroke.main_host();
    const glm::dmat4 now_to_drawn = glm::inverse(from) * main.object->own_to_world;
    const glm::dmat3 normal_then = glm::transpose(glm::inverse(glm::dmat3(main.stood))),
                     normal_now = glm::transpose(glm::inverse(glm::dmat3(now_to_drawn)));
    const double reach = std::max(glm::length(stroke.drawn.size()) / 2, 1e-12);
    const auto out_by = [&](const glm::dvec3& normal) {
        const double length = glm::length(normal);
        return length > 0 ? normal * (reach / length) : glm::dvec3(0);
    };
    std::vector<glm::dvec3> a, b;
    for (std::size_t i = 0; i < stroke.feet.size(); ++i) {
        const SampleFoot& foot = stroke.feet[i];
        if (!stroke.is_on_main(i) || !foot.now) continue;
        const glm::dvec3 now = taken_by(now_to_drawn, foot.now->p);
        a.push_back(foot.drawn);
        b.push_back(now);
        a.push_back(foot.drawn + out_by(normal_then * stroke.attachment.samples[i].normal));
        b.push_back(now + out_by(normal_now * foot.now->normal));
    }
    if (a.empty()) return glm::dmat4(1);
    return best_motion(a, b);
}

} // namespace

bool alike(const StrokeHosts& stroke, const glm::dmat4& a, const glm::dmat4& b)
{
    return std::ranges::all_of(stroke.drawn.corners(), [&](const glm::dvec3& p) {
        const glm::dvec3 q = taken_by(a, p);
        return glm::distance(q, taken_by(b, p)) <=
               same * (glm::length(stroke.drawn.size()) + glm::length(p) + glm::length(q));
    });
}

HostMotion motion_of(const StrokeHosts& stroke)
{
    const HostNow& main = stroke.main_host();
    const bool even = even_scale(main.moved).has_value();
    const glm::dmat4 from = even ? main.moved : glm::dmat4(1);
    HostMotion out;
    out.exact = even && feet_unmoved(stroke);
    out.to_world = out.exact ? from : from * nearest_motion(stroke, from);
    if (alike(stroke, out.to_world, glm::dmat4(1))) out.to_world = glm::dmat4(1);
    return out;
}

} // namespace trivar
