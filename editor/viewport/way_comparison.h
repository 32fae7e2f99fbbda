// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluation/evaluate.h"
#include "gpu/ffd/way_times.h"
#include "ui/timing_overlay.h"

#include <array>

namespace trivar {

// DeformWords names a way to deform as people read it, in the order of gpu::DeformBy.
struct DeformWords {
    const char *name, *sentence;
};
inline constexpr std::array<DeformWords, gpu::deform_names.size()> deform_words{{
    {"Processor", "All processors at once, before anything is drawn."},
    {"One phase", "On the graphics card while drawing, in every pass; the time is for one pass."},
    {"Two phases", "On the graphics card, once for all passes."},
    {"Differences", "Two phases, with normals by differences (thesis, 4.3)."},
    {"Raised orders", "Two phases, by lerps between control points (thesis, 4.4)."},
    {"Filtered", "The same lerps by the card's filter: a preview, for its fractions are coarse."},
}};

// A WayComparison measures each way on what a scene deforms now, one per frame, so that the window
// stays responsive.
class WayComparison {
public:
    void begin() { next_ = 0; }
    bool running() const { return next_ < deform_words.size(); }
    // Goes on; call it in the window's context.
    void advance(const Evaluation& evaluated, const Document& document,
                 const Ref<gpu::ShaderTexts>& shaders = {});
    void forget_gpu();
    // All ways, with times where they were measured; empty where nothing is deformed.
    std::vector<ui::TimedWay> rows(const Evaluation& evaluated, gpu::DeformBy used) const;

private:
    std::unique_ptr<gpu::WayTimer> timer_;
    std::array<std::optional<gpu::WayTime>, deform_words.size()> times_;
    std::size_t next_ = deform_words.size();
};

} // namespace trivar
