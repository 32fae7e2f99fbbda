// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/band.h"

#include "core/placement/round.h"

namespace trivar {
namespace {

std::optional<Band> band_of(const auto&)
{
    return {};
}
std::optional<Band> band_of(const CylinderShape& s)
{
    return Band{.radius = s.radius};
}
std::optional<Band> band_of(const SphereShape& s)
{
    return Band{.of = Band::Of::sphere, .radius = s.radius};
}
std::optional<Band> band_of(const TorusShape& s)
{
    return Band{.of = Band::Of::torus, .radius = s.radius, .tube = s.tube};
}
std::optional<Band> band_of(const MoebiusShape& s)
{
    return Band{.of = Band::Of::moebius, .radius = s.radius};
}

} // namespace

std::optional<Band> band_round(const Source& source, double level, const glm::dmat4& to_world)
{
    std::optional<Band> band = std::visit([](const auto& shape) { return band_of(shape); }, source);
    if (!band) return band;
    band->level = level;
    band->to_world = to_world;
    return band;
}

} // namespace trivar
