// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/record/sequence.h"

#include "core/base/digest.h"
#include "core/base/rejected.h"
#include "core/base/whole_numbers.h"
#include "core/files/file_bytes.h"
#include "core/files/pictures/image.h"
#include "core/scene/files_read.h"
#include "editor/help/about.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <variant>

namespace trivar {
namespace {

constexpr const char *tag_log = "trivar:log", *tag_frame = "trivar:frame",
                     *tag_settings = "trivar:settings";
constexpr int most_frames = 1'000'000; // of one sequence: eleven hours at 24 frames a second

ImageTags tags_of(const Sequence& sequence, int frame)
{
    ImageTags tags{{tag_log, sequence.log}, {tag_frame, std::to_string(frame)}};
    if (!sequence.settings.empty()) tags.emplace_back(tag_settings, sequence.settings);
    return tags;
}

} // namespace

std::string FrameNames::path(int frame) const
{
    return fmt::format("{}{}{:0{}}{}", before, frame < 0 ? "-" : "", std::abs(frame), digits,
                       after);
}

std::string FrameNames::folder() const
{
    const std::string folder = std::filesystem::path(before + "0").parent_path().string();
    return folder.empty() ? "." : folder;
}

std::string FrameNames::extension() const
{
    return extension_of("0" + after);
}

FrameNames frame_names(const std::string& text)
{
    const std::size_t slash = text.rfind('/');
    const std::size_t first = text.find('#', slash == std::string::npos ? 0 : slash);
    if (first == std::string::npos)
        throw Rejected(
            text +
            ": the name needs #### in place of the frame number, as in pictures/ants.####.png");
    const std::size_t past = std::min(text.find_first_not_of('#', first), text.size());
    const FrameNames names{text.substr(0, first), text.substr(past),
                           static_cast<int>(past - first)};
    if (names.after.find('#') != std::string::npos || names.digits > 9)
        throw Rejected(text + ": the # of the frame number must stand together, nine at most");
    if (names.extension() != ".png" && names.extension() != ".exr")
        throw Rejected(fmt::format("{}: frames are written as .png or .exr, not as '{}'", text,
                                   names.extension()));
    return names;
}

std::vector<int> frames_of(std::string_view text)
{
    const std::vector<int> n = whole_numbers(text, ':');
    if (n.empty() || n.size() > 3)
        throw Rejected(
            fmt::format("--frames {}: must be A:B or A:B:S, such as 1:240 or 1:240:2", text));
    const long first = n[0], last = n.size() > 1 ? n[1] : first, step = n.size() > 2 ? n[2] : 1;
    if (last < first || step < 1)
        throw Rejected(fmt::format(
            "--frames {}: the last frame comes before the first, or the step is below 1", text));
    if ((last - first) / step >= most_frames)
        throw Rejected(
            fmt::format("--frames {}: these are more than {} frames", text, most_frames));
    std::vector<int> frames;
    for (long frame = first; frame <= last; frame += step)
        frames.push_back(static_cast<int>(frame));
    return frames;
}

void check_frames(const std::vector<int>& frames, const Time& time)
{
    for (const int frame : frames)
        if (frame < time.first_frame || frame > time.last_frame)
            throw Rejected(fmt::format("the scene has no frame {}; its frames are {} to {}", frame,
                                       time.first_frame, time.last_frame));
}

std::vector<int> share_of(const std::vector<int>& frames, std::string_view shard)
{
    const std::vector<int> n = whole_numbers(shard, '/');
    if (n.size() != 2 || n[0] < 1 || n[0] > n[1])
        throw Rejected(
            fmt::format("--shard {}: must be I/N with I from 1 to N, such as 1/4", shard));
    std::vector<int> share;
    const auto every = static_cast<std::size_t>(n[1]);
    for (auto k = static_cast<std::size_t>(n[0]) - 1; k < frames.size(); k += every)
        share.push_back(frames[k]);
    return share;
}

bool Sequence::has(int frame, PictureReader& reader) const
{
    const std::string path = names.path(frame);
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) return false;
    try {
        const ImageHead head = reader.head(path, {tag_log, tag_frame, tag_settings});
        const int bits = names.extension() == ".exr" ? 16 : depth;
        return head.size_px == size_px && head.bits == bits && head.tags == tags_of(*this, frame);
    } catch (const Rejected&) {
        return false; // cut short, or no picture
    }
}

int Sequence::gone(const std::vector<int>& frames) const
{
    return static_cast<int>(std::ranges::count_if(frames, [&](int frame) {
        std::error_code ignored;
        return !std::filesystem::is_regular_file(names.path(frame), ignored);
    }));
}

std::function<void()> Sequence::writer(int frame, const Still& still) const
{
    const auto write = [*this, frame](const auto& image) {
        write_bytes(names.path(frame),
                    encoded_image(image, names.extension(), tags_of(*this, frame)));
    };
    if (deep()) return [write, image = make_ref(still.deep_image())] { write(*image); };
    return [write, image = make_ref(still.image())] { write(*image); };
}

std::string sequence_settings(std::string drawn, const Document& document, const AssetStore& assets,
                              const Ref<gpu::ShaderTexts>& shaders, bool missing_is_well)
{
    drawn += " version=" + program_version();
    if (shaders) {
        Digest digest;
        for (const auto& [file, text] : *shaders) {
            digest.add_text(file);
            digest.add_text(text);
        }
        drawn += " shaders=" + digest.hex();
    }
    if (const std::string files = digest_of_files(document, assets, missing_is_well);
        !files.empty())
        drawn += " files=" + files;
    return drawn;
}

std::string digest_of_log(std::string_view text)
{
    Digest digest;
    digest.add_bytes(std::as_bytes(std::span(text)));
    return digest.hex();
}

void make_folder_of(const std::string& file)
{
    const std::string parent = std::filesystem::path(file).parent_path().string();
    const std::string folder = parent.empty() ? "." : parent;
    std::error_code error;
    if (std::filesystem::is_directory(folder, error)) return;
    std::filesystem::create_directory(folder, error);
    if (error)
        throw Rejected(fmt::format("{}: the folder does not exist and cannot be created ({})",
                                   folder, error.message()));
}

std::string time_left(int done, int of, double seconds)
{
    if (done == 0 || done >= of) return {};
    const double left = seconds / done * (of - done);
    if (left < 90) return fmt::format("{:.0f} s left", std::max(1.0, left));
    if (left < 5400) return fmt::format("{:.0f} min left", left / 60);
    return fmt::format("{:.1f} h left", left / 3600);
}

} // namespace trivar
