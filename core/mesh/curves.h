// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"
#include "core/mesh/mesh.h"

namespace trivar {

// Lines through points, as files give them beside faces: contours, wires, guides. Each goes
// straight from point to point and has no width. Where its last point is at its first one it is
// closed.
//
//   line l   points begin[l] .. begin[l + 1] - 1, at least two; no point is in two lines
struct Curves {
    Ref<Mesh> points = make_ref(Mesh{}); // positions, and colours or none; no faces
    std::vector<std::uint32_t> begin{0}; // #L + 1 to point
    std::vector<std::uint32_t> material; // #L to Model::materials, or empty: all 0

    std::size_t line_count() const { return begin.size() - 1; }
    std::size_t point_count() const { return points->vertex_count(); }
    std::uint32_t material_of(std::size_t line) const
    {
        return material.empty() ? 0 : material[line];
    }
};

Curves transformed(const Curves& curves, const glm::dmat4& matrix);

// Throws Rejected, with `name` in the sentence, unless every line has at least two points, every
// point belongs to a line, and every number is finite.
void validate(const Curves& curves, const std::string& name);

} // namespace trivar
