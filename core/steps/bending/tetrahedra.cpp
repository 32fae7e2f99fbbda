// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/bending/tetrahedra.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/simplex/function_surface.h"
#include "core/stages/simplex_tears.h"
#include "core/stages/standing.h"

#include <fmt/format.h>

namespace trivar {

Ref<Mesh> TetrahedraStep::surface_of(const TetrahedraFunction& function,
                                     const Ref<SimplexBasis<3>>& basis)
{
    const std::vector<glm::dvec3>& rest = basis->rest();
    int nearest = 0;
    for (std::size_t i = 0; i < rest.size(); ++i)
        if (glm::distance(rest[i], function.at) <
            glm::distance(rest[static_cast<std::size_t>(nearest)], function.at))
            nearest = static_cast<int>(i);
    return surfaces_({basis, nearest, function.share}, [&] {
        const double value = function.share * greatest_value(*basis, nearest);
        return make_ref(function_surface(*basis, nearest, value));
    });
}

Ref<Stage> TetrahedraStep::operator()(const Ref<Stage>& before, const StepInput& input)
{
    const auto* shape = std::get_if<TetrahedraShape>(&input.object.source);
    if (!shape) return before;
    Ref<ShapedTetrahedra> shaped;
    try {
        shaped = shaped_(*shape, [&] {
            return timed(input.timings, "shape",
                         [&] { return make_ref(shaper_(*shape, input.progress)); });
        });
    } catch (const Rejected& error) {
        Stage stage = *before;
        stage.notices.emplace_back(error.what());
        stage.lacks.emplace_back(error.what());
        return make_ref(std::move(stage));
    }
    const glm::dmat4 to_world = trivar::to_world(input.document, input.id);
    return known_({before, shaped, to_world}, [&] {
        Stage stage = *before;
        stage.tetrahedra = shaped;
        stage.tetrahedra_to_world = to_world;
        for (const TetrahedraFunction& function : shape->functions) {
            const Ref<Mesh> mesh = surface_of(function, shaped->volume->layers.front());
            if (mesh->face_count() == 0) continue;
            Part part{.rest = mesh, .to_world = to_world, .bounds = bounding_box(*mesh)};
            part.key.mesh = static_cast<int>(stage.parts.size());
            stage.parts.push_back(std::move(part));
        }
        if (const std::size_t whole = cuts_passed_over(shaped->volume->layers.front()->domain()))
            stage.notices.push_back(
                fmt::format("its cuts lie in more than {} planes: {} of their faces part nothing; "
                            "cut along straighter strokes, or fewer",
                            most_cut_planes, with_commas(whole)));
        for (std::size_t i = 0; i < shaped->outcomes.size(); ++i)
            if (const std::string& notice = shaped->outcomes[i].notice; !notice.empty())
                stage.notices.push_back(fmt::format("Edit {}: {}", i + 1, notice));
        return make_ref(std::move(stage));
    });
}

} // namespace trivar
