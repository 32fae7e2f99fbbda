// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scenes/incised_ball.h"

#include "core/commands/cutting/incise.h"
#include "core/commands/objects/primitives.h"
#include "core/document/document_digest.h"
#include "tests/support/fixtures.h"

namespace trivar::testing {

NamedIncision over_ball(const glm::dvec3& from, const glm::dvec3& to)
{
    constexpr int samples = 16;
    NamedIncision out;
    for (int i = 0; i <= samples; ++i) {
        const glm::dvec3 n = glm::normalize(from + (to - from) * (i / double(samples)));
        out.cut.stroke.push_back({n, n});
    }
    out.cut.depth = 0.15;
    out.cut.width = 0.12;
    return out;
}

NamedIncision across_the_front(double opening)
{
    NamedIncision out = over_ball({1, -0.5, 0.1}, {1, 0.5, 0});
    out.opening.share = opening;
    return out;
}

Document ball_to_incise()
{
    return after(Document{}, AddSphere{.shape = {.radius = 1, .segments = 48, .rings = 24}});
}

Document incised_ball(double opening)
{
    return after(ball_to_incise(), Incise{1, across_the_front(opening)});
}

Ref<EvaluatedObject> ball_in(const Document& document, double frame)
{
    return new_evaluator()(document, frame).objects.at(1);
}

std::string effects_of(const Document& document, double frame)
{
    return digest(new_evaluator()(document, frame));
}

} // namespace trivar::testing
