// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/hands/placement_handles.h"
#include "editor/hands/tool.h"

namespace trivar {

// A SelectTool selects what is under the mouse by a click; Shift or Ctrl click adds or removes it.
// A drag that begins on nothing, or anywhere after begin_box(), selects what is seen in a box; with
// Shift or Ctrl it adds.
class SelectTool : public Tool {
public:
    SelectTool(ToolFacts facts, std::shared_ptr<HandleChoice> choice)
        : Tool(std::move(facts)),
          choice_(std::move(choice))
    {
    }
    ToolState state() const override;
    void use(Session& session, const ViewportInput& input) override;
    void take_keys(Session&) override { handles_.take_keys(); }
    void cancel(Session& session) override;
    void overlay(const Session& session, const ui::Theme& theme,
                 const ViewportInput& input) const override;
    void options(Session& session, const ui::Theme& theme, float width) override;
    std::vector<Hint> hints(const Session& session) const override;

    void begin_box() { box_ = Box::armed; }

private:
    // armed: the next drag draws the box; pressed: on nothing, so far a click.
    enum class Box { none, armed, pressed, drawn } box_ = Box::none;
    glm::dvec2 corner_px_{0}; // of the box, where the drag began
    std::shared_ptr<HandleChoice> choice_;
    Handles handles_; // of the selected placement
};

// Paints the box of a choice that is being drawn from one corner to the mouse, in pixels of the
// picture.
void paint_choice_box(const ui::Theme& theme, const ViewportInput& input,
                      const glm::dvec2& corner_px);

// Whether a key is held that adds to the selection rather than replacing it: Shift or Ctrl.
bool adds_to_selection();

// Changes the selection for a click on an object, or on nothing. A click on nothing that would add
// changes nothing.
void select_by_click(Session& session, Id under);

} // namespace trivar
