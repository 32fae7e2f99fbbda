// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/objects/shape.h"
#include "core/placement/placement.h"
#include "editor/hands/gesture.h"
#include "editor/hands/parts_tool.h"
#include "editor/hands/tool.h"
#include "editor/hands/typed_amounts.h"
#include "editor/picture/volume_surface.h"

namespace trivar {

// A ball that is pressed into the volume of the selected placed object, or draws it out. Put down
// and dragged it presses as deep as it is dragged; as a brush it presses wherever it is drawn. What
// is seen is the proposal; a stroke is one step.
class PressTool : public Tool, public PartsTool {
public:
    using Tool::Tool;
    ToolState state() const override;
    PartsTool* parts() override { return this; }
    void use(Session& session, const ViewportInput& input) override;
    bool resize(Session& session, double factor) override;
    void take_keys(Session& session) override;
    void cancel(Session& session) override { gesture_.cancel(session); }
    std::vector<VolumePart> held(const Session& session) const override;
    Helpers helpers(const Session& session, const ui::Theme& theme) const override;
    void overlay(const Session& session, const ui::Theme& theme,
                 const ViewportInput& input) const override;
    void options(Session& session, const ui::Theme& theme, float width) override;
    std::vector<Hint> hints(const Session& session) const override;

private:
    enum class By { drag, brush };
    struct Pressing {
        Id object = 0;
        By by = By::drag;
        Press press;
        Lattice volume;        // that it began with
        glm::dvec2 into_px{0}; // metres of depth per pixel, along the drag
        double scale = 1;      // of the world to the space of the stroke, in which it presses
    };
    void begin(Session& session, const ViewportInput& input);
    void find_place(const Session& session, const ViewportInput& input); // under the mouse
    void go_on(Session& session, const ViewportInput& input);
    void extend(const Camera& camera, const ViewportInput& input);
    bool holds_points() const;   // the gesture's ball, anywhere on its way
    void tell(Session& session); // what became of the last stroke
    bool offer_points(Session& session, Id id, const Lattice& volume) const;
    Command command() const;
    double radius(const Placement& placement) const;
    double strength(const Placement& placement) const;

    Decay decay_ = Decay::gaussian;
    By by_ = By::drag;
    double radius_ = 0, strength_ = 0; // metres; 0: in proportion to the volume
    bool mirror_ = false, guard_ = true, into_scene_ = false;

    Ref<Placement> placement_; // whose surface that is
    VolumeSurface surface_;
    std::optional<OnVolume> at_; // under the mouse
    glm::dvec3 last_at_{0};      // uvw of that, also when it has left the volume
    Id last_of_ = 0;             // of that object; 0: it never was there
    GestureWith<Pressing> gesture_;
    TypedAmounts typed_;
    Id told_of_ = 0; // whose last stroke is still to be told of
    Press told_;     // that stroke
};

} // namespace trivar
