// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/tiles/tiles.h"
#include "editor/hands/painted_surface.h"
#include "editor/hands/tool.h"

namespace trivar {

// StrandHandles are the points of the strands of a layer of tiles, which hands drag over the
// surface. Those of one strand are shown: the one that the mouse is nearest to. A drag is one step;
// points near the one that is dragged go along, but for Ctrl.
class StrandHandles {
public:
    // `layer` is the layer that is selected; 0: none. Returns whether the mouse is on a point, or
    // drags one, so that it belongs to nobody else.
    bool use(Session& session, const ViewportInput& input, PaintedSurface& surface, Id layer);
    bool busy() const { return drag_.has_value(); }
    bool hovers() const { return hovered_.has_value(); }
    void cancel(Session& session);
    void forget(); // no strand is shown any more
    void overlay(const Session& session, const ui::Theme& theme, const ViewportInput& input) const;

private:
    struct StrandHold {
        std::size_t stroke = 0, sample = 0;
        bool operator==(const StrandHold&) const = default;
    };
    struct StrandDrag {
        Id layer = 0;
        StrandHold held;
        TileStroke before, stroke; // as it becomes
        bool moved = false, proposed = true;
        glm::dvec2 from_px{0};
    };
    void drag_to(const Session& session, const SurfaceHit& hit, PaintedSurface& surface, Id base);
    void find(const Session& session, const ViewportInput& input, PaintedSurface& surface,
              Id layer);

    std::optional<StrandHold> hovered_;
    std::optional<StrandDrag> drag_;
    std::vector<std::pair<StrandHold, glm::dvec3>> shown_; // points of one strand, in the world
};

} // namespace trivar
