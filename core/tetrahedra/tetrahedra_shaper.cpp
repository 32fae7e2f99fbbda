// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tetrahedra/tetrahedra_shaper.h"

#include "core/base/number_text.h"
#include "core/placement/warping.h"
#include "core/simplex/cell_displacements.h"
#include "core/tetrahedra/pulling.h"
#include "core/tetrahedra/tetrahedra_layers.h"

#include <fmt/format.h>

namespace trivar {
namespace {

std::vector<glm::dvec3> change_by(const Warp& warp, const glm::dvec3& size,
                                  const SimplexVolume& volume)
{
    std::vector<glm::dvec3> out(volume.displacements.size(), glm::dvec3(0));
    const std::vector<glm::dvec3>& rest = volume.layers.front()->rest();
    for (std::size_t i = 0; i < rest.size(); ++i) {
        const glm::dvec3 from = rest[i] + volume.displacements[i];
        out[i] = warped(from, size, warp) - from;
    }
    return out;
}

TetrahedraOutcome take(SimplexVolume& volume, std::span<const glm::dvec3> change,
                       const FoldGuard* guard)
{
    TetrahedraOutcome out;
    if (guard) out.share = guard->allowed(volume.displacements, change);
    for (std::size_t i = 0; i < change.size(); ++i)
        volume.displacements[i] += change[i] * out.share;
    if (out.share < 1)
        out.notice = fmt::format("only {} of it is done, since more would fold what stands there; "
                                 "reduce it, or widen its ball",
                                 percent_text(out.share));
    return out;
}

// The one with a number from 1 on; null: there is none.
const TetrahedraRefinement* refinement(const TetrahedraShape& shape, int number)
{
    for (const TetrahedraEdit& edit : shape.edits)
        if (edit.refinement && --number == 0) return &*edit.refinement;
    return nullptr;
}

// The shape with only the edits that change the domain.
TetrahedraShape domain_alone(TetrahedraShape shape)
{
    std::erase_if(shape.edits, [](const TetrahedraEdit& edit) {
        return !edit.crease && !edit.refinement && !edit.cloud;
    });
    return shape;
}

} // namespace

ShapedTetrahedra TetrahedraShaper::operator()(const TetrahedraShape& shape,
                                              const Progress& progress)
{
    report(progress, 0, "shape");
    const Ref<Domain> domain = domains_(domain_alone(shape), [&] {
        Domain made{layers_of(shape), {}};
        made.guard = Lazy<FoldGuard>([layers = made.layers] { return FoldGuard(layers); });
        return make_ref(std::move(made));
    });
    SimplexVolume volume{domain->layers, {}};
    if (!shape.displaced.empty())
        volume.displacements = control_displacements(*volume.layers.front(), shape.displaced);
    volume.displacements.resize(volume.first_point(volume.layers.size()), glm::dvec3(0));
    ShapedTetrahedra out;
    for (std::size_t i = 0; i < shape.edits.size(); ++i) {
        report(progress, static_cast<double>(i) / static_cast<double>(shape.edits.size()), "shape");
        const TetrahedraEdit& edit = shape.edits[i];
        TetrahedraOutcome outcome;
        if (edit.pull) {
            outcome =
                take(volume, change_by(*edit.pull, volume, refinement(shape, edit.pull->layer)),
                     edit.pull->guard ? &*domain->guard : nullptr);
            if (edit.pull->layer >= static_cast<int>(volume.layers.size()))
                outcome.notice = fmt::format("There is no refinement {}.", edit.pull->layer);
        }
        if (edit.warp)
            outcome = take(volume, change_by(*edit.warp, size_of(shape), volume),
                           edit.warp->guard ? &*domain->guard : nullptr);
        out.outcomes.push_back(std::move(outcome));
    }
    out.volume = make_ref(std::move(volume));
    return out;
}

} // namespace trivar
