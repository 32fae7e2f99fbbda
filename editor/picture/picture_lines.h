// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene_lines/line_drawer.h"
#include "gpu/curve.h"
#include "gpu/picture.h"

namespace trivar {

// PictureLines gives the lines of scenes as curves of pictures. It keeps those of the last few
// views.
class PictureLines {
public:
    // full: at once, for files. quick: quick lines, but where others were given.
    LineEffort effort = LineEffort::full;
    std::vector<Id> hidden_here = {}; // objects that are hidden in the view alone, ascending
    // `wider` is the width of a line in pixels per pixel of a picture of the usual height; it
    // follows from the camera. Costs what LineDrawer does in a new view.
    const std::vector<gpu::Curve>& operator()(const Evaluation& evaluated, const Document& document,
                                              const Camera& camera, float wider);
    // Lines that are drawn for that scene from now on; null: none are given any more.
    void give(LineScene scene, Ref<SceneLines> lines);

private:
    LineDrawer drawer_;
    LineScene given_of_;
    Ref<SceneLines> given_;
    Recent<std::pair<LineScene, Ref<SceneLines>>, std::vector<gpu::Curve>> known_{16};
};

// Changes instances of an object so that it is paper, or removes them where only its lines are
// drawn.
void draw_on(std::vector<gpu::Instance>& instances, const LineDrawing& drawing);

} // namespace trivar
