// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/session/level_draft.h"

#include "editor/session/volume_levels.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr double most_in_a_draft = 1 << 21;

bool differs_by_values_alone(const VoxelShape& before, const VoxelShape& now)
{
    if (before.levels.size() != now.levels.size() || before == now) return false;
    VoxelShape changed = before;
    for (std::size_t i = 0; i < now.levels.size(); ++i)
        changed.levels[i].value = now.levels[i].value;
    return changed == now;
}

// Number of times that the samples along each axis of what is shown are too many.
int excess(const VoxelShape& shape, const EvaluatedObject& evaluated)
{
    if (!evaluated.shape || !evaluated.shape->volume) return 1;
    const glm::dvec3 size(evaluated.shape->volume->summary->size),
        shown = size * glm::dvec3(shape.crop_high - shape.crop_low) / double(shape.coarsen);
    return static_cast<int>(std::ceil(std::cbrt(shown.x * shown.y * shown.z / most_in_a_draft)));
}

} // namespace

std::optional<Document> level_draft(const Document& before, const Document& now,
                                    const Evaluation& evaluated)
{
    std::optional<Document> out;
    for (const auto& [id, object] : now.objects) {
        const VoxelShape *shape = volume_of(now, id), *old = volume_of(before, id);
        const auto known = evaluated.objects.find(id);
        if (!shape || !old || shape->fit.coefficients > 0 || known == evaluated.objects.end() ||
            !differs_by_values_alone(*old, *shape))
            continue;
        const int times = excess(*shape, *known->second);
        if (times < 2) continue;
        if (!out) out = now;
        Object draft = *object;
        auto& coarse = std::get<VoxelShape>(draft.source);
        coarse.coarsen *= times;
        for (VoxelLevel& level : coarse.levels) level.certified = false;
        out->objects.set(id, make_ref(std::move(draft)));
    }
    return out;
}

} // namespace trivar
