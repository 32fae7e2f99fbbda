// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/pictures/kinds.h"

#include "core/base/rejected.h"
#include "core/files/file_bytes.h"
#include "core/files/pictures/pixels.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace trivar {
namespace {

using namespace std::string_view_literals;

constexpr int max_side_px = 16384;
// Limits of the pixels by the size of the file. Few formats pack more pixels of four bytes into
// one; a single colour may take almost no bytes, so that 4096 x 4096 pixels are always allowed.
constexpr std::uint64_t pixels_a_byte = 1024, pixels_anyway = 1 << 24;
// OpenEXR files of films have tens of channels, for light passes and masks.
constexpr int max_channels = 64;

constexpr PictureKind kind_png{"PNG", "png", "image/png", png_head, png_pixels};
constexpr PictureKind kind_jpeg{"JPEG", "jpeg", "image/jpeg", jpeg_head, jpeg_pixels};
constexpr PictureKind kind_webp{"WebP", "webp", "image/webp", webp_head, nullptr};
constexpr PictureKind kind_exr{"EXR", "openexr", "image/x-exr", exr_head, nullptr};
constexpr PictureKind kind_hdr{"HDR", "hdr", "image/vnd.radiance", hdr_head, nullptr};
constexpr PictureKind kind_gif{"GIF", "gif", "image/gif", gif_head, nullptr};
constexpr PictureKind kind_bmp{"BMP", "bmp", "image/bmp", bmp_head, nullptr};
constexpr PictureKind kind_tiff{"TIFF", "tiff", "image/tiff", tiff_head, nullptr};
constexpr PictureKind kind_dds{"DDS", "dds", "image/vnd-ms.dds", dds_head, nullptr};
constexpr PictureKind kind_tga{"TGA", "targa", "image/x-tga", tga_head, nullptr};

struct Beginning {
    std::string_view bytes;
    const PictureKind& kind;
};
constexpr std::array beginnings{
    Beginning{"\x89PNG"sv, kind_png}, Beginning{"\xff\xd8\xff"sv, kind_jpeg},
    Beginning{"v/1\x01"sv, kind_exr}, Beginning{"#?RADIANCE"sv, kind_hdr},
    Beginning{"#?RGBE"sv, kind_hdr},  Beginning{"GIF8"sv, kind_gif},
    Beginning{"BM"sv, kind_bmp},      Beginning{"II*\0"sv, kind_tiff},
    Beginning{"MM\0*"sv, kind_tiff},  Beginning{"DDS "sv, kind_dds}};

} // namespace

const PictureKind& picture_kind(std::string_view bytes, const std::string& name)
{
    for (const Beginning& beginning : beginnings)
        if (bytes.starts_with(beginning.bytes)) return beginning.kind;
    if (bytes.starts_with("RIFF") && bytes.size() >= 12 && bytes.substr(8, 4) == "WEBP")
        return kind_webp;
    if (extension_of(name) == ".tga") return kind_tga;
    throw Rejected(name + ": this is not a picture that Trivar can read; use PNG, JPEG, WebP, EXR, "
                          "HDR, TIFF, TGA, BMP, GIF or DDS");
}

PictureHead picture_head(std::string_view bytes, const std::string& name, Look look)
{
    const PictureKind& kind = picture_kind(bytes, name);
    const auto refuse = [&](const std::string& reason) -> Rejected {
        return Rejected(fmt::format("{}: this {} picture {}", name, kind.word, reason));
    };
    PictureHead head;
    try {
        head = kind.head({bytes}, Look::head_only);
    } catch (const Rejected& rejected) {
        throw refuse(rejected.what());
    }
    const glm::ivec2 size = head.size_px;
    if (size.x < 1 || size.y < 1 || size.x > max_side_px || size.y > max_side_px)
        throw refuse(fmt::format("declares {} x {} pixels; each side must have 1 to {}", size.x,
                                 size.y, max_side_px));
    if (head.channels < 1 || head.channels > max_channels)
        throw refuse(
            fmt::format("declares {} channels; it must have 1 to {}", head.channels, max_channels));
    const auto pixels = static_cast<std::uint64_t>(size.x) * static_cast<unsigned>(size.y);
    const int weight = std::max(1, head.channels * head.bytes_a_channel / 4);
    if (pixels * static_cast<unsigned>(weight) > pixels_anyway + pixels_a_byte * bytes.size())
        throw refuse(fmt::format("has {} bytes, which cannot hold the {} x {} pixels that it "
                                 "declares",
                                 bytes.size(), size.x, size.y));
    if (look == Look::whole) try {
            kind.head({bytes}, look);
        } catch (const Rejected& rejected) {
            throw refuse(rejected.what());
        }
    return head;
}

} // namespace trivar
