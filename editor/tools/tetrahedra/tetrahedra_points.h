// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tetrahedra/control_places.h"
#include "editor/hands/motion_gesture.h"

#include <optional>

namespace trivar {

// TetrahedraPoints are the control points of the selected volume of tetrahedra as handles, for the
// tool that works on it: a click or a box chooses some, a drag on one of them or on the arrows
// moves them. A gesture is one pull.
class TetrahedraPoints {
public:
    // How neighbours go along, and whether the volume may fold.
    struct Manner {
        bool proportional = false;
        double radius = 0; // metres in the volume
        Decay decay = Decay::smooth;
        bool guard = true;
    };
    void use(Session& session, const ViewportInput& input, const Manner& manner);
    bool busy() const { return gesture_.going() || box_px_.has_value(); }
    bool drags() const { return gesture_.going(); }
    void cancel(Session& session);
    bool grab(Session& session, MotionKind kind);
    bool choose(const Session& session, PartChoice choice);
    std::optional<std::vector<std::string>> numbers(const Session& session) const;
    void take_keys(Session& session);

    void overlay(const Session& session, const ui::Theme& theme, const ViewportInput& input,
                 const Manner& manner) const;
    std::vector<Hint> hints() const;
    // The pull of the gesture that goes on; null: none does.
    const TetrahedraPull* pull() const { return gesture_ ? &pull_ : nullptr; }
    std::string words() const; // "2 of 125"
    int layer() const { return layer_; }
    void choose_layer(int layer) { layer_ = layer; }

private:
    void follow(const Session& session);
    std::optional<int> place_at(const Session& session, const ViewportInput& input) const;
    void choose_at(const Session& session, const ViewportInput& input);
    void choose_in_box(const Session& session, const ViewportInput& input);
    void begin(const Session& session, const ViewportInput& input, const GizmoHandle& handle,
               MotionKind kind);
    void go_on(Session& session, const ViewportInput& input);
    Command wanted();
    MotionFrame frame(const EvaluatedObject& volume) const;

    Id object_ = 0;
    int layer_ = 0;
    Ref<SimplexBasis<3>> basis_; // whose places these are
    std::vector<ControlPlace> places_;
    Ref<SimplexVolume> volume_; // by which they are where they are
    glm::dmat4 to_world_{1};
    std::vector<glm::dvec3> at_world_; // one per place
    std::vector<int> chosen_;          // numbers of places, in the order they were chosen
    std::optional<int> hovered_, pressed_;
    GizmoHandle hovered_handle_;
    std::optional<glm::dvec2> box_px_; // where it began
    MotionGesture gesture_;
    MotionKind kind_ = MotionKind::move;
    glm::dmat3 axes_{1}, to_volume_{1}; // as the gesture began
    TetrahedraPull alone_;              // of the chosen ones and no others, by nothing
    TetrahedraPull pull_;               // wanted last
    Manner manner_;
    std::optional<MotionKind> grabbing_; // a gesture by its key begins in this frame
};

} // namespace trivar
