// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/image.h"

#include "core/base/rejected.h"
#include "core/files/color.h"
#include "core/files/file_bytes.h"
#include "core/files/png_chunks.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <limits>
#include <memory>

namespace trivar {
namespace {

constexpr int max_side_px = 16384;
constexpr std::uintmax_t max_file_bytes = std::uintmax_t{1} << 30;

struct Format {
    const char* name; // OpenImageIO's
    const char* mime;
};

// By the first bytes: an embedded image has no file name, and names lie.
Format format_of(std::string_view bytes, const std::string& name)
{
    const auto begins = [&](std::string_view magic) {
        return bytes.substr(0, magic.size()) == magic;
    };
    if (begins("\x89PNG")) return {"png", "image/png"};
    if (begins("\xff\xd8\xff")) return {"jpeg", "image/jpeg"};
    if (begins("RIFF") && bytes.size() >= 12 && bytes.substr(8, 4) == "WEBP")
        return {"webp", "image/webp"};
    if (begins("v/1\x01")) return {"openexr", "image/x-exr"};
    if (begins("#?RADIANCE") || begins("#?RGBE")) return {"hdr", "image/vnd.radiance"};
    if (begins("GIF8")) return {"gif", "image/gif"};
    if (begins("BM")) return {"bmp", "image/bmp"};
    if (begins(std::string_view("II*\0", 4)) || begins(std::string_view("MM\0*", 4)))
        return {"tiff", "image/tiff"};
    if (begins("DDS ")) return {"dds", "image/vnd-ms.dds"};
    if (extension_of(name) == ".tga") return {"targa", "image/x-tga"};
    throw Rejected(name + ": this is no kind of picture that can be read");
}

// Spreads gray, gray-alpha, RGB or more channels to RGBA.
template <class T>
std::vector<T> to_rgba(const std::vector<T>& pixels, std::size_t count, std::size_t channels,
                       T full)
{
    std::vector<T> rgba(count * 4);
    for (std::size_t i = 0; i < count; ++i) {
        const T* p = pixels.data() + i * channels;
        const bool gray = channels < 3;
        rgba[4 * i] = p[0];
        rgba[4 * i + 1] = gray ? p[0] : p[1];
        rgba[4 * i + 2] = gray ? p[0] : p[2];
        rgba[4 * i + 3] = channels == 2 ? p[1] : channels > 3 ? p[3] : full;
    }
    return rgba;
}

std::vector<std::uint8_t> display_bytes(const std::vector<float>& linear)
{
    std::vector<std::uint8_t> bytes(linear.size());
    for (std::size_t i = 0; i < linear.size(); ++i) {
        float value = linear[i] > 0 ? std::min(linear[i], 1.0f) : 0.0f; // NaN is 0
        if (i % 4 != 3) value = srgb_from_linear(value);
        bytes[i] = static_cast<std::uint8_t>(std::lround(value * 255));
    }
    return bytes;
}

// What is decoded must be in some proportion to the bytes that say it: no picture format packs
// more than about a thousand samples in a byte.
void check_size(const OIIO::ImageSpec& spec, std::size_t bytes, const std::string& name)
{
    if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.nchannels < 1 ||
        spec.nchannels > 64 || spec.width > max_side_px || spec.height > max_side_px)
        throw Rejected(
            fmt::format("{}: a picture of {} x {} pixels and {} channels cannot be read, "
                        "sides may have up to {}",
                        name, spec.width, spec.height, spec.nchannels, max_side_px));
    const auto pixels =
        static_cast<std::uintmax_t>(spec.width) * static_cast<unsigned>(spec.height);
    if (pixels > (1 << 20) + std::uintmax_t{1024} * bytes)
        throw Rejected(fmt::format("{}: {} bytes cannot hold the {} x {} pixels they declare", name,
                                   bytes, spec.width, spec.height));
}

[[noreturn]] void refuse_extension(const std::string& name, const std::string& extension)
{
    throw Rejected(fmt::format("{}: pictures cannot be written as '{}', png, jpg and exr can",
                               name.empty() ? "picture" : name, extension));
}

// A picture file that was opened, by its bytes.
struct Reading {
    Reading(std::string_view bytes, const std::string& file_name,
            OIIO::Filesystem::IOMemReader& memory)
        : name(file_name),
          format(format_of(bytes, name)),
          input(OIIO::ImageInput::create(format.name, false))
    {
        if (format.name == std::string_view("png"))
            if (const std::string trouble = png_trouble(bytes); !trouble.empty()) refuse(trouble);
        OIIO::ImageSpec hints;
        hints.attribute("oiio:UnassociatedAlpha", 1); // glTF's alpha is not multiplied in
        if (!input || !input->supports("ioproxy")) refuse("no reader for this format");
        OIIO::Filesystem::IOProxy* proxy = &memory;
        hints.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
        input->set_ioproxy(proxy);
        if (!input->open(name, spec, hints)) refuse(input->geterror());
        check_size(spec, bytes.size(), name);
    }
    [[noreturn]] void refuse(const std::string& reason) const
    {
        throw Rejected(fmt::format("{}: the picture cannot be read ({})", name,
                                   reason.substr(0, reason.find('\n'))));
    }
    std::size_t count() const
    {
        return static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
    }

