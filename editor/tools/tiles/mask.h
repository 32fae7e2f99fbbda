// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/tiles/mask_tiles.h"
#include "editor/hands/painted_surface.h"
#include "editor/hands/tool.h"

namespace trivar {

// The objects round whose curves a gradient can go: those that lie on a stroke, and models that
// show lines.
std::vector<Id> curve_objects(const Session& session);

// Returns how far a gradient round a curve reaches unless somebody says so: a quarter of the
// longest side of the base of a layer, metres.
double usual_reach(const Session& session, Id layer);

// Lays gradients over a layer of tiles: a drag says from where to where along a line, or how far
// round a point; a click on an object with a curve lays one round that. Another drag replaces the
// gradient that drives the same.
class MaskTool : public Tool {
public:
    using Tool::Tool;
    ToolState state() const override
    {
        return {.busy = gesture_.has_value(), .crosshair = hit_ || gesture_};
    }
    void use(Session& session, const ViewportInput& input) override;
    void cancel(Session& session) override;
    void overlay(const Session& session, const ui::Theme& theme,
                 const ViewportInput& input) const override;
    void options(Session& session, const ui::Theme& theme, float width) override;
    std::vector<Hint> hints(const Session& session) const override;

private:
    struct Gesture {
        MaskTiles command;
        SurfaceHit from;
        std::optional<SurfaceHit> to;
    };
    static Id layer(const Session& session); // 0: none is selected
    // Finds the place where a ray meets the base of the layer; if that is hidden, its tiles, with
    // the point on the base's model that has no volume.
    std::optional<SurfaceHit> hit(const Session& session, Id layer, const Ray& ray);
    // The command that lays a gradient like the settings, in place of the one that it replaces.
    MaskTiles command_for(const Session& session) const;
    void lay_round_curve(Session& session, const ViewportInput& input);
    void begin(Session& session, const ViewportInput& input);
    void go_on(Session& session, const ViewportInput& input);

    TileMask settings_{};
    PaintedSurface surface_;
    std::optional<SurfaceHit> hit_;
    std::optional<Gesture> gesture_;
};

} // namespace trivar
