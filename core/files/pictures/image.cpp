// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/pictures/image.h"

#include "core/base/rejected.h"
#include "core/files/file_bytes.h"
#include "core/files/pictures/codec_plugin.h"
#include "core/files/pictures/decoder_process.h"
#include "core/files/pictures/kinds.h"
#include "core/files/pictures/pixels.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>

namespace trivar {
namespace {

constexpr std::uintmax_t max_file_bytes = std::uintmax_t{1} << 30;

// Returns the limits of decoding a picture in the helper process. Time is for a slow four million
// pixels per second; memory is for the pixels, if they are not delivered in rows, which matters for
// large files only.
DecoderLimits limits_of(const PictureHead& head, std::size_t file_bytes)
{
    constexpr std::uint64_t least_memory = std::uint64_t{384} << 20, memory_a_byte = 64;
    constexpr std::uint32_t least_s = 3;
    const std::uint64_t pixels =
        static_cast<std::uint64_t>(head.size_px.x) * static_cast<unsigned>(head.size_px.y);
    return {std::max(least_memory, memory_a_byte * file_bytes),
            least_s + static_cast<std::uint32_t>(pixels >> 22)};
}

const Codec& codec_for(const std::string& name, const std::string& extension)
try {
    const Codec& codec = picture_codec();
    if (codec.writes(extension)) return codec;
    throw Rejected(fmt::format("cannot be written as '{}'; use png, jpg or exr", extension));
} catch (const Rejected& rejected) {
    throw Rejected(
        fmt::format("{}: pictures {}", name.empty() ? "picture" : name, rejected.what()));
}

std::string encoded(const EncodeTask& task, const std::string& name)
{
    std::string bytes =
        task.extension == ".png" ? png_file(task) : codec_for(name, task.extension).encode(task);
    if (bytes.empty())
        throw Rejected(fmt::format("{}: {} x {} pixels cannot be written as {}",
                                   name.empty() ? "picture" : name, task.size_px.x, task.size_px.y,
                                   task.extension));
    return bytes;
}

} // namespace

PictureReader::PictureReader() = default;
PictureReader::~PictureReader() = default;
PictureReader::PictureReader(PictureReader&&) noexcept = default;
PictureReader& PictureReader::operator=(PictureReader&&) noexcept = default;

DecodeResult PictureReader::decoded(std::string_view bytes, const std::string& name,
                                    const std::vector<std::string>& tags, const TakeRows& take,
                                    bool numbers)
{
    const PictureKind& kind = picture_kind(bytes, name);
    const PictureHead head = picture_head(bytes, name, Look::whole);
    const DecodeTask task{bytes, kind.format, head.size_px, tags, numbers};
    const std::uint64_t row = 4 * static_cast<std::uint64_t>(head.size_px.x);
    const std::uint64_t all = row * static_cast<unsigned>(head.size_px.y);
    std::uint64_t taken = 0;
    const TakeRows take_known = [&](std::span<const std::uint8_t> rows) {
        if (rows.size() > all - taken)
            throw Rejected("is damaged: it has more pixels than it says");
        taken += rows.size();
        take(rows);
    };
    std::string reason;
    try {
        if (!kind.decode && (!apart_ || apart_->ended()))
            apart_ = std::make_unique<DecoderProcess>();
        DecodeResult result = kind.decode
                                  ? kind.decode(task, take_known)
                                  : apart_->decode(task, limits_of(head, bytes.size()), take_known);
        if (result.whole && taken == all) return result;
        reason = fmt::format("is damaged: of its {} rows of pixels {} can be decoded",
                             head.size_px.y, taken / row);
    } catch (const Rejected& rejected) {
        reason = rejected.what();
    }
    throw Rejected(fmt::format("{}: this {} picture {}", name, kind.word, reason));
}

Image PictureReader::read_bytes(std::string_view bytes, const std::string& name)
{
    Image image;
    image.name = std::filesystem::path(name).filename().string();
    image.mime = picture_kind(bytes, name).mime;
    image.size_px = picture_size(bytes, name);
    // Rows are appended one by one, so that a short file with a large size in its header needs
    // little memory.
    image.rgba.reserve(4 * static_cast<std::size_t>(image.size_px.x) *
                       static_cast<std::size_t>(image.size_px.y));
    decoded(bytes, name, {}, [&](std::span<const std::uint8_t> rows) {
        image.rgba.insert(image.rgba.end(), rows.begin(), rows.end());
    });
    image.source_bytes = bytes;
    return image;
}

Image PictureReader::read(const std::string& path)
{
    return read_bytes(trivar::read_bytes(path, max_file_bytes), path);
}

GreyImage PictureReader::read_grey(const std::string& path)
{
    return read_grey_bytes(trivar::read_bytes(path, max_file_bytes), path);
}

GreyImage PictureReader::read_grey_bytes(std::string_view bytes, const std::string& name)
{
    GreyImage image;
    image.size_px = picture_size(bytes, name);
    const auto pixels =
        static_cast<std::uint64_t>(image.size_px.x) * static_cast<unsigned>(image.size_px.y);
    if (pixels > max_grey_pixels)
        throw Rejected(fmt::format("{}: has {} x {} pixels; at most {} million are read as a mask "
                                   "or as heights, so make it smaller",
                                   name, image.size_px.x, image.size_px.y,
                                   max_grey_pixels / 1'000'000));
    decoded(
        bytes, name, {},
        [&](std::span<const std::uint8_t> rows) {
            const std::size_t before = image.values.size(), more = rows.size() / sizeof(float);
            image.values.resize(before + more);
            std::memcpy(image.values.data() + before, rows.data(), more * sizeof(float));
        },
        true);
    for (float& value : image.values) {
        constexpr float most = 1e6f;
        if (!(std::abs(value) <= most)) {
            image.no_numbers += 1;
            value = 0;
        }
    }
    return image;
}

ImageHead PictureReader::head(const std::string& path, const std::vector<std::string>& tags)
{
    const std::string bytes = trivar::read_bytes(path, max_file_bytes);
    const DecodeResult found = decoded(bytes, path, tags, [](std::span<const std::uint8_t>) {});
    return {picture_size(bytes, path), found.bits, found.tags};
}

Image read_image(const std::string& path)
{
    return PictureReader().read(path);
}

GreyImage read_grey_image(const std::string& path)
{
    return PictureReader().read_grey(path);
}

glm::ivec2 picture_size(std::string_view bytes, const std::string& name)
{
    return picture_head(bytes, name, Look::head_only).size_px;
}

std::string encoded_image(const Image& image, const std::string& extension, const ImageTags& tags)
{
    return encoded({image.size_px, image.rgba, {}, extension, tags}, image.name);
}

std::string encoded_image(const DeepImage& image, const std::string& extension,
                          const ImageTags& tags)
{
    return encoded({image.size_px, {}, image.rgba, extension, tags}, {});
}

void check_picture_name(const std::string& path)
{
    if (extension_of(path) != ".png") codec_for(path, extension_of(path));
}

void write_image(const Image& image, const std::string& path)
{
    check_picture_name(path);
    write_bytes(path, encoded_image(image, extension_of(path)));
}

} // namespace trivar
