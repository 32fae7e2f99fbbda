// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/passes/contact_map.h"

#include <algorithm>
#include <epoxy/gl.h>

namespace trivar::gpu {
namespace {

// Looking straight up from the ground (depth grows with height), or down from the top.
glm::mat4 along_z(const Frame& frame, float height, bool up)
{
    const glm::vec2 corner(frame.contact);
    const float per_side = frame.contact.z, ground = frame.ground.x;
    const float air = height * 0.002f, span = height + 2 * air; // what lies on the ground counts
    glm::mat4 m(0);
    m[0][0] = m[1][1] = 2 * per_side;
    m[2][2] = (up ? 2 : -2) / span;
    m[3] = glm::vec4(-2.0f * corner * per_side - 1.0f, 0, 1);
    m[3].z = up ? -1 - 2 * (ground - air) / span : 1 + 2 * (ground - air) / span;
    return m;
}

} // namespace

bool ContactMap::stale(const Frame& frame, const Scene& scene, int resolution_px) const
{
    return open_.size_px().x != resolution_px || drawn_at_ != frame.contact ||
           drawn_from_ != casters_of(scene);
}

void ContactMap::draw(Tools& tools, const Frame& frame, const Scene& scene, int resolution_px)
{
    if (open_.size_px().x != resolution_px) {
        const glm::ivec2 size(resolution_px);
        lowest_ = Texture2D(GL_DEPTH_COMPONENT32F, size);
        highest_ = Texture2D(GL_DEPTH_COMPONENT32F, size);
        noisy_ = Texture2D(GL_R8, size, true);
        open_ = Texture2D(GL_R8, size, true);
        to_lowest_ = Framebuffer({}, &lowest_);
        to_highest_ = Framebuffer({}, &highest_);
        to_noisy_ = Framebuffer({&noisy_}, nullptr);
        to_open_ = Framebuffer({&open_}, nullptr);
    }
    const float height = std::max(scene.hi.z - frame.ground.x, 1e-6f);
    for (const bool up : {true, false}) {
        (up ? to_lowest_ : to_highest_).bind();
        set_state({.depth = DepthTest::less, .write_depth = true});
        glClear(GL_DEPTH_BUFFER_BIT);
        MeshPass pass;
        pass.fragment = "depth";
        pass.casters = true;
        pass.scene_to_clip = along_z(frame, height, up);
        pass.reads_material = false;
        pass.wanted = opaque;
        tools.draw(scene.items, pass);
    }
    set_state({});
    to_noisy_.bind();
    tools.use(full_screen_program("contact")).set("height", height);
    lowest_.bind(0);
    highest_.bind(1);
    tools.full_screen();
    to_open_.bind();
    tools.use(full_screen_program("contact_blur"));
    noisy_.bind(0);
    tools.full_screen();
    drawn_at_ = frame.contact;
    drawn_from_ = casters_of(scene);
}

void ContactMap::bind() const
{
    open_.bind(0);
}

} // namespace trivar::gpu
