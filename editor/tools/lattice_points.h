// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/tools/gesture.h"
#include "editor/tools/tool.h"

#include <optional>

namespace trivar {

// Moves control points of the volume of the selected lattice or placed object: a click or a box
// chooses some, a drag on one of them or on the handles moves them, along the volume's own
// directions. What is seen is the proposal; a gesture is one step.
class LatticePointsTool : public Tool {
public:
    std::string name() const override { return "Lattice"; }
    const char* icon() const override;
    std::string help() const override
    {
        return "Move control points of a lattice, or of the volume of a placed model.";
    }
    std::string page() const override { return "lattice"; }
    std::vector<ui::Chord> keys() const override { return {{'V'}, {'4'}}; }
    bool grab(Session& session) override;
    void use(Session& session, const ViewportInput& input) override;
    bool busy() const override { return gesture_.has_value() || box_px_.has_value(); }
    bool shows_volume() const override { return true; }
    void take_keys(Session& session) override;
    void cancel(Session& session) override;
    std::vector<VolumePart> held_parts(const Session& session) const override;
    std::vector<gpu::Line> lines(const Session& session, const ui::Theme& theme) const override;
    void overlay(const Session& session, const ui::Theme& theme,
                 const ViewportInput& input) const override;
    void options(Session& session, const ui::Theme& theme, float width) override;
    std::vector<Hint> hints(const Session& session) const override;

private:
    void keep_what_is_there(const Session& session);
    std::optional<glm::ivec3> point_at(const Session& session, const ViewportInput& input) const;
    void choose(const Session& session, const ViewportInput& input);
    void choose_in_box(const Session& session, const ViewportInput& input);
    void begin(const Session& session, const ViewportInput& input, const Handle& handle);
    void go_on(Session& session, const ViewportInput& input);
    void finish(Session& session);
    void tell(Session& session);
    Command command() const;

    Id object_ = 0;
    glm::ivec3 of_{0};               // its control points along, across and up
    std::vector<glm::ivec3> chosen_; // of that one's volume, in the order they were chosen
    std::optional<glm::ivec3> hovered_;
    Handle hovered_handle_;
    std::optional<glm::dvec2> box_px_; // where it began
    std::optional<TransformGesture> gesture_;
    glm::dvec3 shown_{0}; // proposed last, along the volume's directions
    bool mirror_ = false, guard_ = true;
    bool grabbing_ = false; // a gesture by its key begins in this frame
    bool by_key_ = false;   // the gesture goes on till a click
    bool outside_ = false;  // the mouse is not over the picture
    Id told_of_ = 0;
};

} // namespace trivar
