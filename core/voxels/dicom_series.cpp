// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/dicom_series.h"

#include "core/base/number_text.h"
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

// Whether the slices of two files can be slices of one volume.
bool alike(const DicomHead& a, const DicomHead& b)
{
    return a.columns == b.columns && a.rows == b.rows && a.type == b.type &&
           parallel(a.frames[0], b.frames[0]);
}

// The pixels of a file that cannot be decoded, and why.
struct DamagedPixels {
    std::size_t file;
    std::string why;
};

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
    SeriesReader(const SeriesFiles& files, std::string words, const ReadVolumeOptions& options,
                 int time)
        : files_(files),
          words_(std::move(words)),
          options_(options),
          time_(time)
    {
    }

    // Throws DamagedPixels, too.
    ReadVolume volume(const BytesOf& bytes_of, const Progress& progress)
    {
        for (const SeriesFile& file : files_) {
            first_.push_back(slices_.size());
            for (const DicomFrame& frame : file.head.frames)
                slices_.push_back({frame, file.name, file.head.number});
        }
        first_.push_back(slices_.size());
        SliceOrder order;
        try {
            order = ordered_slices(slices_, time_);
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
                try {
                    TakenSamples taken =
                        read_dicom_samples(bytes_of(file.name), file.head, file.name);
                    rounded += taken.rounded;
                    return std::move(taken.samples);
                } catch (const Rejected& why) {
                    throw DamagedPixels{number, why.what()};
                }
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
    int time_;
    std::vector<PlacedSlice> slices_;
    std::vector<std::size_t> first_; // slice of each file, and the end of the last
    VoxelGrid grid_;
    GridPart part_;
};

// A file that is left out, and why.
struct LeftOut {
    std::string series; // empty: not known
    std::string why;    // begins with the file's name
};

// The files of a folder with pixels, by their series.
struct FolderSeries {
    std::map<std::string, SeriesFiles> series;
    // Damaged files, and whole ones with pixels that are no slices (colours, no place).
    std::vector<LeftOut> left_out;
    bool any = false; // whether there is a DICOM file
};

bool named_as_slice(const std::string& name)
{
    const std::string extension = extension_of(name);
    return extension == ".dcm" || extension == ".dicom" || extension == ".ima";
}

// Other files of the folder, which may be large, are not read.
bool begins_as_dicom(const std::string& path)
{
    OrdinaryFile file(path);
    std::array<char, 256> begin{};
    std::size_t filled = 0;
    while (const std::size_t count = file.read(std::span(begin).subspan(filled))) filled += count;
    return is_dicom({begin.data(), filled});
}

void add_file(FolderSeries& all, const std::string& path, const std::string& name,
              std::uintmax_t& bytes_left)
{
    if (!begins_as_dicom(path)) {
        if (named_as_slice(name))
            all.left_out.push_back({{}, name + ": this is no DICOM file, or its head is missing"});
        return;
    }
    all.any = true;
    const std::string bytes = read_bytes(path, bytes_left);
    bytes_left -= bytes.size();
    try {
        const DicomHead head = read_dicom_head(bytes, name);
        if (!head.frames.empty()) all.series[head.series].push_back({name, head});
    } catch (const Rejected& rejected) {
        all.left_out.push_back({{}, rejected.what()});
        all.left_out.back().series = dicom_series_of(bytes, name); // throws where it is damaged
    }
}

FolderSeries series_in(const std::string& folder, const std::vector<std::string>& names,
                       const ReadVolumeOptions& options, const Progress& progress)
{
    FolderSeries out;
    std::uintmax_t left = options.max_bytes;
    for (std::size_t k = 0; k < names.size(); ++k) {
        report(progress, 0.3 * static_cast<double>(k) / static_cast<double>(names.size()),
               "Looking for slices");
        const std::size_t before = out.left_out.size();
        try {
            add_file(out, (fs::path(folder) / names[k]).string(), names[k], left);
        } catch (const Rejected& why) { // it cannot be opened or is damaged
            if (out.left_out.size() == before) out.left_out.push_back({{}, why.what()});
        }
    }
    return out;
}

// The series that is asked for, else the one with the most slices, else the first by its UID.
std::map<std::string, SeriesFiles>::const_iterator chosen_series(const FolderSeries& all,
                                                                 const ReadVolumeOptions& options)
{
    if (options.series.empty())
        return std::ranges::max_element(all.series, {},
                                        [](const auto& each) { return slice_count(each.second); });
    const auto asked = all.series.find(options.series);
    if (asked != all.series.end()) return asked;
    for (const LeftOut& each : all.left_out)
        if (each.series == options.series) throw Rejected(each.why);
    throw Rejected(fmt::format("the folder has no DICOM series {}", shown(options.series)));
}

// The files of a series that make one volume; the names of the others are added to `others`.
SeriesFiles one_volume(const SeriesFiles& files, const std::string& chosen, NameList& others)
{
    std::vector<SeriesFiles> groups;
    std::size_t taken = 0;
    bool found = false;
    for (const SeriesFile& file : files) {
        const auto group = std::ranges::find_if(
            groups, [&](const SeriesFiles& each) { return alike(each[0].head, file.head); });
        const auto at = static_cast<std::size_t>(group - groups.begin());
        if (group == groups.end()) groups.emplace_back();
        groups[at].push_back(file);
        if (file.name == chosen) taken = at;
        found = found || file.name == chosen;
    }
    if (!found)
        taken = static_cast<std::size_t>(std::ranges::max_element(groups, {}, slice_count) -
                                         groups.begin());
    for (std::size_t k = 0; k < groups.size(); ++k)
        for (const SeriesFile& file : groups[k])
            if (k != taken) others.add(file.name);
    return groups[taken];
}

// Adds a notice of the files that are damaged or no slices and may have been meant as some.
void say_left_out(const FolderSeries& all, VoxelGrid& grid)
{
    const std::size_t count = all.left_out.size();
    if (count > 0)
        grid.notices.push_back(fmt::format("{} left out ({}{})",
                                           counted(count, "file was", "files were"),
                                           count > 1 ? "the first: " : "", all.left_out[0].why));
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

std::vector<std::string> files_in(const std::string& folder)
{
    constexpr std::size_t most = 20'000;
    std::vector<std::string> names;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
        if (!at->is_regular_file(error)) continue;
        names.push_back(at->path().filename().string());
        if (names.size() > most)
            throw Rejected(fmt::format("{}: has more than {} files; a volume has fewer slices",
                                       folder, with_commas(most)));
    }
    if (error) throw Rejected(fmt::format("{}: {}", folder, error.message()));
    std::ranges::sort(names);
    return names;
}

std::optional<ReadVolume> read_dicom_folder(const std::string& folder,
                                            const std::vector<std::string>& names,
                                            const ReadVolumeOptions& options, int time,
                                            const Progress& progress, const std::string& chosen)
{
    constexpr std::size_t most_again = 16; // times, since each begins from the first slice
    FolderSeries all = series_in(folder, names, options, progress);
    if (all.series.empty() && (!all.any || all.left_out.empty())) return {};
    if (all.series.empty()) throw Rejected(all.left_out[0].why);
    const auto series = chosen_series(all, options);
    NameList others;
    SeriesFiles files = one_volume(series->second, chosen, others);
    std::string held;
    const BytesOf bytes_of = [&](const std::string& name) -> std::string_view {
        held = read_bytes((fs::path(folder) / name).string(), options.max_bytes);
        return held;
    };
    ReadVolume out;
    for (std::size_t again = 0;; ++again) try {
            for (const LeftOut& each : all.left_out)
                if (slice_count(files) < 2 && (each.series.empty() || each.series == series->first))
                    throw Rejected(each.why);
            out = SeriesReader(files, series->second[0].head.series_words, options, time)
                      .volume(bytes_of, progress);
            break;
        } catch (const DamagedPixels& damaged) {
            // Slices that were given already cannot be taken back.
            if (again == most_again || options.each_slice || files[damaged.file].name == chosen)
                throw Rejected(damaged.why);
            all.left_out.push_back({series->first, damaged.why});
            files.erase(files.begin() + static_cast<std::ptrdiff_t>(damaged.file));
        }
    if (others.count() > 0)
        out.grid.notices.push_back(
            fmt::format("{} of other size, type, direction or distance of pixels {} left out: {}",
                        counted(others.count(), "slice", "slices"),
                        others.count() == 1 ? "was" : "were", others.text()));
    say_others(all, series->first, out.grid);
    say_left_out(all, out.grid);
    for (const SeriesFile& file : files) out.companions.push_back(file.name);
    return out;
}

ReadVolume read_dicom_bytes(std::string_view bytes, const std::string& name,
                            const std::string& folder, const ReadVolumeOptions& options, int time,
                            const Progress& progress)
{
    const DicomHead head = read_dicom_head(bytes, name);
    if (head.frames.empty())
        throw Rejected(name + ": this DICOM file has no pixels; open the folder of the slices");
    if (head.frames.size() == 1 && !folder.empty()) {
        ReadVolumeOptions of_series = options;
        of_series.series = head.series;
        auto out = read_dicom_folder(folder, files_in(folder), of_series, time, progress, name);
        if (!out) throw Rejected(name + ": its folder has no DICOM files any more");
        std::erase(out->companions, name);
        return std::move(*out);
    }
    const SeriesFiles files{{name, head}};
    try {
        return SeriesReader(files, head.series_words, options, time)
            .volume([&](const std::string&) { return bytes; }, progress);
    } catch (const DamagedPixels& damaged) {
        throw Rejected(damaged.why);
    }
}

std::vector<std::string> dicom_series_in(const std::string& folder)
{
    std::vector<std::string> out;
    for (const auto& [uid, files] : series_in(folder, files_in(folder), {}, {}).series)
        out.push_back(fmt::format(
            "{}{}{}, {}", files[0].head.series_words, files[0].head.modality.empty() ? "" : ", ",
            shown(files[0].head.modality), counted(slice_count(files), "slice", "slices")));
    return out;
}

} // namespace trivar
