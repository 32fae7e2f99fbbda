// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/session/session.h"
#include "gpu/shader_source.h"
#include "ui/frame.h"

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>

namespace trivar {

class Still;
struct LineScene;
struct SceneLines;

// A PictureToFile draws the present view as the scene asks for it, in full quality, and writes it
// beside the scene's file under the next free number. It draws one piece per frame, so the window
// stays responsive.
class PictureToFile {
public:
    PictureToFile();
    ~PictureToFile();
    bool running() const { return wanted_px_ || still_; }
    const std::string& path() const { return path_; }
    // Begins a picture of that size as soon as the scene is evaluated and nothing else is read or
    // written. That of a scene without a file goes to the person's pictures.
    void begin(const Session& session, glm::ivec2 size_px);
    // Once a frame, in the window's context.
    void advance(Session& session, ui::Frame& frame, const Ref<gpu::ShaderTexts>& shaders = {});
    void stop();
    void forget_gpu(); // before the context goes; what is being drawn then begins anew

private:
    void draw(const Session& session, const Camera& camera, const Ref<gpu::ShaderTexts>& shaders);
    bool is_whole(Session& session, ui::Frame& frame, const Ref<gpu::ShaderTexts>& shaders);
    bool has_lines(Session& session, const Camera& camera); // else they are being drawn

    std::unique_ptr<Still> still_;
    std::string path_;
    glm::ivec2 size_px_{0};
    std::optional<glm::ivec2> wanted_px_; // until it begins
    Ref<LineScene> lines_of_;             // whose lines were asked for; null: none were
    Ref<SceneLines> lines_;               // null: they are not there
};

} // namespace trivar
