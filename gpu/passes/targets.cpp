// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/passes/targets.h"

#include "gpu/curve.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <epoxy/gl.h>
#include <set>

namespace trivar::gpu {

Targets::Targets(glm::ivec2 size, bool is_deep)
    : size_px(size),
      deep(is_deep),
      depth(GL_DEPTH_COMPONENT32F, size),
      surfaces(GL_RGBA32UI, size),
      ids_depths(GL_RG32UI, size),
      occlusion_noisy(GL_RGBA32F, (size + 1) / 2),
      occlusion(GL_RGBA32F, (size + 1) / 2),
      color(deep ? GL_RGBA16F : GL_SRGB8_ALPHA8, size),
      color_bytes(deep ? Texture2D(GL_RGBA16, size, true) : color.view(GL_RGBA8)),
      kept(deep ? GL_RGBA16 : GL_RGBA8, size, true),
      sum(GL_RGBA16F, size),
      mask(GL_RG8, size, true),
      to_surfaces({&surfaces, &ids_depths}, &depth),
      to_ids({&ids_depths}, &depth),
      to_occlusion_noisy({&occlusion_noisy}, nullptr),
      to_occlusion({&occlusion}, nullptr),
      to_color({&color}, &depth),
      to_bytes({&color_bytes}, nullptr),
      to_sum({&sum}, nullptr),
      to_mask({&mask}, &depth),
      to_encoded({&color_bytes}, &depth)
{
}

namespace {

template <class Channel> std::vector<Channel> rows_from_the_top(const Targets& targets, GLenum type)
{
    const glm::ivec2 size = targets.size_px;
    const std::size_t row = static_cast<std::size_t>(size.x) * 4;
    std::vector<Channel> rgba(row * size.y);
    targets.to_bytes.bind();
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size.x, size.y, GL_RGBA, type, rgba.data());
    auto top = rgba.begin();
    auto bottom = rgba.end() - static_cast<std::ptrdiff_t>(row);
    for (; top < bottom; top += row, bottom -= row) std::swap_ranges(top, top + row, bottom);
    return rgba;
}

} // namespace

Image read_back(const Targets& targets)
{
    Image image;
    image.size_px = targets.size_px;
    image.rgba = rows_from_the_top<std::uint8_t>(targets, GL_UNSIGNED_BYTE);
    return image;
}

DeepImage read_back_deep(const Targets& targets)
{
    return {targets.size_px, rows_from_the_top<std::uint16_t>(targets, GL_UNSIGNED_SHORT)};
}

namespace {

struct IdDepth {
    GLuint id, depth; // bits of the distance along the view direction
    bool curve() const { return (id & curve_id_bit) != 0; }
    int object() const { return static_cast<int>(id & ~curve_id_bit); }
    float distance() const { return std::bit_cast<float>(depth); }
};

// Row by row from the bottom of the rectangle.
std::vector<IdDepth> pixels_in(const Targets& targets, glm::ivec2 first_px, glm::ivec2 size_px)
{
    std::vector<IdDepth> pixels(static_cast<std::size_t>(size_px.x) * size_px.y);
    targets.to_ids.bind();
    glReadPixels(first_px.x, targets.size_px.y - first_px.y - size_px.y, size_px.x, size_px.y,
                 GL_RG_INTEGER, GL_UNSIGNED_INT, pixels.data());
    return pixels;
}

} // namespace

std::vector<int> ids_in(const Targets& targets, glm::ivec2 first_px, glm::ivec2 size_px)
{
    std::set<int> ids;
    for (const IdDepth& pixel : pixels_in(targets, first_px, size_px)) ids.insert(pixel.object());
    ids.erase(0);
    return {ids.begin(), ids.end()};
}

int id_near(const Targets& targets, glm::ivec2 p_px, double reach_px)
{
    // A line on a surface that turns away is farther off than the surface beside it, by about this
    // share of the distance within a few pixels.
    constexpr float about_as_far = 0.02f;
    const int reach = static_cast<int>(std::ceil(reach_px));
    const glm::ivec2 lo = glm::max(p_px - reach, glm::ivec2(0)),
                     size = glm::min(p_px + reach + 1, targets.size_px) - lo;
    const std::vector<IdDepth> pixels = pixels_in(targets, lo, size);
    const auto at = [&](glm::ivec2 p) {
        return pixels[static_cast<std::size_t>(size.y - 1 - p.y) * size.x + p.x];
    };
    const IdDepth here = at(p_px - lo);
    if (here.curve()) return here.object();
    int best = here.object();
    double nearest = reach_px * reach_px;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const IdDepth pixel = at({x, y});
            if (!pixel.curve()) continue;
            const float slack = about_as_far * std::abs(pixel.distance());
            if (here.id != 0 && pixel.distance() > here.distance() + slack) continue;
            const glm::dvec2 off = glm::ivec2(x, y) + lo - p_px;
            if (glm::dot(off, off) > nearest) continue;
            nearest = glm::dot(off, off);
            best = pixel.object();
        }
    return best;
}

} // namespace trivar::gpu
