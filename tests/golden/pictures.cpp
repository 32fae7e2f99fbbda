// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/golden/pictures.h"

#include "core/base/rejected.h"
#include "core/files/pictures/image.h"

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
    write_image(image, path.string());
}

std::optional<Image> read_png(const std::filesystem::path& path)
{
    try {
        return read_image(path.string());
    } catch (const Rejected&) {
        return {};
    }
}

struct Difference {
    Image picture; // times 8
    double share = 0, mean_steps = 0;
    double tile_steps = 0; // of the worst tile
};

// The mean absolute difference of all channels over the 16 x 16 pixels where it is largest. Tiles
// overlap by half, so that nothing is shared out to two of them.
double worst_tile(const Image& a, const Image& b)
{
    constexpr int side = 16, step = side / 2;
    double worst = 0;
    for (int y = 0; y < a.size_px.y; y += step)
        for (int x = 0; x < a.size_px.x; x += step) {
            const int right = std::min(x + side, a.size_px.x),
                      low = std::min(y + side, a.size_px.y);
            double sum = 0;
            for (int j = y; j < low; ++j)
                for (int i = x; i < right; ++i)
                    for (int c = 0; c < 3; ++c) {
                        const auto at = 4 * (static_cast<std::size_t>(j) *
                                                 static_cast<std::size_t>(a.size_px.x) +
                                             static_cast<std::size_t>(i)) +
                                        static_cast<std::size_t>(c);
                        sum += std::abs(a.rgba[at] - b.rgba[at]);
                    }
            worst = std::max(worst, sum / (3 * side * side));
        }
    return worst;
}

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
    d.tile_steps = worst_tile(a, b);
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
    if (found.share <= tolerance.share && found.mean_steps <= tolerance.mean_steps &&
        found.tile_steps <= tolerance.tile_steps)
        return ::testing::AssertionSuccess();
    write_png(image, out);
    write_png(found.picture, diff);
    return ::testing::AssertionFailure()
           << fmt::format("{}: {:.2f} % of the pixels differ by more than {}, all by {:.2f} in the "
                          "mean and by {:.2f} in the worst tile; see {} and {}",
                          path, 100 * found.share, tolerance.step, found.mean_steps,
                          found.tile_steps, out.string(), diff.string());
}

} // namespace trivar::testing
