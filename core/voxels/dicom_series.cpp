// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/dicom_series.h"

#include "core/base/ordinary_file.h"
#include "core/base/rejected.h"
#include "core/files/file_bytes.h"
#include "core/files/file_sentences.h"
#include "core/voxels/dicom_file.h"
#include "core/voxels/part_taker.h"
#include "core/voxels/slice_order.h"
#include "core/voxels/slice_samples.h"
#include "core/voxels/volume_frame.h"
#include "core/voxels/volume_readers.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fmt/format.h>
#include <functional>
#include <map>
#include <span>

namespace trivar {
namespace {

namespace fs = std::filesystem;

// A file of a series, and its head.
struct SeriesFile {
    std::string name;
    DicomHead head;
};
using SeriesFiles = std::vector<SeriesFile>;

std::size_t slice_count(const SeriesFiles& files)
{
    std::size_t count = 0;
    for (const SeriesFile& file : files) count += file.head.frames.size();
    return count;
}

// Gives the bytes of a file by its name; views stay valid until the next call.
using BytesOf = std::function<std::string_view(const std::string& name)>;

// Makes a volume of the files of one series.
class SeriesReader {
public:
    SeriesReader(const SeriesFiles& files, std::string words, const ReadVolumeOptions& options)
        : files_(files),
          words_(std::move(words)),
          options_(options)
    {
    }

    ReadVolume volume(const BytesOf& bytes_of, const Progress& progress)
    {
        check_alike();
        for (const SeriesFile& file : files_) {
            first_.push_back(slices_.size());
            for (const DicomFrame& frame : file.head.frames) slices_.push_back({frame, file.name});
        }
        first_.push_back(slices_.size());
        SliceOrder order;
        try {
            order = ordered_slices(slices_);
        } catch (const Rejected& rejected) {
            refuse(rejected.what());
        }
        for (const std::string& sentence : order.notices) say(sentence);
        take_samples(bytes_of, order, progress);
        take_place(order);
        take_meaning();
        return {std::move(grid_), {}, part_};
    }

private:
    const DicomHead& first() const { return files_[0].head; }
    [[noreturn]] void refuse(std::string_view reason) const
    {
        throw Rejected(fmt::format("DICOM series {}: {}", words_, reason));
    }
    void say(std::string_view sentence)
    {
        grid_.notices.push_back(fmt::format("DICOM series {}: {}", words_, sentence));
    }

    void check_alike() const
    {
        for (const SeriesFile& file : files_) {
            if (file.head.columns != first().columns || file.head.rows != first().rows)
                refuse(fmt::format("{} has {} x {} pixels, but {} has {} x {}; the slices of a "
                                   "volume have one size",
                                   files_[0].name, first().columns, first().rows, file.name,
                                   file.head.columns, file.head.rows));
            if (file.head.type != first().type)
                refuse(fmt::format("{} has {}, but {} has {}; the slices of a volume have one type",
                                   files_[0].name, words_of(first().type), file.name,
                                   words_of(file.head.type)));
        }
    }

    void take_samples(const BytesOf& bytes_of, const SliceOrder& order, const Progress& progress)
    {
        const std::string name = "DICOM series " + words_;
        SampleBlock block{
            {first().columns, first().rows, static_cast<std::int64_t>(order.at.size())},
            first().type};
        check_block(block, name);
        const auto per_slice =
            static_cast<std::size_t>(first().columns) * static_cast<std::size_t>(first().rows);
        SliceSamples samples(slices_, first_, first().type, per_slice);
        block.type = samples.type();
        PartTaker taker(block, options_, name);
        std::size_t rounded = 0, decoded = 0;
        samples.for_slices(
            order, [&](std::size_t slice) { return taker.wants(static_cast<int>(slice)); },
            [&](std::size_t number) {
                const SeriesFile& file = files_[number];
                report(progress,
                       0.3 + 0.7 * static_cast<double>(decoded++) /
                                 static_cast<double>(files_.size()),
                       "Decoding");
                TakenSamples taken = read_dicom_samples(bytes_of(file.name), file.head, file.name);
                rounded += taken.rounded;
                return std::move(taken.samples);
            },
            [&](const VoxelGrid::Samples& slice) { taker.take_slice(slice); });
        part_ = taker.part();
        grid_.size = part_.size();
        grid_.samples = taker.finish().samples;
        grid_.slope = samples.slope();
        grid_.intercept = samples.intercept();
        if (!samples.scaled_alike())
            say("its slices are scaled differently (RescaleSlope, RescaleIntercept); values are "
                "kept as 32-bit floating point");
        if (const auto sentence = rounded_sentence(rounded, first().type)) say(*sentence);
    }

    void take_place(const SliceOrder& order)
    {
        constexpr double millimetre = 1e-3;
        const DicomFrame& lowest = slices_[order.order[0]].frame;
        const VolumeFrame frame{lowest.position,
                                {lowest.along_row * lowest.spacing.x,
                                 lowest.along_column * lowest.spacing.y, order.step}};
        if (!spans_space(frame)) refuse("its distances and directions do not span space");
        grid_.to_metres = place_of(part_, to_metres_of(frame, millimetre));
        if (!first().spaced)
            say("it does not say how far its pixels are apart (PixelSpacing); 1 mm was taken");
    }

    void take_meaning()
    {
        grid_.value_unit = first().unit;
        if (first().inverted)
            say("low values are meant to be bright (MONOCHROME1); kept as they are");
    }

