// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/picture/captions.h"
#include "editor/picture/shown_values.h"
#include "gpu/level.h"
#include "gpu/renderer.h"

namespace trivar {

// StillOptions say how a picture for a file is drawn.
struct StillOptions {
    glm::ivec2 size_px{1280, 720};
    gpu::Level level = gpu::Level::standard;
    gpu::DeformBy deform = gpu::DeformBy::processor;
    bool deep = false; // 16 bits a channel
    Ref<gpu::ShaderTexts> shaders = {};
};

// A Still is a picture of a scene as it goes into a file, with its captions, and then the next one.
// In the current OpenGL context. It may be drawn in pieces: see gpu::Renderer.
class Still {
public:
    // Lines that were drawn for a scene before, in place of drawing them when it begins.
    void give_lines(const LineScene& scene, const Ref<SceneLines>& lines)
    {
        values_.lines.give(scene, lines);
    }
    // Throws Rejected.
    void begin(const Evaluation& evaluated, const Document& document, const Camera& camera,
               const StillOptions& options);
    bool advance(double budget_ms) { return renderer_.advance(budget_ms); }
    void draw(const Evaluation& evaluated, const Document& document, const Camera& camera,
              const StillOptions& options); // all of it
    Image image() const;                    // when it is whole
    DeepImage deep_image() const;
    const gpu::Renderer& renderer() const { return renderer_; }

private:
    gpu::Renderer renderer_;
    ShownValues values_;
    std::vector<Caption> captions_; // to be written over it
    Camera camera_;
    Ref<RenderSettings> settings_;
};

} // namespace trivar
