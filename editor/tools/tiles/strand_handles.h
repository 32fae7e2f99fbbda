// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/tiles/tiles.h"
#include "editor/hands/handles.h"
#include "editor/hands/painted_surface.h"

namespace trivar {

// StrandHandles are the points of the strands of a layer of tiles, which hands drag over the
// surface. Those of one strand are shown: the one that the mouse is nearest to. A drag is one step;
// points near the one that is dragged go along, but for Ctrl.
class StrandHandles {
public:
    // `layer` is the layer that is selected; 0: none. Returns whether the mouse is on a point, or
    // drags one, so that it belongs to nobody else.
    bool use(Session& session, const ViewportInput& input, PaintedSurface& surface, Id layer);
    const Handles& hand() const { return hand_; }
    void cancel(Session& session);
    void overlay(const Session& session, const ui::Theme& theme, const ViewportInput& input) const;

private:
    struct StrandDrag {
        Id layer = 0;
        std::size_t held = 0;      // the sample in the hand
        bool moved = false;        // by more than a click
        TileStroke before, stroke; // as it becomes
    };
    void drag_to(const Session& session, const SurfaceHit& hit, PaintedSurface& surface, Id base);
    void find(const Session& session, const ViewportInput& input, PaintedSurface& surface,
              Id layer);
    HandleDrag drag_of(const Session& session, Id layer, std::size_t number, std::size_t sample);

    Handles hand_;
    std::shared_ptr<StrandDrag> drag_; // what hand_ drags
    std::vector<Handle> shown_;        // of one strand, in its order
};

} // namespace trivar
