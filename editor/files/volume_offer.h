// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/command.h"
#include "core/commands/objects/voxels.h"
#include "core/document/asset_store.h"
#include "core/mesh/model.h"
#include "core/voxels/raw_layout.h"
#include "core/voxels/volume_options.h"

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
// Returns the middle slices seen from above (the front at the top), from the front and from the
// side; the head of a body is at the top. At most 320 pixels wide and high; values from the lowest
// to the highest thousandth.
std::array<VolumeSlice, 3> middle_slices(const VoxelGrid& grid, const VolumeSummary& summary);

// The direction of the data that points up in the scene.
enum class DataUp { z, minus_z, y, minus_y, x, minus_x };

// A Keeping is a way to keep volume data: one sample for `coarsen` along each axis.
struct Keeping {
    int coarsen = 1;
    std::uint64_t bytes = 0;         // of the samples
    std::uint64_t working_bytes = 0; // with the function through them, as the window holds both
    bool operator==(const Keeping&) const = default;
};
// The ways to keep a box of samples that fit into so much memory, the finest first, at most 8;
// none where none does.
std::vector<Keeping> keepings(GridPart part, std::uint64_t memory_bytes);
// Returns the memory that volume data may take in the window: half of this computer's.
std::uint64_t volume_memory();

// A VolumeOffer is volume data as they are shown before they come into the scene, and how they are
// to stand there.
struct VolumeOffer {
    std::string path;       // absolute
    AddVoxels command;      // as it would be run, but for its transform and its scale
    Ref<AssetStore> assets; // by which it was read
    Ref<VoxelGrid> grid;    // null: it cannot be read so
    Ref<VolumeSummary> summary;
    GridPart part;                  // that was read
    std::vector<Keeping> keepings;  // among which a person chooses
    std::uint64_t memory_bytes = 0; // into which they fit
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

// Whether a person is asked how much is kept: of data of which not all fits, or that are large to
// work on.
bool asks_what_is_kept(const VolumeOffer& offer);
// "1 for 2 per axis, 64.0 MB".
std::string words_of(const Keeping& keeping);
std::string bytes_words(std::uint64_t bytes); // "64.0 MB"

// Reads them, coarsened as `reading` says or further, so far that they fit into the memory. Without
// a head and without sizes in its name a file is read by the likeliest layout.
// Throws Rejected, but for a file without a head, whose offer says what is wrong. Beside the
// window.
VolumeOffer offer_of(const std::string& path, const VolumeReading& reading,
                     const Ref<AssetStore>& assets, std::uint64_t memory_bytes,
                     const Progress& progress);

// The command that brings them into the scene as the offer says.
AddVoxels command_of(const VolumeOffer& offer);
// The sides of the data as they would stand in the scene, metres.
glm::dvec3 size_of(const VolumeOffer& offer);

} // namespace trivar
