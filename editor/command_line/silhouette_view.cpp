// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/command_line/silhouette_view.h"

#include "editor/command_line/drawing.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace trivar {

glm::dvec3 direction_of(const std::vector<double>& numbers, const char* option)
{
    if (numbers.size() != 3)
        throw WrongUsage(fmt::format("--{}: a direction is three numbers, X,Y,Z", option));
    const glm::dvec3 out(numbers[0], numbers[1], numbers[2]);
    if (!(glm::length(out) > 0))
        throw WrongUsage(fmt::format("--{}: a direction cannot be 0,0,0", option));
    return glm::normalize(out);
}

SilhouetteView::SilhouetteView(SilhouetteAim aim, const glm::dmat4& to_metres,
                               const glm::ivec3& size)
    : aim_(std::move(aim)),
      to_metres_(to_metres),
      size_(size)
{
    constexpr double steep = 0.95; // a sight so near to Z has Y upward
    const glm::dvec3 forward = direction_of(aim_.view, "view");
    camera_.size_px = aim_.size_px;
    camera_.target = glm::dvec3(to_metres * glm::dvec4(glm::dvec3(size - 1) / 2.0, 1));
    camera_.up = !aim_.up.empty()              ? direction_of(aim_.up, "up")
                 : std::abs(forward.z) > steep ? glm::dvec3(0, 1, 0)
                                               : glm::dvec3(0, 0, 1);
    const glm::dvec3 right = glm::cross(forward, camera_.up);
    if (!(glm::length(right) > 1e-6)) throw WrongUsage("--up: it is the direction of sight");
    const glm::dvec3 across = glm::normalize(right);
    to_space_ = glm::dmat3(across, glm::cross(across, forward), forward);
}

glm::dvec3 SilhouetteView::place(const glm::dvec3& voxel) const
{
    return glm::transpose(to_space_) *
           (glm::dvec3(to_metres_ * glm::dvec4(voxel, 1)) - camera_.target);
}

void SilhouetteView::see(const VoxelGrid::Samples& samples, std::size_t first, int z,
                         const SampleBody& body)
{
    if (aim_.whole_grid) return;
    std::visit(
        [&](const auto& all) {
            for (int y = 0; y < size_.y; ++y) {
                const auto row = all.begin() + static_cast<std::ptrdiff_t>(
                                                   first + static_cast<std::size_t>(y) *
                                                               static_cast<std::size_t>(size_.x));
                const auto is_in = [&](auto sample) {
                    return (static_cast<double>(sample) >= body.level) == body.above;
                };
                const auto begin = std::find_if(row, row + size_.x, is_in);
                if (begin == row + size_.x) continue;
                auto end = row + size_.x - 1;
                while (!is_in(*end)) --end;
                seen_.add(place({static_cast<double>(begin - row), y, z}));
                seen_.add(place({static_cast<double>(end - row), y, z}));
            }
        },
        samples);
}

Camera SilhouetteView::camera() const
{
    constexpr double margin = 1.05;
    const std::array<glm::dvec3, 8> corners = Box{glm::dvec3(0), glm::dvec3(size_ - 1)}.corners();
    Box seen = seen_, grid;
    for (const glm::dvec3& corner : corners) grid.add(place(corner));
    if (seen.empty()) {
        seen = grid;
    } else { // a surface is less than a voxel beside the samples of its body
        glm::dvec3 voxel(0);
        for (int k = 0; k < 3; ++k)
            voxel += glm::abs(glm::transpose(to_space_) * glm::dvec3(to_metres_[k]));
        seen = {glm::max(seen.lo - voxel, grid.lo), glm::min(seen.hi + voxel, grid.hi)};
    }
    const glm::dvec3 half = seen.size() / 2.0, middle = seen.center();
    Camera out = camera_;
    out.target += to_space_ * middle;
    const double height =
        margin * std::max(half.y, half.x * out.size_px.y / out.size_px.x); // half of it
    out.perspective = aim_.fov_deg > 0;
    out.height_world = 2 * height;
    out.fov_y = glm::radians(aim_.fov_deg);
    const double before = middle.z - grid.lo.z; // of the grid, so that the eye is outside
    const double distance = out.perspective
                                ? std::max(half.z + height / std::tan(out.fov_y / 2), 1.01 * before)
                                : 2 * before + 4 * glm::length(half);
    out.eye = out.target - distance * to_space_[2];
    return out;
}

} // namespace trivar
