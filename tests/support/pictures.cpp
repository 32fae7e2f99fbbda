// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/pictures.h"

#include <OpenImageIO/imageio.h>
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <optional>

namespace trivar::testing {
namespace {

void write_png(const Image& image, const std::filesystem::path& path)
{
    std::filesystem::create_directories(path.parent_path());
    std::vector<std::uint8_t> rgb;
    for (std::size_t i = 0; i < image.rgba.size(); ++i)
        if (i % 4 != 3) rgb.push_back(image.rgba[i]);
    OIIO::ImageSpec spec(image.size_px.x, image.size_px.y, 3, OIIO::TypeDesc::UINT8);
    spec.attribute("png:compressionLevel", 9);
    const auto out = OIIO::ImageOutput::create(path.string());
    if (!out || !out->open(path.string(), spec) ||
        !out->write_image(OIIO::TypeDesc::UINT8, rgb.data()))
        ADD_FAILURE() << "cannot write " << path;
}

std::optional<Image> read_png(const std::filesystem::path& path)
{
    const auto in = OIIO::ImageInput::open(path.string());
    if (!in || in->spec().nchannels < 3) return {};
    Image image;
    image.size_px = {in->spec().width, in->spec().height};
    const std::size_t pixels = static_cast<std::size_t>(image.size_px.x) * image.size_px.y;
    std::vector<std::uint8_t> rgb(pixels * 3);
    if (!in->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, rgb.data())) return {};
    for (std::size_t i = 0; i < pixels; ++i)
        image.rgba.insert(image.rgba.end(), {rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2], 255});
    return image;
}

struct Difference {
    Image picture; // times 8
    double share = 0, mean_steps = 0;
};

Difference difference(const Image& a, const Image& b, int step)
{
    Difference d;
    d.picture.size_px = a.size_px;
    d.picture.rgba.assign(a.rgba.size(), 255);
    const std::size_t pixels = a.rgba.size() / 4;
    for (std::size_t p = 0; p < pixels; ++p) {
        int worst = 0;
        for (std::size_t i = 4 * p; i < 4 * p + 3; ++i) {
            const int off = std::abs(a.rgba[i] - b.rgba[i]);
            worst = std::max(worst, off);
            d.mean_steps += off;
            d.picture.rgba[i] = static_cast<std::uint8_t>(std::min(off * 8, 255));
        }
        d.share += worst > step;
    }
    d.share /= static_cast<double>(pixels);
    d.mean_steps /= 3 * static_cast<double>(pixels);
    return d;
}

} // namespace

::testing::AssertionResult matches_picture(const Image& image, const std::string& path,
                                           const PictureTolerance& tolerance)
{
    const auto golden_path = std::filesystem::path(TRIVAR_SOURCE_DIR) / path;
    const char* update = std::getenv("TRIVAR_UPDATE_GOLDEN");
    if (update && std::string(update) == "1") {
        write_png(image, golden_path);
        return ::testing::AssertionSuccess();
    }
    const std::filesystem::path build(TRIVAR_BINARY_DIR);
    const std::string name = golden_path.stem().string();
    const auto out = build / (name + ".out.png"), diff = build / (name + ".diff.png");
    const std::optional<Image> golden = read_png(golden_path);
    if (!golden || golden->size_px != image.size_px) {
        write_png(image, out);
        return ::testing::AssertionFailure()
               << (golden ? "of another size than " : "there is no ") << path << "; see " << out;
    }
    const Difference found = difference(image, *golden, tolerance.step);
    if (found.share <= tolerance.share && found.mean_steps <= tolerance.mean_steps)
        return ::testing::AssertionSuccess();
    write_png(image, out);
    write_png(found.picture, diff);
    return ::testing::AssertionFailure()
           << fmt::format("{}: {:.2f} % of the pixels differ by more than {}, all by {:.2f} in the "
                          "mean; see {} and {}",
                          path, 100 * found.share, tolerance.step, found.mean_steps, out.string(),
                          diff.string());
}

} // namespace trivar::testing
