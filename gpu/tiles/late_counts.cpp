// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/tiles/late_counts.h"

#include <cstdint>
#include <epoxy/gl.h>
#include <utility>

namespace trivar::gpu {

LateCounts::~LateCounts()
{
    for (Picture& picture : pictures_) forget(picture);
}

void LateCounts::forget(Picture& picture)
{
    if (void* const fence = std::exchange(picture.fence, nullptr))
        glDeleteSync(static_cast<GLsync>(fence));
}

const Buffer& LateCounts::next(std::vector<Layer> layers)
{
    last_ = (last_ + 1) % pictures_.size();
    Picture& picture = pictures_[last_];
    forget(picture);
    picture.totals.reserve(layers.size() * kinds * sizeof(std::uint32_t));
    picture.layers = std::move(layers);
    return picture.totals;
}

void LateCounts::asked()
{
    pictures_[last_].fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
}

TileCounts LateCounts::counts_of(const Picture& picture)
{
    std::vector<std::uint32_t> totals(picture.layers.size() * kinds);
    picture.totals.read(std::as_writable_bytes(std::span(totals)));
    TileCounts out;
    for (std::size_t i = 0; i < picture.layers.size(); ++i) {
        const Layer& layer = picture.layers[i];
        const std::uint32_t* const found = totals.data() + i * kinds;
        out.tiles += layer.tiles;
        out.all_vertices += layer.all_vertices;
        out.hidden += found[kinds - 1];
        for (std::size_t l = 0; l < layer.vertices.size(); ++l)
            out.add(l, found[l], layer.vertices[l]);
    }
    return out;
}

std::optional<TileCounts> LateCounts::told()
{
    std::optional<TileCounts> out;
    for (std::size_t age = 0; age < pictures_.size(); ++age) {
        Picture& picture = pictures_[(last_ + pictures_.size() - age) % pictures_.size()];
        if (!picture.fence) continue;
        if (!out) {
            const GLenum state =
                glClientWaitSync(static_cast<GLsync>(picture.fence), GL_SYNC_FLUSH_COMMANDS_BIT, 0);
            if (state != GL_ALREADY_SIGNALED && state != GL_CONDITION_SATISFIED) continue;
            out = counts_of(picture);
        }
        forget(picture); // and what is older
    }
    return out;
}

} // namespace trivar::gpu
