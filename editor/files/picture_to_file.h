// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/picture/still.h"
#include "editor/session/session.h"
#include "ui/frame.h"

#include <memory>
#include <string>

namespace trivar {

// The picture of the present view, as the scene asks for it and in full, written beside the scene's
// file under the next free number. It is drawn a piece a frame, so the window goes on.
class PictureToFile {
public:
    bool running() const { return wanted_px_ > 0 || still_; }
    const std::string& path() const { return path_; }
    // `width_px` wide, in the shape of the viewport, as soon as the scene is evaluated and nothing
    // else is being read or written. Needs the scene's file, for its folder.
    void begin(const Session& session, int width_px);
    // Once a frame, in the window's context.
    void advance(Session& session, ui::Frame& frame, const Ref<gpu::ShaderTexts>& shaders = {});
    void stop();
    void forget_gpu(); // before the context goes; what is being drawn then begins anew

private:
    void draw(const Session& session, const Ref<gpu::ShaderTexts>& shaders);
    bool is_whole(const Session& session, ui::Frame& frame, const Ref<gpu::ShaderTexts>& shaders);

    std::unique_ptr<Still> still_;
    std::string path_;
    int width_px_ = 0;
    int wanted_px_ = 0; // till it begins
};

} // namespace trivar
