// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/box_volume.h"

#include "core/placement/finish.h"
#include "core/placement/level_surface.h"

#include <glm/gtc/matrix_transform.hpp>

namespace trivar {

Placement place_box(const glm::dvec3& size, const glm::ivec3& grid, const glm::ivec3& orders)
{
    const glm::dmat4 rest =
        glm::translate(glm::dmat4(1), -size / 2.0) * glm::scale(glm::dmat4(1), size);
    Lattice volume =
        lattice_at_rest({Knots::uniform(orders.x, grid.x), Knots::uniform(orders.y, grid.y),
                         Knots::uniform(orders.z, grid.z)},
                        rest);
    constexpr double middle = 0.5; // toward which a press goes
    Placement out{.contact = level_surface(volume, middle),
                  .volume = std::move(volume),
                  .embedding = {.to_uvw = glm::inverse(rest), .to_rest = glm::dmat4(1)},
                  .report = {},
                  .strip = {},
                  .ground = middle,
                  .nodes = {}};
    out.strip = outline(out.contact);
    out.report.length_world = size.x;
    out.report.width_world = size.y;
    out.report.height_world = size.z;
    out.report.smallest_jacobian = 1;
    return out;
}

ShapedVolume mapped(const ShapedVolume& volume, const glm::dmat4& to_world)
{
    Placement placement = *volume.placement;
    placement.volume = mapped(std::move(placement.volume), to_world);
    placement.contact = level_surface(placement.volume, placement.ground);
    placement.strip = outline(placement.contact);
    placement.embedding.to_uvw = placement.embedding.to_uvw * glm::inverse(to_world);
    placement.embedding.to_rest = glm::dmat4(1);
    LaidVolume laid = *volume.volume;
    laid.volume = make_ref(placement.volume);
    laid.as_laid = make_ref(mapped(*laid.as_laid, to_world));
    return {make_ref(std::move(placement)), make_ref(std::move(laid)), volume.steps};
}

} // namespace trivar
