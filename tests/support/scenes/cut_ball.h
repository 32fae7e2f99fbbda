// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/cutting/cut.h"
#include "core/commands/edits/edits.h"
#include "core/commands/objects/primitives.h"
#include "core/evaluation/evaluate.h"
#include "tests/support/fixtures.h"
#include "tests/support/scenes/commands.h"

namespace trivar::testing {

inline Document one_ball()
{
    return after(Document{}, AddSphere{.shape = {.radius = 1, .segments = 48, .rings = 24}});
}

inline CutThrough across(double gap, CutKeep keep = CutKeep::both)
{
    return {{1}, {.cuts = {{.point = {0, 0, 0.2}, .normal = {0, 0, 1}, .keep = keep, .gap = gap}}}};
}

inline Ref<EvaluatedObject> shown_first(const Document& document, double frame = 1)
{
    return new_evaluator()(document_at(document, frame), frame).objects.at(1);
}

inline double volume_of_part(const Part& part)
{
    double six = 0;
    const Mesh mesh = transformed(*part.mesh(), part.to_world);
    for (const glm::uvec3& t : triangles(mesh))
        six +=
            glm::dot(glm::dvec3(mesh.positions[t.x]),
                     glm::cross(glm::dvec3(mesh.positions[t.y]), glm::dvec3(mesh.positions[t.z])));
    return six / 6;
}

inline double volume_of(const EvaluatedObject& object)
{
    double sum = 0;
    for (const Part& part : object.parts) sum += volume_of_part(part);
    return sum;
}

// The ball cut in two across z, half a metre apart, and then again.
inline CutThrough drawn_over_two(const PlainCut& second)
{
    CutThrough out = across(0.5);
    out.cutting.cuts.push_back(second);
    return out;
}

} // namespace trivar::testing
