// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/record/contact_sheet.h"

#include "core/base/mistake.h"
#include "core/base/rejected.h"
#include "core/base/whole_numbers.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

constexpr int most_cells = 64;                          // columns, and rows
constexpr std::uint8_t gap_rgba[4] = {30, 32, 35, 255}; // of the dark theme's panels

} // namespace

glm::ivec2 sheet_grid(std::string_view text)
{
    const std::vector<int> n = whole_numbers(text, 'x');
    if (n.size() == 2 && n[0] >= 1 && n[1] >= 1 && n[0] <= most_cells && n[1] <= most_cells)
        return {n[0], n[1]};
    throw Rejected(
        fmt::format("--sheet {}: must be COLUMNSxROWS, such as 3x2, up to {}", text, most_cells));
}

std::vector<int> evenly_chosen(const std::vector<int>& frames, int count)
{
    const auto all = frames.size(), wanted = static_cast<std::size_t>(count);
    if (all <= wanted) return frames;
    if (wanted == 1) return {frames.front()};
    std::vector<int> chosen;
    for (std::size_t k = 0; k < wanted; ++k)
        chosen.push_back(frames[(k * (all - 1) + (wanted - 1) / 2) / (wanted - 1)]);
    return chosen;
}

Image contact_sheet(const std::vector<Image>& pictures, int columns)
{
    ensure(!pictures.empty() && columns >= 1, "a sheet has no pictures");
    const glm::ivec2 size = pictures.front().size_px;
    const int gap = std::max(1, size.x / 100);
    const glm::ivec2 grid(columns, (static_cast<int>(pictures.size()) + columns - 1) / columns);
    Image out;
    out.size_px = grid * size + (grid - 1) * gap;
    const auto width = static_cast<std::size_t>(out.size_px.x);
    for (std::size_t k = width * static_cast<std::size_t>(out.size_px.y); k > 0; --k)
        out.rgba.insert(out.rgba.end(), gap_rgba, gap_rgba + 4);
    for (int k = 0; const Image& picture : pictures) {
        ensure(picture.size_px == size, "pictures of a sheet have two sizes");
        const glm::ivec2 corner = glm::ivec2(k % columns, k / columns) * (size + gap);
        const auto row = static_cast<std::ptrdiff_t>(size.x) * 4;
        for (int y = 0; y < size.y; ++y) {
            const auto to =
                static_cast<std::size_t>(corner.y + y) * width + static_cast<std::size_t>(corner.x);
            std::copy_n(picture.rgba.begin() + y * row, row,
                        out.rgba.begin() + static_cast<std::ptrdiff_t>(4 * to));
        }
        ++k;
    }
    return out;
}

} // namespace trivar
