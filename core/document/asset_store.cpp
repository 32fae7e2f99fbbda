// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/asset_store.h"

#include "core/base/digest.h"
#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/files/companions.h"
#include "core/files/file_bytes.h"
#include "core/files/pictures/image.h"
#include "core/files/sample_models.h"
#include "core/voxels/read_volume.h"

#include <filesystem>
#include <fmt/format.h>
#include <mutex>
#include <tuple>

namespace trivar {

namespace {

// Hashes the file, or returns a word if there is none, so that a model stays valid if a file that
// it names vanishes while it is read.
std::string hash_if_there(const std::string& path)
{
    try {
        return file_hash(path);
    } catch (const Rejected&) {
        return "missing";
    }
}

std::string content_of(const std::string& path, const std::string& hash)
{
    const std::vector<std::string> companions = companions_of(path);
    if (companions.empty()) return hash;
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    Digest digest;
    digest.add_text(hash);
    for (const std::string& name : companions) {
        digest.add_text(name);
        digest.add_text(hash_if_there((folder / name).string()));
    }
    return digest.hex();
}

// The hash of a file, or of all files that a volume was read from.
std::string hash_of_volume(const std::string& path, const std::vector<std::string>& companions)
{
    if (companions.empty()) return file_hash(path);
    const bool is_folder = std::filesystem::is_directory(path);
    const std::filesystem::path folder =
        is_folder ? std::filesystem::path(path) : std::filesystem::path(path).parent_path();
    Digest digest;
    if (!is_folder) digest.add_text(file_hash(path));
    for (const std::string& name : companions) {
        digest.add_text(name);
        digest.add_text(hash_if_there((folder / name).string()));
    }
    return digest.hex();
}

ReadVolumeOptions options_of(const VolumeReading& reading)
{
    ReadVolumeOptions options;
    options.spacing = reading.spacing_mm;
    options.coarsen = reading.coarsen;
    if (reading.size.x > 0)
        options.raw = RawLayout{{{reading.size.x, reading.size.y, reading.size.z}, reading.type},
                                reading.order,
                                static_cast<std::uint64_t>(reading.header_bytes)};
    return options;
}

std::string key_of(const VolumeReading& r)
{
    return fmt::format("{} {} {} {} {} {} {} {} {} {}", r.size.x, r.size.y, r.size.z,
                       static_cast<int>(r.type), static_cast<int>(r.order), r.header_bytes,
                       r.spacing_mm.x, r.spacing_mm.y, r.spacing_mm.z, r.coarsen);
}

} // namespace

struct AssetStore::State {
    std::string folder;
    std::map<std::string, std::string> relinked;
    using Key = std::tuple<std::string, UpAxis, double>; // the path, and how the file was read
    std::map<Key, LoadedModel> loaded;
    std::map<std::string, LoadedImage> images;                           // by path
    std::map<std::pair<std::string, std::string>, LoadedVolume> volumes; // by path and reading
    std::mutex mutex;
};

AssetStore::AssetStore(std::string folder, std::map<std::string, std::string> relinked)
    : state_(std::make_unique<State>())
{
    state_->folder = std::move(folder);
    state_->relinked = std::move(relinked);
}

AssetStore::~AssetStore() = default;

const std::string& AssetStore::folder() const
{
    return state_->folder;
}

std::array<std::string, 2> AssetStore::names_of(const std::string& path)
{
    return {path, std::filesystem::path(path).filename().string()};
}

std::string AssetStore::resolve(const std::string& path) const
{
    const std::filesystem::path named(path);
    for (const std::string& name : names_of(path))
        if (const auto found = state_->relinked.find(name); found != state_->relinked.end())
            return found->second;
    if (named.is_absolute()) return path;
    return (std::filesystem::path(state_->folder) / named).lexically_normal().string();
}

AssetStore::LoadedModel AssetStore::load(const ImportedFile& file, const Progress& progress) const
{
    const std::string path = resolve(file.path);
    // The lock is held while reading, so that two threads do not both read the same large file.
    const std::lock_guard guard(state_->mutex);
    const auto [entry, fresh] = state_->loaded.try_emplace({path, file.up, file.scale});
    if (fresh) try {
            make_sample_model(path, progress);
            entry->second.hash = entry->second.content = file_hash(path);
            Model model = read_model(path, {.up = file.up, .scale = file.scale}, progress);
            entry->second.content = content_of(path, entry->second.hash);
            entry->second.notices = model.notices;
            entry->second.model = make_ref(std::move(model));
        } catch (const Rejected& error) {
            entry->second.notices = {short_sentence(error.what())};
        } catch (...) {
            state_->loaded.erase(entry);
            throw;
        }
    LoadedModel result = entry->second;
    if (result.model && !file.hash.empty() && file.hash != result.hash)
        result.notices.push_back(
            fmt::format("{}: the file has changed since this scene was made", file.path));
    // A missing file is not remembered, because it may come back, when a disk is plugged in for
    // example.
    if (result.hash.empty()) state_->loaded.erase(entry);
    return result;
}

AssetStore::LoadedImage AssetStore::load_image(const std::string& name,
                                               const std::string& hash) const
{
    const std::string path = resolve(name);
    const std::lock_guard guard(state_->mutex);
    const auto [entry, fresh] = state_->images.try_emplace(path);
    LoadedImage& kept = entry->second;
    if (fresh) try {
            make_sample_model(path);
            kept.hash = file_hash(path);
            GreyImage image = read_grey_image(path);
            if (image.no_numbers > 0)
                kept.notices = {fmt::format("{}: {} of its pixels {} no numbers and count as 0",
                                            name, with_commas(image.no_numbers),
                                            image.no_numbers == 1 ? "is" : "are")};
            kept.image = make_ref(std::move(image));
        } catch (const Rejected& error) {
            kept.notices = {short_sentence(error.what())};
        } catch (...) {
            state_->images.erase(entry);
            throw;
        }
    LoadedImage result = kept;
    if (result.image && !hash.empty() && hash != result.hash)
        result.notices.push_back(
            fmt::format("{}: the file has changed since this scene was made", name));
    if (result.hash.empty()) state_->images.erase(entry); // it may come back
    return result;
}

AssetStore::LoadedVolume AssetStore::load_volume(const std::string& name, const std::string& hash,
                                                 const Progress& progress,
                                                 const VolumeReading& reading) const
{
    const std::string path = resolve(name);
    const std::lock_guard guard(state_->mutex);
    const auto [entry, fresh] = state_->volumes.try_emplace({path, key_of(reading)});
    LoadedVolume& kept = entry->second;
    if (fresh) try {
            make_sample_model(path, progress);
            ReadVolume read = read_volume(path, options_of(reading), progress);
            kept.hash = hash_of_volume(path, read.companions);
            kept.notices = read.grid.notices;
            kept.companions = std::move(read.companions);
            kept.summary = make_ref(summary_of(read.grid));
            kept.grid = make_ref(std::move(read.grid));
        } catch (const Rejected& error) {
            kept.notices = {short_sentence(error.what())};
        } catch (...) {
            state_->volumes.erase(entry);
            throw;
        }
    LoadedVolume result = kept;
    if (result.grid && !hash.empty() && hash != result.hash)
        result.notices.push_back(
            fmt::format("{}: the file has changed since this scene was made", name));
    if (result.hash.empty()) state_->volumes.erase(entry); // it may come back
    return result;
}

GridPart AssetStore::part_of_volume(const std::string& name, const VolumeReading& reading,
                                    const Progress& progress) const
{
    const std::string path = resolve(name);
    const std::lock_guard guard(state_->mutex);
    make_sample_model(path, progress);
    ReadVolumeOptions options = options_of(reading);
    options.head_only = true;
    return read_volume(path, options, progress).part;
}

void AssetStore::forget(const std::string& path) const
{
    const std::lock_guard guard(state_->mutex);
    std::erase_if(state_->loaded, [file = resolve(path)](const auto& entry) {
        return std::get<0>(entry.first) == file;
    });
    state_->images.erase(resolve(path));
    std::erase_if(state_->volumes,
                  [file = resolve(path)](const auto& entry) { return entry.first.first == file; });
}

} // namespace trivar
