// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/tools/placement_holds.h"
#include "editor/tools/tool.h"
#include "ui/option_bar.h"

namespace trivar {

// Which handles of a placed object are shown; the same for all tools that show them.
enum class HandleChoice { all, stroke, sizes, none };

// The handles of the one selected object that lies on a stroke, for the tools that show them. A
// drag is one step.
class PlacementHandles {
public:
    explicit PlacementHandles(std::shared_ptr<HandleChoice> choice) : choice_(std::move(choice)) {}

    bool shown(const Session& session) const;
    // Whether the mouse is on a handle, or drags one, and is nobody else's.
    bool use(Session& session, const ViewportInput& input);
    bool busy() const { return drag_.has_value(); }
    void cancel(Session& session);
    void overlay(const Session& session, const ui::Theme& theme, const ViewportInput& input) const;
    std::vector<Hint> hints() const; // of a drag
    bool hovers() const { return hovered_.kind != HoldKind::none; }
    // The choice of handles, where an object that has some is selected.
    std::optional<ui::Option> option(const Session& session, const ui::Theme& theme);

private:
    std::vector<HoldPoint> points(const Session& session) const;

    std::shared_ptr<HandleChoice> choice_;
    Hold hovered_;
    std::optional<HoldDrag> drag_;
    glm::dvec2 at_px_{0};
    bool moved_ = false;
};

// The selected object, if it is the only one, lies on a stroke, can be seen and is not locked.
const EvaluatedObject* selected_placement(const Session& session);
// The same of any volume: that of a placed object, or of a lattice.
const EvaluatedObject* selected_volume(const Session& session);

} // namespace trivar
