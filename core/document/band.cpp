// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/band.h"

#include "core/placement/round.h"

namespace trivar {

std::optional<Band> band_round(const Source& source, double level, const glm::dmat4& to_world)
{
    Band band{.level = level, .to_world = to_world};
    if (const auto* cylinder = std::get_if<CylinderShape>(&source))
        band.radius = cylinder->radius;
    else if (const auto* sphere = std::get_if<SphereShape>(&source)) {
        band.of = Band::Of::sphere;
        band.radius = sphere->radius;
    } else if (const auto* torus = std::get_if<TorusShape>(&source)) {
        band.of = Band::Of::torus;
        band.radius = torus->radius;
        band.tube = torus->tube;
    } else if (const auto* moebius = std::get_if<MoebiusShape>(&source)) {
        band.of = Band::Of::moebius;
        band.radius = moebius->radius;
    } else
        return {};
    return band;
}

} // namespace trivar
