// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/passes/occluders.h"

#include <algorithm>
#include <epoxy/gl.h>

namespace trivar::gpu {
namespace {

bool may_hide(const SceneItem& item)
{
    return item.seen && !(item.copies && item.copies->patches);
}

} // namespace

bool Occluders::worthwhile(const Scene& scene, const TileCounts& tiles)
{
    constexpr std::size_t corners_per_vertex = 6; // of a mesh of triangles
    std::size_t corners = 0;
    for (const SceneItem& item : scene.items)
        for (const MirroredMesh::Part& part : item.mesh->parts())
            if (may_hide(item) && opaque(item, part))
                corners += static_cast<std::size_t>(part.count) *
                           static_cast<std::size_t>(item.drawn_count());
    return corners > 0 && corners_per_vertex * tiles.vertices > 4 * corners;
}

void Occluders::draw(Tools& tools, const Frame& frame, const Scene& scene)
{
    const glm::ivec2 size = glm::max(glm::ivec2(frame.size_px) / 2, 1);
    if (depth_.size_px() != size) {
        depth_ = Texture2D(GL_DEPTH_COMPONENT32F, size);
        target_ = Framebuffer({}, &depth_);
    }
    target_.bind();
    set_state({.depth = DepthTest::less, .write_depth = true});
    glClear(GL_DEPTH_BUFFER_BIT);
    MeshPass pass;
    pass.fragment = "depth";
    pass.scene_to_clip = frame.view_clip;
    pass.reads_material = false;
    pass.wanted = [](const SceneItem& item, const MirroredMesh::Part& part) {
        return may_hide(item) && opaque(item, part);
    };
    tools.draw(scene.items, pass);
}

DepthPyramid Occluders::read_back() const
{
    const glm::ivec2 size = depth_.size_px();
    target_.bind();
    std::vector<float> depths(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, size.x, size.y, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
    return {std::move(depths), size};
}

const DevicePyramid& Occluders::on_card(Tools& tools)
{
    pyramid_.write(tools.programs(), depth_);
    return pyramid_;
}

} // namespace trivar::gpu
