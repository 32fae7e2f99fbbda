// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/command.h"
#include "core/mesh/model.h"
#include "core/voxels/raw_layout.h"

#include <array>
#include <string>
#include <vector>

namespace trivar {

// A VolumeSlice is a picture of the values in a plane through the middle of volume data, dark where
// they are low. Its sides lie along axes of space.
struct VolumeSlice {
    Image image;
    double shape = 1; // its width over its height in space
};
// From above (the front at the top), from the front and from the side: of a body its head at the
// top. At most 320 pixels wide and high; values from the lowest to the highest thousandth.
std::array<VolumeSlice, 3> middle_slices(const VoxelGrid& grid, const VolumeSummary& summary);

// Which direction of the data points up in the scene.
enum class DataUp { z, minus_z, y, minus_y, x, minus_x };

// A VolumeOffer is volume data as they are shown before they come into the scene, and how they are
// to stand there.
struct VolumeOffer {
    std::string path;       // absolute
    AddVoxels command;      // as it would be run, but for its transform and its scale
    Ref<AssetStore> assets; // by which it was read
    Ref<VoxelGrid> grid;    // null: it cannot be read so
    Ref<VolumeSummary> summary;
    std::array<VolumeSlice, 3> slices;
    std::vector<std::string> notices;
    std::vector<RawGuess> guesses; // of a file without a head
    bool raw = false;              // it is such a file: the person says how its samples lie
    bool says_no_spacing = false;  // neither do its files
    std::string trouble;           // why it cannot be read so
    DataUp up = DataUp::z;
    double scale = 1;
    bool centered = true; // it stands on the ground in the middle of the scene
};

// Reads them. Without a head and without sizes in its name a file is read by the likeliest layout.
// Throws Rejected, but for a file without a head, whose offer says what is wrong. Beside the
// window.
VolumeOffer offer_of(const std::string& path, const VolumeReading& reading,
                     const Ref<AssetStore>& assets, const Progress& progress);

// The command that brings them into the scene as the offer says.
AddVoxels command_of(const VolumeOffer& offer);
// The sides of the data as they would stand in the scene, metres.
glm::dvec3 size_of(const VolumeOffer& offer);

} // namespace trivar
