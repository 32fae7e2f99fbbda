// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/objects/shape.h"
#include "editor/hands/motion_gesture.h"
#include "editor/hands/proportional.h"
#include "ui/option_bar.h"

#include <optional>

namespace trivar {

// Moves, turns and scales control points of the volume of the selected lattice or placed object: a
// click, a double click or a box chooses some, a drag on one of them or on the handles moves them,
// along the volume's own directions. What is seen is the proposal; a gesture is one step.
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
    bool grab(Session& session, MotionKind kind) override;
    std::optional<std::vector<std::string>> numbers(const Session& session) const override;
    bool choose_parts(Session& session, PartChoice choice) override;
    std::optional<bool> proportional() const override { return proportional_.on; }
    void set_proportional(bool on) override { proportional_.on = on; }
    bool takes_wheel() const override { return gesture_ && proportional_.on; }
    bool resize(Session& session, double factor) override;
    void use(Session& session, const ViewportInput& input) override;
    bool busy() const override { return gesture_.going() || box_px_.has_value(); }
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
    // The selected volume as it is seen; the volume must be there.
    Ref<Lattice> cage(const Session& session) const;
    std::optional<glm::ivec3> point_at(const Session& session, const ViewportInput& input) const;
    void choose(const Session& session, const ViewportInput& input);
    void choose_line(const Session& session);
    void choose_in_box(const Session& session, const ViewportInput& input);
    void begin(const Session& session, const ViewportInput& input, const GizmoHandle& handle,
               MotionKind kind = MotionKind::move);
    void go_on(Session& session, const ViewportInput& input);
    void tell(Session& session);
    void paint_points(const Session& session, const ui::Theme& theme,
                      const ViewportInput& input) const;
    void paint_gesture(const Session& session, const ui::Theme& theme,
                       const ViewportInput& input) const;
    void add_proportional_options(std::vector<ui::Option>& options, const ui::Theme& theme,
                                  const Lattice& volume);
    double radius(const Lattice& volume) const; // of proportional editing, metres
    PointShift held() const;                    // the chosen ones, by nothing as yet
    PointShift shift() const;                   // what the gesture says now
    Command wanted();
    // The handles stand in the middle, along the directions at the first point.
    MotionFrame frame_of(const Lattice& volume) const;

    Id object_ = 0;
    glm::ivec3 of_{0};               // its control points along, across and up
    std::vector<glm::ivec3> chosen_; // of that one's volume, in the order they were chosen
    std::optional<glm::ivec3> hovered_;
    GizmoHandle hovered_handle_;
    std::optional<glm::ivec3> pressed_; // a click on it chooses it alone
    std::optional<glm::dvec2> box_px_;  // where it began
    MotionGesture gesture_;
    MotionKind kind_ = MotionKind::move; // of the gesture
    // As it began: the volume's directions at the first point, by columns, before the object's own
    // transform and after it, what takes a direction of the world there, and how far all points
    // are. The handles' directions differ where a lattice round this one bends what is seen of it.
    glm::dmat3 axes_{1}, world_axes_{1}, from_world_{1};
    // Own length by seen length along each of these axes: other volumes stretch the cage.
    glm::dvec3 own_by_seen_{1};
    std::vector<PointDistance> distances_;
    PointShift shown_; // wanted last
    Proportional proportional_;
    glm::bvec3 mirror_{false}; // along, across, up
    bool guard_ = true;
    std::optional<MotionKind> grabbing_; // a gesture by its key begins in this frame
    Id told_of_ = 0;
    // The row or plane that was chosen last by its point: the same again is along the next axis.
    std::optional<glm::ivec3> line_at_;
    bool line_is_plane_ = false;
    int line_axis_ = 0;
};

} // namespace trivar
