// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/recent.h"
#include "core/base/timing.h"
#include "core/casting/casting.h"
#include "core/document/asset_store.h"
#include "core/level/voxel_field.h"
#include "core/lines/level_lines.h"
#include "core/stages/shape.h"
#include "core/stages/shown_volume.h"

#include <tuple>

namespace trivar {

struct FittedVolume;

// VoxelShapes makes shapes of volume data: one mesh per level that shows its surface. It keeps the
// last fields and levels, so that a level that is dragged costs its own mesh alone.
class VoxelShapes {
public:
    // Throws Rejected for trouble with the data; a file that is missing gives an empty shape that
    // says so. Throws Cancelled. Stages: import, field, fit, level, lines, casting.
    Shape operator()(const VoxelShape& source, const AssetStore& assets, Timings& timings,
                     const Progress& progress);
    // The same of data that were read; what the source says of its file does not count.
    Shape operator()(const VoxelShape& source, const AssetStore::LoadedVolume& loaded,
                     Timings& timings, const Progress& progress = {});

private:
    struct Fit {
        Ref<FittedVolume> volume = nullptr; // null: there is none
        std::string refused = {};           // why, where it was asked for
    };
    Fit fit(const Ref<VoxelField>& field, const TetrahedraFit& wanted, Timings& timings);
    Ref<Casting> casting(const Ref<VoxelField>& field, const Ref<VoxelGrid>& grid,
                         const VolumeCasting& wanted, Timings& timings);

    using FieldKey = std::pair<Ref<VoxelGrid>, VoxelFieldOptions>;
    using PartKey = std::pair<Ref<VoxelField>, SampleBox>;
    using LevelKey = std::pair<Ref<VoxelField>, double>;
    // with the scale and the number of its material
    using SurfaceKey = std::tuple<Ref<LevelMesh>, LevelSide, double, std::uint32_t>;
    using FitKey = std::pair<Ref<VoxelField>, TetrahedraFit>;
    // with the level
    using FittedKey = std::tuple<Ref<FittedVolume>, double, LevelSide, double, std::uint32_t>;

    using CastingKey = std::pair<Ref<VoxelField>, std::vector<TransferPoint>>;
    using SmoothKey = std::pair<Ref<VoxelField>, float>;
    using FurtherKey = std::tuple<Ref<LevelMesh>, LevelSide, MoreLines>;

    Ref<LevelLines> further_lines(const ShownVolume& shown, const Ref<VoxelField>& all,
                                  const Ref<LevelMesh>& mesh, const MoreLines& wanted);

    Recent<FieldKey, Ref<VoxelField>> fields_;
    Recent<PartKey, Ref<VoxelField>> parts_{2};
    Recent<LevelKey, Ref<LevelMesh>> levels_;
    Recent<LevelKey, Ref<std::vector<LevelMesh>>> nearby_;
    Recent<SurfaceKey, Ref<Mesh>> surfaces_;
    Recent<FitKey, Fit> fits_;
    Recent<FittedKey, Ref<Mesh>> fitted_;
    Recent<Ref<VoxelGrid>, Ref<VolumeSummary>> summaries_;
    Recent<CastingKey, Ref<Casting>> castings_;
    Recent<SmoothKey, Ref<ScalarField<float>>> smooth_{1};
    Recent<FurtherKey, Ref<LevelLines>> further_;
};

} // namespace trivar
