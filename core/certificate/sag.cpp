// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/certificate/sag.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

glm::dvec3 place_of(const Part& part, std::uint32_t vertex)
{
    const glm::dvec3 p(part.posed ? posed_point(*part.rest, part.posed->pose, vertex)
                                  : part.rest->positions[vertex]);
    return part.bent ? deform(p, part.bent->embedding, *part.bent->volume).position_world
                     : glm::dvec3(part.to_world * glm::dvec4(p, 1));
}

} // namespace

double sag_between_moments(const FilmStrip& strip)
{
    constexpr std::size_t vertices = 128;
    const std::size_t count = strip.first().rest->vertex_count(),
                      step = std::max<std::size_t>(1, count / vertices);
    double most = 0;
    for (std::size_t i = 1; i + 1 < strip.shown.size(); i += 2) {
        const Part *a = strip.shown[i - 1], *part = strip.shown[i], *b = strip.shown[i + 1];
        if (!a || !part || !b) continue;
        for (std::size_t v = 0; v < count; v += step) {
            const auto vertex = static_cast<std::uint32_t>(v);
            most =
                std::max(most, glm::distance(place_of(*part, vertex),
                                             (place_of(*a, vertex) + place_of(*b, vertex)) / 2.0));
        }
    }
    constexpr double of_half_the_way = 0.25; // the sag grows with the square of the way
    return of_half_the_way * most;
}

} // namespace trivar
