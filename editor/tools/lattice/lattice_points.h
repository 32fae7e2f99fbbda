// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/hands/points_tool.h"
#include "editor/hands/proportional.h"

namespace trivar {

// Moves, turns and scales control points of the volume of the selected lattice or placed object,
// along the volume's own directions. A double click chooses a row, or with Shift a plane. What is
// seen is the proposal; a gesture is one step.
class LatticePointsTool : public PointsTool {
public:
    explicit LatticePointsTool(ToolFacts facts) : PointsTool(std::move(facts), {10, 0}) {}
    std::optional<std::vector<std::string>> numbers(const Session& session) const override;
    std::vector<VolumePart> held(const Session& session) const override;
    bool resize(Session& session, double factor) override;
    void use(Session& session, const ViewportInput& input) override;
    Helpers helpers(const Session& session, const ui::Theme& theme) const override;
    void options(Session& session, const ui::Theme& theme, float width) override;
    std::vector<Hint> hints(const Session& session) const override;

private:
    void look(const Session& session) override;
    const EvaluatedObject* seen(const Session& session) const override;
    Id cage_of(const Session& session, Id under) const override { return (void)session, under; }
    std::vector<int> chosen_and_next() const override;
    MotionFrame frame(const Session& session) const override;
    void begin_motion(const Session& session) override;
    Command wanted(const Session& session) override;
    void committed() override { told_of_ = object_; }
    void choose_line(const Session& session) override;
    const char* axes_words(const Session& session) const override;
    std::vector<float> shares() const override;
    void paint_point(const ui::Theme& theme, int point, const Paint& how) const override;
    void paint_motion(const Session& session, const ui::Theme& theme,
                      const ViewportInput& input) const override;

    void tell(Session& session);
    void add_falloff_options(std::vector<ui::Option>& options, const ui::Theme& theme,
                             const Lattice& volume);
    double radius(const Lattice& volume) const; // of proportional editing, metres
    std::vector<glm::ivec3> chosen_points() const;
    PointShift shift_by_nothing() const; // of the chosen ones
    PointShift shift() const;            // what the gesture says now
    // The handles stand in the middle, along the directions at the first point.
    MotionFrame frame_of(const Lattice& volume) const;

    glm::ivec3 of_{0}; // its control points along, across and up
    // The state in which the gesture began: the volume's directions at the first point, by columns,
    // before the object's own transform and after it, what takes a direction of the world there,
    // and how far all points are. The handles' directions differ where a lattice round this one
    // bends what is seen of it.
    glm::dmat3 axes_{1}, world_axes_{1}, from_world_{1};
    // Own length by seen length along each of these axes: other volumes stretch the cage.
    glm::dvec3 own_by_seen_{1};
    std::vector<PointDistance> distances_;
    PointShift shown_; // wanted last
    Falloff falloff_ = Falloff::smooth;
    double radius_m_ = 0;      // 0: half of the volume's longest side
    glm::bvec3 mirror_{false}; // along, across, up
    bool guard_ = true;
    Id told_of_ = 0;
    // The row or plane that was chosen last by its point: the same again is along the next axis.
    std::optional<int> line_at_;
    bool line_is_plane_ = false;
    int line_axis_ = 0;
};

} // namespace trivar
