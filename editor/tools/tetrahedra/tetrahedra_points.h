// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tetrahedra/control_places.h"
#include "editor/hands/points_tool.h"

namespace trivar {

// A PullBall is how pulls fade with the distance, and whether the volume may fold.
struct PullBall {
    double radius = 0; // metres in the volume; 0: a share of its size
    Decay decay = Decay::smooth;
    bool guard = true;
    // With that share where it is 0.
    double radius_in(const Session& session, double share) const;
};

// TetrahedraPoints moves the control points of the selected volume of tetrahedra, for the tool that
// works on it and that has the ball. A gesture is one pull.
class TetrahedraPoints : public PointsTool {
public:
    explicit TetrahedraPoints(PullBall& ball) : PointsTool({}, {11, 1}), ball_(ball) {}
    std::optional<std::vector<std::string>> numbers(const Session& session) const override;
    bool resize(Session& session, double factor) override;
    // The pull of the gesture that goes on; null: none does.
    const TetrahedraPull* pull() const { return gesture_ ? &pull_ : nullptr; }
    std::string words() const; // "2 of 125"
    double radius(const Session& session) const;
    int layer() const { return layer_; }
    void choose_layer(int layer) { layer_ = layer; }

private:
    void look(const Session& session) override;
    const EvaluatedObject* seen(const Session& session) const override;
    Id cage_of(const Session& session, Id under) const override;
    std::vector<int> chosen_and_next() const override;
    MotionFrame frame(const Session& session) const override;
    void begin_motion(const Session& session) override;
    Command wanted(const Session& session) override;
    const char* axes_words(const Session&) const override { return "Along an axis"; }
    std::vector<float> shares() const override;
    void paint_point(const ui::Theme& theme, int point, const Paint& how) const override;
    void paint_motion(const Session& session, const ui::Theme& theme,
                      const ViewportInput& input) const override;

    PullBall& ball_;
    int layer_ = 0;
    Ref<SimplexBasis<3>> basis_; // whose places these are
    std::vector<ControlPlace> places_;
    Ref<SimplexVolume> volume_; // by which they are where they are
    glm::dmat4 to_world_{1};
    glm::dmat3 axes_{1}, to_volume_{1}; // as the gesture began
    TetrahedraPull alone_;              // of the chosen ones and no others, by nothing
    TetrahedraPull pull_;               // wanted last
};

} // namespace trivar
