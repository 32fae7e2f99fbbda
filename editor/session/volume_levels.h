// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"
#include "core/voxels/volume_summary.h"
#include "ui/palette.h"

#include <optional>
#include <string>

namespace trivar {

// Returns the words for a level: its name, else its value.
std::string name_of(const VoxelLevel& level);
// The value in the unit of the data: "300 HU".
std::string value_words(double value, const std::string& unit);

// The colour of a level: that of its lines, sRGB; its surface has a paler one.
void set_color(VoxelLevel& level, const glm::vec3& srgb);
ui::Color level_color(const VoxelLevel& level); // on the screen

// A level for data that have those: lines and a surface of a colour that none of the others has, as
// long as there is one.
VoxelLevel new_level(const VoxelShape& shape, double value);
// A value for one more level: between the last one and the greatest value, or the least where it is
// among the highest quarter. Low values are noise more often than high ones.
double next_value(const VoxelShape& shape, const VolumeSummary& summary);

// A value within the range of the data that a person can read: in steps of a 500th of the range or
// less.
double readable_value(double value, const VolumeSummary& summary);

// The object of volume data that a tool works on: the active one, else the only one there is; 0:
// none.
Id volume_at_work(const Document& document, Id active);
const VoxelShape* volume_of(const Document& document, Id id); // null: it is none

enum class LevelShows { lines, surface, both };
LevelShows shows_of(const VoxelLevel& level);
void show(VoxelLevel& level, LevelShows shows);

} // namespace trivar
