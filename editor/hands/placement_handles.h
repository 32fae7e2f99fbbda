// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/hands/placement_holds.h"
#include "editor/hands/tool.h"
#include "ui/option_bar.h"

namespace trivar {

// Which handles of a placed object are shown; all tools that show them share the choice.
enum class HandleChoice { all, stroke, sizes, none };

// PlacementHandles are the handles of the one selected object on a stroke, for the tools that show
// them. A drag is one step.
class PlacementHandles {
public:
    explicit PlacementHandles(std::shared_ptr<HandleChoice> choice) : choice_(std::move(choice)) {}

    bool shown(const Session& session) const;
    // Returns whether the mouse is on a handle, or drags one, so that it belongs to nobody else.
    bool use(Session& session, const ViewportInput& input);
    bool busy() const { return drag_.has_value(); }
    void cancel(Session& session);
    void overlay(const Session& session, const ui::Theme& theme, const ViewportInput& input) const;
    std::vector<Hint> hints() const; // of a drag
    bool hovers() const { return hovered_.kind != HoldKind::none; }
    // The option to choose handles, where an object with handles is selected.
    std::optional<ui::Option> option(const Session& session, const ui::Theme& theme);

private:
    std::vector<HoldPoint> points(const Session& session) const;

    std::shared_ptr<HandleChoice> choice_;
    Hold hovered_;
    std::optional<HoldDrag> drag_;
    glm::dvec2 at_px_{0};
    bool moved_ = false;
};

// The selected object, if it is the only one, lies on a stroke, is visible and not locked; else
// null.
const EvaluatedObject* selected_placement(const Session& session);
// The same for any volume: that of a placed object, or of a lattice.
const EvaluatedObject* selected_volume(const Session& session);

} // namespace trivar
