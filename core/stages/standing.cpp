// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stages/standing.h"

namespace trivar {

std::vector<StandingMesh> standing(const Shape& shape, const glm::dmat3& turned)
{
    std::vector<StandingMesh> out;
    for (const Shape::NodeMesh& hung : shape.meshes) {
        StandingMesh each{{.rest = hung.rest, .posed = hung.posed, .bounds = hung.bounds},
                          glm::dmat4(turned) * hung.to_model};
        if (glm::determinant(glm::dmat3(each.to_box)) < 0) {
            each.part = {.rest = make_ref(transformed(*hung.mesh(), each.to_box))};
            each.part.bounds = bounding_box(*each.part.rest);
            each.to_box = glm::dmat4(1);
        }
        each.part.key.mesh = hung.slot;
        out.push_back(std::move(each));
    }
    return out;
}

std::vector<Part> parts_in_model(const Shape& shape)
{
    std::vector<Part> out;
    for (const Shape::NodeMesh& hung : shape.meshes)
        out.push_back(
            {hung.rest, hung.to_model, hung.posed, nullptr, {.mesh = hung.slot}, hung.bounds});
    return out;
}

std::vector<StandingCurves> standing_curves(const Shape& shape, const glm::dmat3& turned)
{
    std::vector<StandingCurves> out;
    for (const Shape::NodeCurves& hung : shape.curves)
        out.push_back(
            {{hung.curves,
              {.rest = hung.curves->points, .key = {.mesh = hung.slot}, .bounds = hung.bounds}},
             glm::dmat4(turned) * hung.to_model});
    return out;
}

Embedding embedded(const Embedding& box, const glm::dmat4& to_box)
{
    return {box.to_uvw * to_box, box.to_rest * to_box};
}

} // namespace trivar
