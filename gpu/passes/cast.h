// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/passes/layers.h"

namespace trivar::gpu {

// A CastPass casts rays through the volumes of a scene, the farthest volume first, and lays what
// they gather over a sample of the picture, in front of its surfaces and curves. Where more than
// half of the light is held back it writes ids and depth, for the picker and for what is drawn
// later.
//
// Pictures at rest are cast band by band, for on software GL all at once would keep a window
// waiting.
class CastPass {
public:
    static constexpr int bands = 16;
    // A band from the bottom, or with a divisor above 1 all of the picture.
    void draw(Tools& tools, const Targets& targets, const Frame& frame, const Scene& scene,
              const Quality& quality, int band);

private:
    void draw(Tools& tools, const Targets& targets, const CastItem& item, const CastView& view,
              const Quality& quality, const LayerBounds& bounds);
    void cast_on_processor(const Targets& targets, const CastItem& item, const CastView& view,
                           glm::ivec2 size_px, const LayerBounds& there, bool linear) const;
    Texture2D gathered_, hits_; // as large as the largest picture yet
    Framebuffer to_gathered_;
};

// The programs that cast through fields of an order, and those that lay the result over the
// picture.
ProgramName cast_program(FieldOrder order, bool rough);
ProgramName cast_over_program(bool ids);

} // namespace trivar::gpu