    std::string name;
    Format format;
    std::unique_ptr<OIIO::ImageInput> input;
    OIIO::ImageSpec spec;
};

template <class Channel> struct Pixels {
    glm::ivec2 size_px;
    const std::vector<Channel>& rgba;
    std::string name;
};

template <class Channel>
std::string encoded(const Pixels<Channel>& image, const std::string& extension,
                    const ImageTags& tags)
{
    constexpr auto type = sizeof(Channel) == 1 ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::UINT16;
    constexpr auto full = static_cast<float>(std::numeric_limits<Channel>::max());
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const std::string name = "memory" + extension;
    const auto output = OIIO::ImageOutput::create(name);
    if (!output || !output->supports("ioproxy")) refuse_extension(image.name, extension);
    output->set_ioproxy(&memory);
    OIIO::ImageSpec spec(image.size_px.x, image.size_px.y, output->supports("alpha") ? 4 : 3, type);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    spec.attribute("CompressionQuality", 95);
    spec.attribute("DateTime", ""); // else some formats are given the present time
    for (const auto& [tag, words] : tags) spec.attribute(tag, words);
    bool written = false;
    if (extension == ".exr" || extension == ".hdr") {
        spec.format = extension == ".exr" ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT;
        std::vector<float> linear(image.rgba.size());
        for (std::size_t i = 0; i < linear.size(); ++i) {
            const float value = image.rgba[i] / full;
            linear[i] = i % 4 == 3 ? value : linear_from_srgb(value);
        }
        written = output->open(name, spec) &&
                  output->write_image(OIIO::TypeDesc::FLOAT, linear.data(), 4 * sizeof(float));
    } else {
        written = output->open(name, spec) &&
                  output->write_image(type, image.rgba.data(), 4 * sizeof(Channel));
    }
    if (!written || !output->close())
        throw Rejected(fmt::format("{}: cannot be written ({})", image.name, output->geterror()));
    return {bytes.begin(), bytes.end()};
}

} // namespace

Image read_image_bytes(std::string_view bytes, const std::string& name)
{
    OIIO::Filesystem::IOMemReader memory(bytes.data(), bytes.size());
    const Reading read(bytes, name, memory);
    const OIIO::ImageSpec& spec = read.spec;
    const auto channels = static_cast<std::size_t>(spec.nchannels);
    Image image;
    image.name = std::filesystem::path(name).filename().string();
    image.size_px = {spec.width, spec.height};
    image.mime = read.format.mime;
    const auto pixels_of = [&]<class T>(T full, OIIO::TypeDesc type) {
        std::vector<T> pixels(read.count() * channels);
        if (!read.input->read_image(0, 0, 0, spec.nchannels, type, pixels.data()))
            read.refuse(read.input->geterror());
        return to_rgba(pixels, read.count(), channels, full);
    };
    if (spec.format.is_floating_point())
        image.rgba = display_bytes(pixels_of(1.0f, OIIO::TypeDesc::FLOAT));
    else
        image.rgba = pixels_of(std::uint8_t{255}, OIIO::TypeDesc::UINT8);
    image.source_bytes = bytes;
    return image;
}

glm::ivec2 picture_size(std::string_view bytes, const std::string& name)
{
    OIIO::Filesystem::IOMemReader memory(bytes.data(), bytes.size());
    const Reading read(bytes, name, memory);
    return {read.spec.width, read.spec.height};
}

Image read_image(const std::string& path)
{
    return read_image_bytes(read_bytes(path, max_file_bytes), path);
}

std::string encoded_image(const Image& image, const std::string& extension, const ImageTags& tags)
{
    return encoded(Pixels<std::uint8_t>{image.size_px, image.rgba, image.name}, extension, tags);
}

std::string encoded_image(const DeepImage& image, const std::string& extension,
                          const ImageTags& tags)
{
    return encoded(Pixels<std::uint16_t>{image.size_px, image.rgba, {}}, extension, tags);
}

ImageHead image_head(const std::string& path, const std::vector<std::string>& tags)
{
    const std::string bytes = read_bytes(path, max_file_bytes);
    OIIO::Filesystem::IOMemReader memory(bytes.data(), bytes.size());
    const Reading read(bytes, path, memory);
    const OIIO::ImageSpec& spec = read.spec;
    std::vector<std::uint16_t> pixels(read.count() * static_cast<std::size_t>(spec.nchannels));
    if (!read.input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT16, pixels.data()))
        read.refuse(read.input->geterror());
    ImageHead head{{spec.width, spec.height}, static_cast<int>(8 * spec.format.size()), {}};
    for (const std::string& tag : tags)
        if (const std::string words(spec.get_string_attribute(tag)); !words.empty())
            head.tags.emplace_back(tag, words);
    return head;
}

void check_picture_name(const std::string& path)
{
    const auto output = OIIO::ImageOutput::create("memory" + extension_of(path));
    if (!output || !output->supports("ioproxy")) refuse_extension(path, extension_of(path));
}

void write_image(const Image& image, const std::string& path)
{
    check_picture_name(path);
    write_bytes(path, encoded_image(image, extension_of(path)));
}

} // namespace trivar
