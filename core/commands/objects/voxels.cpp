// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/voxels.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/commands/edits/edits.h"
#include "core/commands/words/number_words.h"

#include <filesystem>
#include <fmt/format.h>

namespace trivar {
namespace {

constexpr std::size_t most_levels = 64, most_transfer_points = 256;

std::string level_words(const VoxelLevel& level)
{
    return level.name.empty() ? number_text(level.value, {.digits = 6}) : excerpt(level.name);
}

// The only level that differs; none: all else, or several of them.
const VoxelLevel* changed_level(const VoxelShape& before, const VoxelShape& after)
{
    if (before.levels.size() != after.levels.size()) return nullptr;
    const VoxelLevel* out = nullptr;
    for (std::size_t i = 0; i < after.levels.size(); ++i) {
        if (before.levels[i] == after.levels[i]) continue;
        if (out) return nullptr;
        out = &after.levels[i];
    }
    return out;
}

void check_box(const glm::vec3& low, const glm::vec3& high)
{
    if (!glm::all(glm::lessThan(low, high)))
        throw Rejected("field \"crop_low\": the box is empty; use shares below those of "
                       "\"crop_high\"");
}

} // namespace

void check(const VoxelShape& shape)
{
    if (shape.path.empty()) throw Rejected("field \"path\" names no file");
    if (shape.levels.size() > most_levels)
        throw Rejected(fmt::format("field \"levels\": at most {} levels are shown", most_levels));
    const VolumeCasting& casting = shape.casting;
    if (casting.points.size() > most_transfer_points)
        throw Rejected(fmt::format("field \"points\": a transfer function has at most {}",
                                   most_transfer_points));
    check_box(shape.crop_low, shape.crop_high);
    check_box(casting.crop_low, casting.crop_high);
}

std::string size_words(const VoxelShape& shape)
{
    const std::filesystem::path path(shape.path); // the object is called as a folder is
    return path.has_extension() ? excerpt(path.filename().string()) : "";
}

StepTitle title_of_change(const VoxelShape* before, const VoxelShape& now, const std::string& name)
{
    if (!before) return {"Volume data of " + name, {}};
    if (before->path != now.path) return {"File of " + name, size_words(now)};
    if (before->crop_low != now.crop_low || before->crop_high != now.crop_high)
        return {"Crop of " + name, {}};
    if (before->casting != now.casting) return {"Casting of " + name, {}};
    if (before->levels.size() < now.levels.size())
        return {"Level of " + name, level_words(now.levels.back())};
    if (before->levels.size() > now.levels.size()) return {"Remove level of " + name, {}};
    if (const VoxelLevel* level = changed_level(*before, now))
        return {"Level of " + name, level_words(*level)};
    return {"Volume data of " + name, {}};
}

} // namespace trivar
