// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/passes/shadow_map.h"

#include <algorithm>
#include <epoxy/gl.h>
#include <limits>

namespace trivar::gpu {
namespace {

struct LightBox {
    glm::vec3 lo{std::numeric_limits<float>::max()}, hi{std::numeric_limits<float>::lowest()};
    void add(const glm::vec3& p)
    {
        lo = glm::min(lo, p);
        hi = glm::max(hi, p);
    }
};

// Rows right, up, towards the light: scene to light axes.
glm::mat3 light_axes(const Frame& frame)
{
    return glm::transpose(glm::mat3(glm::vec3(frame.box_right[0]), glm::vec3(frame.box_up[0]),
                                    glm::vec3(frame.box_dir[0])));
}

LightBox casters_in_light(const Scene& scene, const glm::mat3& axes)
{
    LightBox box;
    for (const SceneItem& item : scene.items)
        for (int k = 0; k < 8; ++k)
            box.add(axes * glm::vec3((k & 1 ? item.hi : item.lo).x, (k & 2 ? item.hi : item.lo).y,
                                     (k & 4 ? item.hi : item.lo).z));
    return box;
}

// Returns the box along the light of all that the picture can show, with the ground before and
// behind the scene.
LightBox view_in_light(const Frame& frame, const Scene& scene, const glm::mat3& axes)
{
    LightBox box;
    const glm::mat4 from_clip = glm::inverse(frame.view_clip);
    for (int k = 0; k < 4; ++k) {
        const auto at = [&](float depth) {
            const glm::vec4 p = from_clip * glm::vec4(k & 1 ? 1 : -1, k & 2 ? 1 : -1, depth, 1);
            return glm::vec3(p) / p.w;
        };
        const glm::vec3 near = at(-1), far = at(1);
        const glm::vec3 further = glm::normalize(far - near) * (2 * scene.radius);
        box.add(axes * (far + further));
        box.add(axes * (frame.eye.w > 0.5f ? glm::vec3(frame.eye) : near - further));
    }
    return box;
}

} // namespace

ShadowMap::ShadowMap()
    : compared_(Sampler::Edge::white_border, Sampler::Edge::white_border, true, true),
      plain_(Sampler::Edge::white_border, Sampler::Edge::white_border, false)
{
}

void ShadowMap::fit(Frame& frame, const Scene& scene, int resolution_px)
{
    if (depth_.size_px().x != resolution_px) {
        depth_ = Texture2D(GL_DEPTH_COMPONENT32F, glm::ivec2(resolution_px), true);
        target_ = Framebuffer({}, &depth_);
        drawn_ = glm::mat4(0);
    }
    const glm::mat3 axes = light_axes(frame);
    LightBox box;
    if (scene.items.empty()) {
        box.add(glm::vec3(-1));
        box.add(glm::vec3(1));
    } else {
        box = casters_in_light(scene, axes);
    }
    // A small model on a large terrain would get no texels: then fit to what is seen of it. Else
    // the fit is left alone, so that turning the view does not draw the map again.
    const LightBox view = view_in_light(frame, scene, axes);
    const glm::vec2 lo = glm::max(glm::vec2(box.lo), glm::vec2(view.lo) - frame.scene.x);
    const glm::vec2 hi = glm::min(glm::vec2(box.hi), glm::vec2(view.hi) + frame.scene.x);
    const auto side_of = [](glm::vec2 extent) { return std::max(extent.x, extent.y); };
    const float whole = side_of(glm::vec2(box.hi) - glm::vec2(box.lo));
    if (lo.x < hi.x && lo.y < hi.y && side_of(hi - lo) < 0.5f * whole) {
        box.lo = glm::vec3(lo, box.lo.z);
        box.hi = glm::vec3(hi, box.hi.z);
    }
    const float extent = std::max(side_of(glm::vec2(box.hi) - glm::vec2(box.lo)), 1e-6f);
    const auto texels = static_cast<float>(resolution_px);
    // Penumbras reach out past the casters' outline; the margin keeps them whole.
    const float width = extent * 1.16f;
    const glm::vec2 centre = (glm::vec2(box.lo) + glm::vec2(box.hi)) * 0.5f;

    // The range goes on to where the lowest shadow meets the ground.
    const glm::vec3 up = axes * glm::vec3(0, 0, 1);
    float lowest = box.lo.z;
    for (int k = 0; k < 4; ++k) {
        const glm::vec2 p(k & 1 ? box.hi.x : box.lo.x, k & 2 ? box.hi.y : box.lo.y);
        const float z =
            (frame.ground.x - glm::dot(p, glm::vec2(up))) / std::max(std::abs(up.z), 0.05f);
        lowest = std::min(lowest, z);
    }
    lowest = std::max(lowest, box.lo.z - 20 * scene.radius);
    const float air = 0.01f * (box.hi.z - lowest) + 1e-6f;
    const float nearest = box.hi.z + air, farthest = lowest - air, range = nearest - farthest;

    glm::mat4 to_clip(axes);
    to_clip[3] = glm::vec4(-centre, -(nearest + farthest) / 2, 1);
    glm::mat4 scale(1);
    scale[0][0] = scale[1][1] = 2 / width;
    scale[2][2] = -2 / range;
    fitted_ = scale * to_clip;
    frame.key_clip = fitted_;
    frame.shadow_map = glm::vec4(1 / texels, width, range, frame.key_dir.w);
}

bool ShadowMap::stale(const Scene& scene) const
{
    return drawn_ != fitted_ || drawn_from_ != casters_of(scene);
}

void ShadowMap::draw(Tools& tools, const Scene& scene, const Quality& quality)
{
    target_.bind();
    set_state({.depth = DepthTest::less, .write_depth = true});
    glClear(GL_DEPTH_BUFFER_BIT);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1.1f, 2);
    MeshPass pass;
    pass.fragment = "depth";
    pass.casters = true;
    pass.scene_to_clip = fitted_;
    pass.reads_material = false;
    pass.wanted = opaque;
    if (!quality.backs_of_bodies)
        pass.without_backs = [](const SceneItem& item, const MirroredMesh::Part&) {
            return item.is_body();
        };
    tools.draw(scene.items, pass);
    glDisable(GL_POLYGON_OFFSET_FILL);
    drawn_ = fitted_;
    drawn_from_ = casters_of(scene);
}

void ShadowMap::bind() const
{
    depth_.bind(4);
    compared_.bind(4);
    depth_.bind(5);
    plain_.bind(5);
}

} // namespace trivar::gpu
