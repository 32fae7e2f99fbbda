// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/passes/targets.h"

#include <algorithm>
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
      mask(GL_R8, size, true),
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

std::vector<int> ids_in(const Targets& targets, glm::ivec2 first_px, glm::ivec2 size_px)
{
    struct IdDepth {
        GLuint id, depth;
    };
    std::vector<IdDepth> pixels(static_cast<std::size_t>(size_px.x) * size_px.y);
    targets.to_ids.bind();
    glReadPixels(first_px.x, targets.size_px.y - first_px.y - size_px.y, size_px.x, size_px.y,
                 GL_RG_INTEGER, GL_UNSIGNED_INT, pixels.data());
    std::set<int> ids;
    for (const IdDepth& pixel : pixels) ids.insert(static_cast<int>(pixel.id));
    ids.erase(0);
    return {ids.begin(), ids.end()};
}

} // namespace trivar::gpu
