// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/hands/tool.h"
#include "editor/tools/split/split_holds.h"

namespace trivar {

// Of which the handles are shown.
enum class SplitHandlesOf { openings, cuts };

// SplitHandles are the handles of the one selected object on what parts it, or on its cuts. A drag
// shows its result all the time, and is one step.
class SplitHandles {
public:
    // Returns whether the mouse is on a handle, or drags one, so that it belongs to nobody else.
    bool use(Session& session, const ViewportInput& input, SplitHandlesOf of);
    bool busy() const { return drag_.has_value(); }
    bool hovers() const { return hovered_.kind != SplitHoldKind::none; }
    void cancel(Session& session);
    void overlay(const Session& session, const ui::Theme& theme, const ViewportInput& input,
                 SplitHandlesOf of) const;
    std::vector<Hint> hints() const; // of the handle under the mouse, or of a drag

private:
    SplitHold hovered_;
    std::optional<SplitHoldDrag> drag_;
    glm::dvec2 at_px_{0};
    bool moved_ = false;
};

} // namespace trivar
