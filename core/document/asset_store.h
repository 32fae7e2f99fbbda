// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/document/document.h"
#include "core/mesh/grey_image.h"
#include "core/mesh/model.h"
#include "core/voxels/volume_options.h"
#include "core/voxels/volume_summary.h"

#include <array>
#include <map>
#include <memory>
#include <string>

namespace trivar {

// An AssetStore turns an ImportedFile into a Model. Paths are relative to `folder`; `relinked`
// replaces the path of a file by another one (--set NAME=FILE, where NAME is the path or its file
// name). A model is read once and kept, without its subdivision. Thread-safe.
class AssetStore {
public:
    explicit AssetStore(std::string folder, std::map<std::string, std::string> relinked = {});
    ~AssetStore();
    AssetStore(const AssetStore&) = delete;
    AssetStore& operator=(const AssetStore&) = delete;

    struct LoadedModel {
        Ref<Model> model;    // null: missing or unreadable
        std::string hash;    // of the file's content; empty: missing
        std::string content; // digest of the file and of all files that it names
        // why it is missing, that its content is not the expected one, what was repaired
        std::vector<std::string> notices;
    };
    // Throws Cancelled only.
    LoadedModel load(const ImportedFile& file, const Progress& progress = {}) const;
    struct LoadedImage {
        Ref<GreyImage> image; // null: missing or unreadable
        std::string hash;     // of the file's content; empty: missing
        std::vector<std::string> notices;
    };
    // A picture of a mask or of heights, with the hash that it is expected to have; empty: any. It
    // is read once and kept.
    LoadedImage load_image(const std::string& path, const std::string& hash) const;
    struct LoadedVolume {
        Ref<VoxelGrid> grid;                 // null: missing or unreadable
        Ref<VolumeSummary> summary;          // of the grid, if there is one
        std::string hash;                    // of the contents of all its files; empty: missing
        std::vector<std::string> companions; // files beside the one that is named, or in the folder
        std::vector<std::string> notices;
    };
    // Volume data, with the hash that they are expected to have; empty: any. They are read once and
    // kept. Throws Cancelled only.
    LoadedVolume load_volume(const std::string& path, const std::string& hash,
                             const Progress& progress = {},
                             const VolumeReading& reading = {}) const;
    // The part of volume data that load_volume() reads so, by their heads alone. Throws Rejected
    // and Cancelled.
    GridPart part_of_volume(const std::string& path, const VolumeReading& reading,
                            const Progress& progress = {}) const;
    void forget(const std::string& path) const; // reads the file again when it is next asked for
    std::string resolve(const std::string& path) const; // the file that would be opened
    // The names by which --set may call the file of that path: the path itself, or its last part.
    static std::array<std::string, 2> names_of(const std::string& path);
    const std::string& folder() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace trivar
