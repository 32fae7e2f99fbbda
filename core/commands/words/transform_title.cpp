// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/words/transform_title.h"

#include "core/commands/words/field_words.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace trivar {

// Describes a rotation: by its angle and axis if only one number changed, else by its angle alone.
std::string turn_words(const glm::dvec3& before, const glm::dvec3& after)
{
    int axes = 0, axis = 0;
    for (int i = 0; i < 3; ++i)
        if (before[i] != after[i]) {
            ++axes;
            axis = i;
        }
    if (axes == 1) return in_degrees(after[axis] - before[axis]) + " about " + "XYZ"[axis];
    const glm::dmat3 a(Transform{{}, before, glm::dvec3(1)}.matrix());
    const glm::dmat3 b(Transform{{}, after, glm::dvec3(1)}.matrix());
    const glm::dmat3 between = glm::transpose(a) * b;
    const double cosine = (between[0][0] + between[1][1] + between[2][2] - 1) / 2;
    return in_degrees(std::acos(std::clamp(cosine, -1.0, 1.0)) * 57.29577951308232);
}

std::string growth_words(const glm::dvec3& before, const glm::dvec3& after)
{
    const glm::dvec3 ratio = after / before;
    const auto same = [](double a, double b) { return std::abs(a - b) <= 1e-6 * std::abs(b); };
    if (same(ratio.x, ratio.y) && same(ratio.y, ratio.z)) return "× " + number_text(ratio.x);
    int axes = 0, axis = 0;
    for (int i = 0; i < 3; ++i)
        if (before[i] != after[i]) {
            ++axes;
            axis = i;
        }
    if (axes == 1) return fmt::format("× {} along {}", number_text(ratio[axis]), "XYZ"[axis]);
    return fmt::format("× {}, {}, {}", number_text(ratio.x), number_text(ratio.y),
                       number_text(ratio.z));
}

StepTitle transform_title(const Transform& before, const Transform& after, const std::string& name)
{
    const bool moved = before.translation != after.translation;
    const bool turned = before.rotation_deg != after.rotation_deg;
    const bool scaled = before.scale != after.scale;
    const std::string distance = in_metres(glm::length(after.translation - before.translation));
    if (moved && turned && scaled) return {"Move, rotate and scale " + name, distance};
    if (moved && turned) return {"Move and rotate " + name, distance};
    if (moved && scaled) return {"Move and scale " + name, distance};
    if (turned && scaled)
        return {"Rotate and scale " + name, turn_words(before.rotation_deg, after.rotation_deg)};
    if (turned) return {"Rotate " + name, turn_words(before.rotation_deg, after.rotation_deg)};
    if (scaled) return {"Scale " + name, growth_words(before.scale, after.scale)};
    return {"Move " + name, distance};
}

} // namespace trivar
