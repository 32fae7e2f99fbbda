// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/passes/sample.h"
#include "gpu/passes/tools.h"

#include <functional>
#include <span>

namespace trivar::gpu {

// LayerBounds is the rectangle of layers in the picture, and their range along the view direction.
struct LayerBounds {
    glm::ivec2 lo_px{0}, size_px{0};
    glm::vec2 range_world{0};
    bool empty() const { return size_px.x <= 0 || size_px.y <= 0; }
};
LayerBounds bounds_of_layers(const Frame& frame, std::span<const glm::vec3> points_scene);

// A LayerPass draws see-through layers over a sample of the picture, in any order: layers.glsl.
class LayerPass {
public:
    struct Kind {
        bool helpers = false; // mixed with the picture as encoded colours, not as light
        bool at_once = false; // in one pass, for drafts
    };
    // `draw_all` draws every layer; it runs once or twice, its programs with these defines.
    using DrawAll = std::function<void(const std::vector<std::string>& defines)>;
    void draw(Tools& tools, const Targets& targets, const LayerBounds& bounds, Kind kind,
              const DrawAll& draw_all);

private:
    Texture2D near_depths_, far_depths_, weighed_, depths_; // as large as the largest picture yet
    Framebuffer to_depths_, to_weighed_, to_both_;
};

// SeeThroughPass draws the see-through things of a picture: blended materials, previews and
// helpers.
class SeeThroughPass {
public:
    SeeThroughPass();
    void load(const std::vector<Translucent>& veils, const glm::dvec3& origin_world);
    bool any(const Scene& scene) const;
    void draw(Tools& tools, const Targets& targets, const Frame& frame, const Scene& scene,
              const Quality& quality);

private:
    void draw_materials(Tools& tools, const Targets& targets, const Frame& frame,
                        const Scene& scene, const Quality& quality);
    void draw_helpers(Tools& tools, const Targets& targets, const Frame& frame);
    std::vector<glm::vec3> corners_; // of the helpers' triangles, scene
    Buffer points_, indices_;
    VertexArray vertices_;
    LayerPass layers_;
};

} // namespace trivar::gpu
