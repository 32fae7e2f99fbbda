// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/picture/shown_values.h"
#include "editor/picture/volume_facts.h"
#include "editor/viewport/draft_pace.h"
#include "editor/viewport/lines_at_rest.h"
#include "editor/viewport/refined_view.h"
#include "editor/viewport/viewport_style.h"
#include "editor/viewport/way_comparison.h"
#include "gpu/renderer.h"
#include "ui/timing_history.h"

namespace trivar {

// PictureInputs are everything that a picture is drawn from.
struct PictureInputs {
    Camera camera;
    long effects = 0; // number of the refined view
    long lines = 0;   // number of those at rest
    Selection selected;
    std::vector<Id> hidden_here;
    glm::ivec2 size_px{0};
    int state = 0;
    bool draft = false;
    const RenderSettings* settings = nullptr;
    ViewportStyle style;
    Ref<gpu::ShaderTexts> shaders;
    bool operator==(const PictureInputs&) const = default;
};

// A ViewportDrawn is the renderer of a viewport, and the state of its pictures.
struct ViewportDrawn {
    ShownValues values;
    WayComparison ways;
    RefinedView refined;
    LinesAtRest lines_at_rest;
    VolumeFacts volume_facts;
    std::unique_ptr<gpu::Renderer> renderer; // made at the first picture
    std::optional<DraftPace> pace;           // as well
    std::optional<PictureInputs> shown;
    std::optional<PictureInputs> begun; // the full picture that is being drawn
    ui::TimingHistory drafts;
    long timed_evaluation = 0; // the last one that is in the history
    Timings full_timings;
    long pictures = 0;
    std::string trouble, said, said_of_trouble, said_of_shaders;
    double moved_s = -1e9;
};

} // namespace trivar
