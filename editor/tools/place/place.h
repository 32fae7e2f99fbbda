// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/profile.h"
#include "editor/hands/placement_handles.h"
#include "editor/hands/stroke_drawing.h"
#include "editor/hands/tool.h"
#include "editor/hands/typed_amounts.h"
#include "ui/option_bar.h"

namespace trivar {

struct EvaluatedObject;

// The effect of a new stroke on a model that lies on one already.
enum class NewStroke { moves, copies };

// Draw one stroke across the scene and a model lies along it. While the mouse is held every new
// piece of the stroke is proposed, so what is seen is the real result; letting go commits it. A
// stroke that begins on that of the selected object draws that part of it anew. Any other one moves
// the model, or lays a copy of it, as the options bar says; Alt does the other of the two.
class PlaceTool : public Tool {
public:
    PlaceTool(ToolFacts facts, std::shared_ptr<HandleChoice> choice)
        : Tool(std::move(facts)),
          choice_(std::move(choice))
    {
    }
    ToolState state() const override;
    // Lays that object next, whatever was chosen before.
    void take_up(Session& session, Id object);
    void use(Session& session, const ViewportInput& input) override;
    void take_keys(Session& session) override;
    void cancel(Session& session) override;
    Helpers helpers(const Session& session, const ui::Theme& theme) const override;
    void overlay(const Session& session, const ui::Theme& theme,
                 const ViewportInput& input) const override;
    void options(Session& session, const ui::Theme& theme, float width) override;
    std::vector<Hint> hints(const Session& session) const override;

private:
    void begin(Session& session, const ViewportInput& input);
    void finish(Session& session);
    Command command(const Session& session) const;
    // Whether a stroke lays a copy of the model now.
    bool copies(const Session& session) const;
    // The selected placement while its handles are shown; null: they are not.
    const EvaluatedObject* handled(const Session& session) const;
    Id laid(const Session& session) const; // the object that the present stroke lays
    void options_of_model(Session& session, const ui::Theme& theme,
                          std::vector<ui::Option>& options);
    void paint_stroke(const Session& session, const ui::Theme& theme,
                      const ViewportInput& input) const;

    Id chosen_ = 0; // in the options bar; 0: by itself
    Id model_ = 0;  // of the stroke that is being drawn
    Box stands_;    // it, before it
    bool drawing_ = false, redrawing_ = false;
    NewStroke new_stroke_ = NewStroke::moves; // of a model that is placed already
    bool other_ = false;                      // Alt is held: the other one
    struct Start {                            // how the stroke lay that is drawn anew
        Sketch sketch;
        glm::dmat4 to_world{1};
        std::optional<Attachment> hosts = {};
    };
    Start start_;
    bool on_line_ = false;   // the mouse is where a stroke would redraw the old one
    bool on_ground_ = false; // the stroke begins on the ground
    std::string why_not_;    // what speaks against a stroke that begins at the mouse
    StrokeDrawing stroke_;
    Brush brush_ = Brush::even;
    double pressure_ = 0.5;          // of a hand without a pen: what the wheel makes of it
    double width_ = 0;               // that wheel or keys made of this stroke's; 0: none
    TypedAmounts typed_;             // the width, while it is drawn
    bool retyped_ = false;           // and not shown yet
    PlacementParameters parameters_; // for the next new placement
    std::shared_ptr<HandleChoice> choice_;
    Handles handles_; // of the selected placement
};

// Whether a stroke can lay the object: groups cannot be laid.
bool can_be_placed(const Document& document, Id id);

// Returns the object that a stroke would lay down: the chosen one, else the selected one unless it
// is the oldest, else the newest one that is not placed yet; 0 if there is none. Groups cannot be
// laid.
Id model_to_place(const Session& session, Id chosen);

// The objects on which the model's strokes fall; empty: all visible ones. Objects that are hidden
// here are not among them.
std::vector<Id> bases_for_stroke(const Session& session, Id model);

} // namespace trivar
