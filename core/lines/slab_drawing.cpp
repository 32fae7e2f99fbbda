// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lines/slab_drawing.h"

#include "core/lines/line_budget.h"
#include "core/silhouette/slab_curves.h"

#include <iterator>

namespace trivar {
namespace {

// The lines of one level and which of their points are hidden.
struct FoundLines {
    std::array<Silhouettes, 2> lines; // silhouettes, border
    std::array<std::vector<char>, 2> hidden;
};

std::vector<FoundLines> lines_of(const SlabPlan& plan, const VoxelFieldOptions& field,
                                 const SliceReader& read, std::span<const SlabLevel> levels,
                                 const ViewPoint& view)
{
    std::vector<SlabCurves> curves(levels.size(), SlabCurves(view));
    for_slabs(plan, field, read, [&](const FieldSlab& slab) {
        for (std::size_t i = 0; i < levels.size(); ++i)
            curves[i].add(slab.field(), slab.level(levels[i].level), slab.end());
    });
    std::vector<FoundLines> out;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        FoundLines found{{curves[i].curves(), {}}, {}};
        if (levels[i].border) found.lines[1] = curves[i].border();
        for (std::size_t k = 0; k < 2; ++k)
            found.hidden[k] = hollow_points(found.lines[k], levels[i].side);
        out.push_back(std::move(found));
    }
    return out;
}

} // namespace

LevelDrawing draw_levels_by_slabs(const SlabPlan& plan, const VoxelFieldOptions& field,
                                  const SliceReader& read, std::span<const SlabLevel> levels,
                                  const DrawingView& view, const LevelDrawingOptions& options)
{
    std::vector<FoundLines> found = lines_of(plan, field, read, levels, view.from);
    for_slabs(plan, field, read, [&](const FieldSlab& slab) {
        for (std::size_t i = 0; i < levels.size(); ++i) {
            std::vector<LevelBody> bodies;
            for (std::size_t j = 0; j < levels.size(); ++j)
                if (j == i || options.hide_each_other)
                    bodies.push_back(slab.body(levels[j].level, levels[j].side));
            for (std::size_t k = 0; k < 2; ++k)
                found[i].hidden[k] =
                    hidden_by(std::move(found[i].hidden[k]), found[i].lines[k], view.from, bodies);
        }
    });
    LevelDrawing out;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        std::array<std::vector<Stroke>, 2> made;
        for (std::size_t k = 0; k < 2; ++k)
            made[k] =
                strokes(found[i].lines[k], found[i].hidden[k], view.to_image, options.strokes);
        if (options.ids) options.ids(levels[i].name)(made);
        out.layers.push_back({levels[i].name, {}});
        for (std::vector<Stroke>& kind : made)
            std::ranges::move(
                inked(within_budget(std::move(kind), levels[i].amount), levels[i].style),
                std::back_inserter(out.layers.back().lines));
    }
    return out;
}

} // namespace trivar
