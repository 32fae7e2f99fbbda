// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/picture/volume_facts.h"

#include "core/base/rejected.h"
#include "core/ffd/resolution.h"
#include "core/placement/shaper.h"

#include <algorithm>

namespace trivar {
namespace {

bool at_once(const Placement& placement)
{
    constexpr std::size_t few = 2000; // points, judged in less than a frame
    return placement.volume.displacement.points.size() <= few;
}

VolumeFacts::Deviations deviations_of(const Lattice& volume)
{
    VolumeFacts::Deviations out;
    for (int axis = 0; axis < 3; ++axis) {
        const Knots& knots = volume.displacement.axes[static_cast<std::size_t>(axis)];
        const int fewer = fewer_points(knots);
        if (knots.closure() == Closure::open && fewer < knots.count())
            out[static_cast<std::size_t>(axis)] = coarsened(volume, axis, fewer).deviation;
    }
    return out;
}

// The cells of one kind, their colour, how much of it covers the picture, and what it means.
struct FoldLayer {
    const VolumeSurface* surface;
    ui::Color color;
    float cover;
    const char* words;
};
std::vector<FoldLayer> layers_of(const FoldSurfaces& surfaces, const ui::Palette& color)
{
    std::vector<FoldLayer> out{{&surfaces.bad, color.fold, 0.3f, "The volume folds here"},
                               {&surfaces.unknown, color.warn, 0.3f, "May fold here: not proven"},
                               {&surfaces.allowed, color.accent, 0.2f, "Folds are allowed here"}};
    std::erase_if(out, [](const FoldLayer& each) { return each.surface->triangles.empty(); });
    return out;
}

std::vector<gpu::Translucent> veils_of(const FoldSurfaces& surfaces, const ui::Palette& color)
{
    std::vector<gpu::Translucent> veils;
    for (const FoldLayer& each : layers_of(surfaces, color))
        veils.push_back(veil_of(*each.surface, ui::faded(each.color, each.cover)));
    return veils;
}

} // namespace

int fewer_points(const Knots& axis)
{
    return std::max(axis.order(), axis.count() * 3 / 4);
}

Lazy<CellVerdicts> verdicts_of(const EvaluatedObject& placed)
{
    if (placed.shaped) return placed.shaped->volume->verdicts;
    return Lazy<CellVerdicts>(
        [placement = placed.placement] { return judge(placement->volume, {.sign = 1}); });
}

std::vector<gpu::Translucent> fold_veils(const EvaluatedObject& placed, const ui::Palette& color)
{
    return veils_of(fold_surfaces(placed.placement->volume, *verdicts_of(placed)), color);
}

VolumeFacts::~VolumeFacts()
{
    if (given_up_) *given_up_ = true;
}

void VolumeFacts::look_at(const EvaluatedObject& placed)
{
    if (placed.placement == facts_.placement) return;
    if (given_up_) *given_up_ = true;
    given_up_ = std::make_shared<std::atomic<bool>>(false);
    const Ref<Placement> p = placed.placement;
    const Lazy<CellVerdicts> verdicts = verdicts_of(placed);
    facts_ = {p, verdicts,
              Lazy<FoldSurfaces>([p, verdicts] { return fold_surfaces(p->volume, *verdicts); }),
              Lazy<Deviations>([p] { return deviations_of(p->volume); }),
              Lazy<Overlap>([p, given_up = given_up_] {
                  return trivar::overlap(p->volume, {}, [&](double, std::string_view) {
                      if (*given_up) throw Cancelled();
                  });
              })};
    if (!at_once(*p)) return hand_over();
    (void)*facts_.surfaces;
    (void)*facts_.deviations;
}

void VolumeFacts::hand_over()
{
    work_.drop();
    work_.start([facts = facts_](const Progress& go_on) -> Worker::Finish {
        (void)*facts.surfaces;
        report(go_on, 0, {});
        (void)*facts.deviations;
        report(go_on, 0, {});
        if (facts.overlap_wanted) (void)*facts.overlap;
        return {};
    });
}

const std::vector<gpu::Translucent>& VolumeFacts::folds(const EvaluatedObject& placed,
                                                        const ui::Palette& color)
{
    look_at(placed);
    const std::array colors{color.fold, color.accent};
    if (!facts_.surfaces.ready() || (drawn_of_ == facts_.placement && drawn_in_ == colors))
        return veils_;
    drawn_of_ = facts_.placement;
    drawn_in_ = colors;
    veils_ = veils_of(*facts_.surfaces, color);
    return veils_;
}

std::vector<FoldMark> VolumeFacts::fold_marks(const EvaluatedObject& placed,
                                              const ui::Palette& color)
{
    look_at(placed);
    std::vector<FoldMark> out;
    if (!facts_.surfaces.ready()) return out;
    for (const FoldLayer& each : layers_of(*facts_.surfaces, color))
        out.push_back({each.color, each.words});
    return out;
}

const CellVerdicts* VolumeFacts::verdicts(const EvaluatedObject& placed)
{
    look_at(placed);
    return facts_.verdicts.ready() ? &*facts_.verdicts : nullptr;
}

const VolumeFacts::Deviations* VolumeFacts::deviations(const EvaluatedObject& placed)
{
    look_at(placed);
    return facts_.deviations.ready() ? &*facts_.deviations : nullptr;
}

const Overlap* VolumeFacts::overlap(const EvaluatedObject& placed)
{
    look_at(placed);
    if (!std::exchange(facts_.overlap_wanted, true)) hand_over();
    return facts_.overlap.ready() ? &*facts_.overlap : nullptr;
}

std::vector<gpu::Translucent> VolumeFacts::meeting(const EvaluatedObject& placed,
                                                   const ui::Palette& color) const
{
    if (placed.placement != facts_.placement || !facts_.overlap.ready()) return {};
    const Overlap& found = *facts_.overlap;
    if (found.verdict != Verdict::proven_bad) return {};
    std::vector<gpu::Translucent> out;
    for (const glm::dvec3& uvw : {found.one, found.other})
        out.push_back(
            veil_of(slice_at(placed.placement->volume, uvw.x), ui::faded(color.fold, 0.4f)));
    return out;
}

bool VolumeFacts::busy()
{
    work_.poll();
    return work_.busy();
}

int VolumeFacts::known() const
{
    return (facts_.surfaces.ready() ? 1 : 0) + (facts_.overlap.ready() ? 2 : 0);
}

} // namespace trivar
