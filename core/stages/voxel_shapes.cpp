// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stages/voxel_shapes.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/level/fitted_volume.h"
#include "core/stages/inside_material.h"
#include "core/voxels/usual_level.h"

#include <cmath>
#include <fmt/format.h>

namespace trivar {
namespace {

constexpr std::size_t kept_changes = 3; // of every level

std::string name_of(const VoxelLevel& level)
{
    return level.name.empty() ? "Level " + number_text(level.value, {.digits = 6}) : level.name;
}

} // namespace

Ref<Casting> VoxelShapes::casting(const Ref<VoxelField>& field, const Ref<VoxelGrid>& grid,
                                  const VolumeCasting& wanted, Timings& timings)
{
    return castings_({field, wanted.points}, [&] {
        return timed(timings, "casting", [&] {
            const VolumeSummary& summary =
                *summaries_(grid, [&] { return make_ref(summary_of(*grid)); });
            return make_ref(casting_of(
                field, wanted.points.empty() ? usual_transfer(summary, *grid) : wanted.points,
                summary.least, summary.greatest));
        });
    });
}

VoxelShapes::Fit VoxelShapes::fit(const Ref<VoxelField>& field, const TetrahedraFit& wanted,
                                  Timings& timings)
{
    if (wanted.coefficients == 0) return {};
    return fits_({field, wanted}, [&]() -> Fit {
        return timed(timings, "fit", [&]() -> Fit {
            try {
                return {make_ref(fitted_volume(*field, wanted))};
            } catch (const Rejected& why) {
                return {nullptr, why.what()};
            }
        });
    });
}

// Keyed without width and amount, so that changing these, or the view, finds no line anew.
Ref<LevelLines> VoxelShapes::further_lines(const ShownVolume& shown, const Ref<VoxelField>& all,
                                           const Ref<LevelMesh>& mesh, const MoreLines& wanted)
{
    MoreLines fixed = wanted;
    fixed.width = fixed.amount = 1;
    fixed.suggestive = true;
    return further_({mesh, shown.side, fixed}, [&] {
        const Ref<ScalarField<float>>& smooth =
            smooth_({all, wanted.smoothing}, [&]() -> Ref<ScalarField<float>> {
                if (wanted.smoothing == 0) return {all, &all->field()};
                return make_ref(smooth_field(*all, wanted.smoothing));
            });
        const auto by = [&](const ScalarField<float>& bends) {
            return make_ref(
                level_lines(*shown.field, bends, *mesh, shown.side, shown.to_model, fixed));
        };
        return shown.field == all ? by(*smooth)
                                  : by(smooth->part(shown.part.first, shown.part.size()));
    });
}

Shape VoxelShapes::operator()(const VoxelShape& source, const AssetStore& assets, Timings& timings,
                              const Progress& progress)
{
    const AssetStore::LoadedVolume loaded = timed(timings, "import", [&] {
        return assets.load_volume(source.path, source.hash, progress, source.reading);
    });
    return (*this)(source, loaded, timings, progress);
}

Shape VoxelShapes::operator()(const VoxelShape& source, const AssetStore::LoadedVolume& loaded,
                              Timings& timings, const Progress& progress)
{
    std::vector<VoxelLevel> levels = source.levels;
    if (levels.empty() && loaded.grid && !source.casting.shown) // a log by hand need not name one
        levels.push_back({.value = usual_level(*loaded.summary, *loaded.grid)});
    Model model;
    ShownVolume shown;
    Ref<VoxelField> all;
    if (loaded.grid) {
        const VoxelFieldOptions options{source.spline, source.order, source.blur, source.coarsen};
        all = fields_({loaded.grid, options}, [&] {
            return timed(timings, "field",
                         [&] { return std::make_shared<const VoxelField>(loaded.grid, options); });
        });
        const glm::ivec3 size = all->grid().size;
        shown.part = sample_box(size, source.crop_low, source.crop_high);
        shown.field = all;
        if (shown.part.size() != size)
            shown.field = parts_({all, shown.part}, [&] {
                return timed(timings, "field",
                             [&] { return std::make_shared<const VoxelField>(*all, shown.part); });
            });
        shown.data = loaded.grid;
        shown.summary = loaded.summary;
        shown.side = shown.field->side(source.body);
        shown.to_model = glm::dmat4(glm::dmat3(source.scale)) * shown.field->grid().to_metres;
        levels_.keep(kept_changes * (levels.size() + 1));
        nearby_.keep(levels.size() + 1);
        further_.keep(kept_changes * (levels.size() + 1));
        surfaces_.keep(kept_changes * (levels.size() + 1));
        fitted_.keep(kept_changes * (levels.size() + 1));
    }
    // Keys may close the box.
    const bool some = all && glm::all(glm::lessThan(source.crop_low, source.crop_high));
    const Fit fitted = some ? fit(shown.field, source.fit, timings) : Fit{};
    for (std::size_t i = 0; i < levels.size() && some; ++i) {
        const VoxelLevel& level = levels[i];
        if (level.hidden) continue;
        report(progress, static_cast<double>(i) / static_cast<double>(levels.size()),
               name_of(level));
        const Ref<LevelMesh>& mesh = levels_({shown.field, level.value}, [&] {
            return timed(timings, "level",
                         [&] { return make_ref(shown.field->level(level.value)); });
        });
        shown.levels.push_back({i, name_of(level), mesh, level.lines && !fitted.volume, level.ink,
                                level.certified && source.order == FieldOrder::cubic, level.more});
        if (level.lines && level.more.any() && !fitted.volume)
            shown.levels.back().further = timed(
                timings, "lines", [&] { return further_lines(shown, all, mesh, level.more); });
        if (level.lines && level.more.amount < 1 && !fitted.volume)
            shown.levels.back().nearby = nearby_({shown.field, level.value}, [&] {
                return timed(timings, "lines",
                             [&] { return make_ref(shown.field->nearby_levels(level.value)); });
            });
        if (!level.surface && !(level.lines && fitted.volume)) continue;
        const auto material = static_cast<std::uint32_t>(model.materials.size());
        const auto with_material = [&](Mesh made) {
            made.face_material.assign(made.face_count(), material);
            return make_ref(std::move(made));
        };
        const auto by_fit = [&] {
            return timed(timings, "level", [&] {
                return with_material(fitted_surface(*fitted.volume, shown.field->grid(),
                                                    level.value, source.body, shown.to_model));
            });
        };
        const auto by_spline = [&] {
            return timed(timings, "level", [&] {
                return with_material(shown.field->surface(*mesh, source.body, shown.to_model));
            });
        };
        const Ref<Mesh>& surface =
            fitted.volume
                ? fitted_({fitted.volume, level.value, source.body, source.scale, material}, by_fit)
                : surfaces_({mesh, source.body, source.scale, material}, by_spline);
        if (surface->face_count() == 0) continue;
        shown.levels.back().surface = static_cast<int>(model.meshes.size());
        model.nodes.push_back(
            {name_of(level), -1, glm::dmat4(1), static_cast<int>(model.meshes.size())});
        model.meshes.push_back(surface);
        model.materials.push_back(material_of(level.look));
        model.materials.back().name = name_of(level);
    }
    if (some && source.casting.shown) {
        shown.casting = casting(all, loaded.grid, source.casting, timings);
        shown.seen_as = source.casting;
    }
    if (model.materials.empty()) model.materials.emplace_back();
    Shape out = shape_of(make_ref(std::move(model)));
    out.notices = loaded.notices;
    if (!fitted.refused.empty())
        out.notices.push_back("it is not fitted by tetrahedra: " + fitted.refused);
    if (fitted.volume) {
        const double off = fitted.volume->rms * std::abs(loaded.grid->slope),
                     share = off / (loaded.summary->greatest - loaded.summary->least);
        constexpr double told_from = 0.02;
        if (share > told_from)
            out.notices.push_back(fmt::format(
                "its tetrahedra are off the data by {} on average, {} of the range; more of them "
                "come nearer",
                number_text(off), percent_text(share)));
    }
    if (!loaded.grid) out.lacks = loaded.notices;
    if (shown.field) out.volume = make_ref(std::move(shown));
    return out;
}

} // namespace trivar
