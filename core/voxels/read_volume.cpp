// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/read_volume.h"

#include "core/base/number_text.h"
#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/files/file_bytes.h"
#include "core/files/file_sentences.h"
#include "core/voxels/dicom_file.h"
#include "core/voxels/dicom_series.h"
#include "core/voxels/image_stack.h"
#include "core/voxels/inflate.h"
#include "core/voxels/meta_header.h"
#include "core/voxels/nifti_header.h"
#include "core/voxels/volume_readers.h"
#include "core/voxels/vti_header.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <limits>
#include <type_traits>

namespace trivar {
namespace {

namespace fs = std::filesystem;

using Reader = ReadVolume (*)(VolumeSource&, const ReadVolumeOptions&);

bool is_packed_nifti(std::string_view bytes)
{
    return is_gzip(bytes) && is_nifti(first_unpacked(bytes, nifti2_head_bytes));
}

// The reader by the first bytes; files without a head have only their name. Null: none.
Reader reader_for(std::string_view bytes, const std::string& name)
{
    if (bytes.starts_with("NRRD")) return read_nrrd;
    if (is_nifti(bytes) || is_packed_nifti(bytes)) return read_nifti;
    if (bytes.starts_with("# vtk DataFile")) return read_legacy_vtk;
    if (is_vti(bytes)) return read_vti;
    if (is_meta_image(bytes)) return read_meta_image;
    const std::string extension = extension_of(name);
    if (extension == ".raw" || extension == ".bin" || extension == ".dat" || extension == ".vol")
        return read_raw;
    return nullptr;
}

void check_options(const ReadVolumeOptions& options, int time)
{
    if (time < 1) throw Rejected(fmt::format("times are counted from 1; there is no {}", time));
    const auto sound = [](double value) { return value >= 1e-12 && value <= 1e12; };
    if (options.metres_per_unit && !sound(*options.metres_per_unit))
        throw Rejected(fmt::format("the unit must be from 1e-12 to 1e12 metres, not {}",
                                   *options.metres_per_unit));
    for (int k = 0; k < 3; ++k)
        if (!sound(options.spacing[k]))
            throw Rejected(fmt::format("samples must be 1e-12 to 1e12 units apart, not {}",
                                       options.spacing[k]));
}

constexpr float greatest_value = 1e30f;

// Values further from 0 mark places without data.
bool is_bad(float sample)
{
    return !(std::abs(sample) <= greatest_value);
}

struct SampleCount {
    std::size_t bad = 0;
    float least = greatest_value, greatest = -greatest_value; // of the others
};

SampleCount count_samples(const std::vector<float>& samples)
{
    constexpr std::size_t per_part = std::size_t{1} << 20;
    std::vector<SampleCount> parts(samples.size() / per_part + 1);
    parallel_blocks(samples.size(), per_part, [&](std::size_t begin, std::size_t end) {
        SampleCount& part = parts[begin / per_part];
        for (std::size_t i = begin; i < end; ++i) {
            if (is_bad(samples[i])) {
                part.bad += 1;
                continue;
            }
            part.least = std::min(part.least, samples[i]);
            part.greatest = std::max(part.greatest, samples[i]);
        }
    });
    SampleCount all;
    for (const SampleCount& part : parts) {
        all.bad += part.bad;
        all.least = std::min(all.least, part.least);
        all.greatest = std::max(all.greatest, part.greatest);
    }
    return all;
}

// One sample that is not a number would reach every coefficient of the spline, and squares of
// slopes of very great or small samples would overflow or vanish.
// Returns the greatest size of a sample then.
float make_tame(std::vector<float>& samples, VoxelGrid& grid, const std::string& name)
{
    constexpr int most_doublings = 40; // from 1, of the greatest sample
    if (samples.empty()) return 0;     // the head alone was read
    const SampleCount count = count_samples(samples);
    if (count.bad == samples.size())
        throw Rejected(fmt::format("{}: none of its samples is a finite number", name));
    if (count.bad > 0) {
        const float instead = grid.slope < 0 ? count.greatest : count.least;
        std::ranges::replace_if(samples, is_bad, instead);
        grid.notices.push_back(fmt::format(
            "{}: {} of its samples {} not a number, infinite or beyond 1e30; the least value, "
            "{}, stands for {}",
            name, with_commas(count.bad), count.bad == 1 ? "is" : "are",
            number_text(grid.value(instead), {.digits = 6}), count.bad == 1 ? "it" : "them"));
    }
    const float most = std::max(std::abs(count.least), std::abs(count.greatest));
    const int doublings = most > 0 ? std::ilogb(most) : 0;
    if (std::abs(doublings) <= most_doublings) return most;
    for (float& sample : samples) sample = std::ldexp(sample, -doublings);
    grid.slope = std::ldexp(grid.slope, doublings);
    return std::ldexp(most, -doublings);
}

void make_tame(VoxelGrid& grid, const std::string& name)
{
    constexpr int most_along_an_axis = 1'000'000; // vertices of surfaces are numbered by 20 bits
    if (const int most = std::max({grid.size.x, grid.size.y, grid.size.z});
        most > most_along_an_axis)
        throw Rejected(fmt::format("{}: has {} samples along an axis; at most {} are taken", name,
                                   with_commas(static_cast<std::size_t>(most)),
                                   with_commas(most_along_an_axis)));
    auto* floats = std::get_if<std::vector<float>>(&grid.samples);
    const float most_float = floats ? make_tame(*floats, grid, name) : 0;
    // The greatest value: for integers, the limit of their type.
    const double most = std::visit(
        [&](const auto& samples) {
            using Sample = typename std::decay_t<decltype(samples)>::value_type;
            return std::is_integral_v<Sample>
                       ? static_cast<double>(std::numeric_limits<Sample>::max()) + 1
                       : double{most_float};
        },
        grid.samples);
    const double value = std::abs(grid.slope) * most + std::abs(grid.intercept);
    if (!(value <= greatest_value))
        throw Rejected(fmt::format("{}: its values reach {}; at most 1e30 is taken", name,
                                   number_text(value)));
}

ReadVolume read_folder(const std::string& folder, const ReadVolumeOptions& options,
                       const Progress& progress, int time)
{
    const std::vector<std::string> names = files_in(folder);
    if (auto series = read_dicom_folder(folder, names, options, time, progress))
        return std::move(*series);
    std::vector<std::string> pictures;
    std::ranges::copy_if(names, std::back_inserter(pictures), may_be_slice);
    if (pictures.empty())
        throw Rejected(fmt::format("{}: this folder has no DICOM files and no pictures",
                                   shown(fs::path(folder).filename().string())));
    return read_image_stack(folder, pictures, options, progress);
}

ReadVolume read_file(const ByteFile& bytes, const std::string& name, const std::string& folder,
                     const ReadVolumeOptions& options, const Progress& progress, int time)
{
    const std::string file = fs::path(name).filename().string();
    if (bytes.size() == 0) throw Rejected(file + ": the file is empty");
    report(progress, 0, "Reading");
    VolumeSource source(bytes, file, folder, options, progress, time);
    ReadVolume out;
    if (!options.raw && is_dicom(source.head())) {
        out = read_dicom_bytes(source.bytes(), file, folder, options, time, progress);
    } else {
        const Reader reader = options.raw ? read_raw : reader_for(source.head(), file);
        if (!reader)
            throw Rejected(fmt::format(
                "{}: this is no volume that can be read: NRRD, NIfTI (.nii, .nii.gz, .hdr), "
                "MetaImage (.mha, .mhd), VTK (.vtk, .vti), DICOM, .raw, or a folder of DICOM files "
                "or pictures",
                file));
        out = reader(source, options);
        out.grid.notices = source.notices();
        out.companions = source.companions();
    }
    make_tame(out.grid, file);
    report(progress, 1, "Done");
    return out;
}

} // namespace

ReadVolume read_volume_bytes(std::string_view bytes, const std::string& name,
                             const std::string& folder, const ReadVolumeOptions& options,
                             const Progress& progress)
{
    check_options(options, 1);
    return read_file(ByteFile(bytes), name, folder, options, progress, 1);
}

bool is_volume_file(const std::string& path)
{
    constexpr std::uint64_t begin = 4096;
    try {
        std::string buffer;
        const std::string_view head = ByteFile::opened(path).part(0, begin, buffer);
        return is_dicom(head) || reader_for(head, path);
    } catch (const Rejected&) {
        return false;
    }
}

ReadVolume read_volume(const std::string& path, const ReadVolumeOptions& options,
                       const Progress& progress, int time)
{
    check_options(options, time);
    report(progress, 0, "Opening");
    std::error_code error;
    const fs::path absolute = fs::absolute(path).lexically_normal();
    if (fs::is_directory(absolute, error)) {
        const fs::path folder = absolute.has_filename() ? absolute : absolute.parent_path();
        ReadVolume out = read_folder(folder.string(), options, progress, time);
        make_tame(out.grid, folder.filename().string());
        return out;
    }
    const ByteFile file = ByteFile::opened(path);
    const std::string folder = absolute.parent_path().string();
    // The samples of a NIfTI or Analyze volume beside its head.
    std::string begin;
    if (extension_of(path) == ".img" && !options.raw &&
        !is_nifti(file.part(0, nifti2_head_bytes, begin))) {
        const fs::path head = fs::path(absolute).replace_extension(".hdr");
        if (fs::is_regular_file(head, error)) {
            ReadVolume out = read_file(ByteFile::opened(head.string()), head.string(), folder,
                                       options, progress, time);
            std::erase(out.companions, absolute.filename().string());
            out.companions.push_back(head.filename().string());
            return out;
        }
    }
    return read_file(file, path, folder, options, progress, time);
}

} // namespace trivar
