// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/hands/parts_tool.h"
#include "editor/hands/tool.h"
#include "editor/tools/incise/crossing_handles.h"
#include "editor/tools/incise/incision_stroke.h"

namespace trivar {

// Cuts the skin of what is under the mouse open along a stroke, which opens while it is drawn. The
// incision that is chosen has handles; a drag of one is one step. A click on an incision chooses
// it.
class InciseTool : public Tool, public PartsTool {
public:
    using Tool::Tool;
    ToolState state() const override;
    PartsTool* parts() override { return this; }
    void use(Session& session, const ViewportInput& input) override;
    void take_keys(Session& session) override;
    bool awaits(const ui::Chord& chord) const override;
    bool resize(Session& session, double factor) override;
    std::optional<std::vector<std::string>> numbers(const Session& session) const override;
    bool choose(Session& session, PartChoice choice) override;
    bool remove(Session& session) override;
    void cancel(Session& session) override;
    void overlay(const Session& session, const ui::Theme& theme,
                 const ViewportInput& input) const override;
    Helpers helpers(const Session& session, const ui::Theme& theme) const override;
    void options(Session& session, const ui::Theme& theme, float width) override;
    std::vector<Hint> hints(const Session& session) const override;
    // The handles of the chosen incision, as they are seen, and those where it crosses others; of
    // flaps, those at the crossing near the mouse.
    std::vector<Handle> handles(const Session& session, double scale) const;

private:
    enum class Way { free, straight, uv }; // of strokes
    struct Gesture {
        Id object = 0, under = 0;
        IncisionStroke stroke;
        int clicked = 0;     // the incision under the mouse when it began; 0: none
        double factor = 1;   // of the width, by the wheel
        bool changed = true; // since it was proposed
        // the incision of which a part is drawn anew, and where that begins; none: it is a new one
        std::optional<NamedIncision> redrawn = {};
        double from = 0;
    };
    struct InAir {    // a stroke that has come to no object yet
        Id under = 0; // when it began
        glm::dvec2 begun_px{0}, p_px{0};
    };
    struct Finishing { // the last proposal of a stroke, until it is known what became of it
        Id object = 0;
        int number = 0;
    };
    static const NamedIncision* chosen(const Session& session);
    static Id base_of(const Session& session, Id under); // what would be cut; 0: nothing
    void keep_chosen(Session& session) const;
    void look(const Session& session);
    void hover(Session& session, const ViewportInput& input);
    void press(Session& session, const ViewportInput& input);
    bool begin_stroke(Session& session, const ViewportInput& input, glm::dvec2 at_px, Id under);
    void come_from_air(Session& session, const ViewportInput& input);
    void drag_by_key(Session& session, const ViewportInput& input);
    std::string typed_words(const std::string& said) const;
    void go_on(Session& session, const ViewportInput& input);
    void finish(Session& session);
    void tell_how_it_ended(Session& session);
    NamedIncision drawn(const Gesture& gesture) const;
    Command command_of(const Gesture& gesture) const;
    const SeenIncision* seen_chosen(const Session& session) const; // null: it is not seen
    IncisionSnaps snaps_but(int number) const;
    void paint_stroke(const Session& session, const ui::Theme& theme,
                      const ViewportInput& input) const;

    NamedIncision settings_; // of the next incision; depth and width are those below
    double width_world_ = 0, depth_world_ = 0; // metres; 0: in proportion to object and stroke
    bool opens_ = true, snaps_ = true;
    Way way_ = Way::free;
    IncisedSkin skin_;              // of the selected object
    std::optional<Incising> known_; // of which the cuts are
    Id known_of_ = 0;
    Incising open_; // the same, as far as blades open them now
    Ref<EvaluatedObject> known_shown_;
    std::vector<std::optional<SeenIncision>> cuts_; // by number; nothing: it is not seen
    std::vector<IncisionCrossing> crossings_;
    std::optional<IncisionSnap> hovered_snap_; // where a stroke from the mouse would begin
    glm::dvec2 mouse_px_{-1e9};
    int hovered_cut_ = 0;   // the incision under the mouse; 0: none
    double hovered_at_ = 0; // share of its length
    Id over_ = 0;           // what the mouse is over and could be cut
    std::optional<Gesture> gesture_;
    std::optional<InAir> in_air_;
    Handles handles_;
    TypedAmounts typed_; // the width, while a stroke is drawn
    std::optional<Finishing> finishing_;
    ChosenIncision shown_chosen_;
    int looks_ = 0; // counts up, modulo four, when its lines in the scene change
};

} // namespace trivar