    const SeriesFiles& files_;
    std::string words_;
    const ReadVolumeOptions& options_;
    std::vector<PlacedSlice> slices_;
    std::vector<std::size_t> first_; // slice of each file, and the end of the last
    VoxelGrid grid_;
    GridPart part_;
};

// The files of a folder with pixels, by their series.
struct FolderSeries {
    std::map<std::string, SeriesFiles> series;
    // The sentences for whole files with pixels that are no slices (colours, no place), by series.
    std::map<std::string, std::vector<std::string>> refused;
};

// Other files of the folder, which may be large, are not read.
bool begins_as_dicom(const std::string& path)
{
    OrdinaryFile file(path);
    std::array<char, 256> begin{};
    std::size_t filled = 0;
    while (const std::size_t count = file.read(std::span(begin).subspan(filled))) filled += count;
    return is_dicom({begin.data(), filled});
}

FolderSeries series_in(const std::string& folder, const std::vector<std::string>& names,
                       const ReadVolumeOptions& options, const Progress& progress)
{
    FolderSeries out;
    std::uintmax_t left = options.max_bytes;
    for (std::size_t k = 0; k < names.size(); ++k) {
        report(progress, 0.3 * static_cast<double>(k) / static_cast<double>(names.size()),
               "Looking for slices");
        const std::string path = (fs::path(folder) / names[k]).string();
        if (!begins_as_dicom(path)) continue;
        const std::string bytes = read_bytes(path, left);
        left -= bytes.size();
        try {
            const DicomHead head = read_dicom_head(bytes, names[k]);
            if (!head.frames.empty()) out.series[head.series].push_back({names[k], head});
        } catch (const Rejected& rejected) {
            out.refused[dicom_series_of(bytes, names[k])].emplace_back(rejected.what());
        }
    }
    return out;
}

// The series that is asked for, else the one with the most slices, else the first by its UID.
std::map<std::string, SeriesFiles>::const_iterator chosen_series(const FolderSeries& all,
                                                                 const ReadVolumeOptions& options)
{
    if (!options.series.empty()) {
        const auto asked = all.series.find(options.series);
        if (asked == all.series.end())
            throw Rejected(fmt::format("the folder has no DICOM series {}", shown(options.series)));
        return asked;
    }
    return std::ranges::max_element(all.series, {},
                                    [](const auto& each) { return slice_count(each.second); });
}

// What a folder of one series often has beside it: a report in colours, a picture without a place.
void say_refused(const FolderSeries& all, VoxelGrid& grid)
{
    std::size_t count = 0;
    std::string first;
    for (const auto& [uid, sentences] : all.refused) {
        count += sentences.size();
        if (first.empty()) first = sentences[0];
    }
    if (count > 0)
        grid.notices.push_back(fmt::format(
            "{} left out that {} of other series ({}{})", counted(count, "file was", "files were"),
            count == 1 ? "is" : "are", count > 1 ? "the first: " : "", first));
}

void say_others(const FolderSeries& all, const std::string& chosen, VoxelGrid& grid)
{
    NameList others;
    for (const auto& [uid, files] : all.series)
        if (uid != chosen)
            others.add(fmt::format("{} ({})", files[0].head.series_words,
                                   counted(slice_count(files), "slice", "slices")));
    if (others.count() > 0)
        grid.notices.push_back(fmt::format("the folder has {} that {} not read: {}",
                                           counted(others.count(), "other series", "other series"),
                                           others.count() == 1 ? "was" : "were", others.text()));
}

} // namespace

std::optional<ReadVolume> read_dicom_folder(const std::string& folder,
                                            const std::vector<std::string>& names,
                                            const ReadVolumeOptions& options,
                                            const Progress& progress)
{
    const FolderSeries all = series_in(folder, names, options, progress);
    if (all.series.empty() && all.refused.empty()) return {};
    if (all.series.empty()) throw Rejected(all.refused.begin()->second[0]);
    const auto chosen = chosen_series(all, options);
    if (const auto refused = all.refused.find(chosen->first); refused != all.refused.end())
        throw Rejected(refused->second[0]);
    const SeriesFiles& files = chosen->second;
    std::string held;
    const BytesOf bytes_of = [&](const std::string& name) -> std::string_view {
        held = read_bytes((fs::path(folder) / name).string(), options.max_bytes);
        return held;
    };
    ReadVolume out =
        SeriesReader(files, files[0].head.series_words, options).volume(bytes_of, progress);
    say_others(all, chosen->first, out.grid);
    say_refused(all, out.grid);
    for (const SeriesFile& file : files) out.companions.push_back(file.name);
    return out;
}

ReadVolume read_dicom_bytes(std::string_view bytes, const std::string& name,
                            const std::string& folder, const ReadVolumeOptions& options,
                            const Progress& progress)
{
    const DicomHead head = read_dicom_head(bytes, name);
    if (head.frames.empty())
        throw Rejected(name + ": this DICOM file has no pixels; open the folder of the slices");
    if (head.frames.size() == 1 && !folder.empty()) {
        ReadVolumeOptions of_series = options;
        of_series.series = head.series;
        std::vector<std::string> names;
        std::error_code error;
        for (fs::directory_iterator at(folder, error), end; !error && at != end;
             at.increment(error))
            if (at->is_regular_file(error)) names.push_back(at->path().filename().string());
        std::ranges::sort(names);
        auto out = read_dicom_folder(folder, names, of_series, progress);
        if (!out) throw Rejected(name + ": its folder has no DICOM files any more");
        std::erase(out->companions, name);
        return std::move(*out);
    }
    const SeriesFiles files{{name, head}};
    return SeriesReader(files, head.series_words, options)
        .volume([&](const std::string&) { return bytes; }, progress);
}

} // namespace trivar
