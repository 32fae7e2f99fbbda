// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/shading_step.h"

#include "core/mesh/shading.h"

namespace trivar {
namespace {

float smooth_up_to_deg(const FaceShading& shading)
{
    if (shading.way == ShadingWay::flat) return 0;
    return shading.way == ShadingWay::smooth ? 180 : static_cast<float>(shading.angle_deg);
}

} // namespace

Ref<Stage> ShadingStep::operator()(const Ref<Stage>& before, const StepInput& input)
{
    const FaceShading shading = input.object.shading.value_or(FaceShading{});
    if (shading.way == ShadingWay::own || before->shape->meshes.empty()) return before;
    const float angle = smooth_up_to_deg(shading);
    return known_({before, angle}, [&] {
        Stage out = *before;
        Shape shape = *before->shape;
        shaded_.keep(2 * shape.meshes.size()); // of this angle and of the one before
        for (Shape::NodeMesh& hung : shape.meshes) {
            hung.rest = shaded_({hung.rest, angle}, [&] {
                return timed(input.timings, "shade",
                             [&] { return make_ref(shaded(*hung.rest, angle)); });
            });
            if (hung.posed) hung.posed = posed_later(hung.rest, hung.posed->pose);
        }
        out.shape = make_ref(std::move(shape));
        return make_ref(std::move(out));
    });
}

} // namespace trivar
