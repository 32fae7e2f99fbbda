// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/hands/motion_gesture.h"
#include "editor/hands/parts_tool.h"
#include "ui/option_bar.h"

#include <optional>

namespace trivar {

struct EvaluatedObject;

// If there are more handles than that, only those near the mouse are shown as such, pixels at scale
// 1: others would be a cloud that hides the model.
inline constexpr std::size_t many_handles = 300;
inline constexpr double handles_near_px = 90;
inline constexpr std::size_t most_shown_points = 20000; // of more those round the mouse

// A PointsTool moves, turns and scales control points of the cage of the selected object: a click,
// a double click or a box chooses some, a drag on one of them or on the handles moves them. A tool
// derives from it, says where the points are, and gives the command for a motion. Points have
// numbers from 0 up.
class PointsTool : public Tool, public PartsTool {
public:
    // How near the mouse has to be to a point, pixels at scale 1; of points that are as near as
    // `cover` to each other, pixels, the one nearer to the eye is taken.
    struct Reach {
        double mouse = 0, cover = 0;
    };
    PointsTool(ToolFacts facts, Reach reach) : Tool(std::move(facts)), reach_px_(reach) {}
    ToolState state() const override;
    PartsTool* parts() override { return this; }
    bool choose(Session& session, PartChoice choice) override;
    bool grab(Session& session, MotionKind kind) override;
    bool* proportional() override { return &proportional_; }
    void use(Session& session, const ViewportInput& input) override;
    void take_keys(Session& session) override;
    void cancel(Session& session) override;
    void overlay(const Session& session, const ui::Theme& theme,
                 const ViewportInput& input) const override;
    std::vector<Hint> hints(const Session& session) const override;
    void add_proportional_option(std::vector<ui::Option>& options, const ui::Theme& theme);

protected:
    // Looks at the selected cage: sets its object, 0 where there is none, and where its points are,
    // and keeps of the chosen ones those that are still there.
    virtual void look(const Session& session) = 0;
    virtual const EvaluatedObject*
    seen(const Session& session) const = 0; // of that object; or null
    // The object whose cage holds what is under the mouse; 0: none.
    virtual Id cage_of(const Session& session, Id under) const = 0;
    virtual std::vector<int> chosen_and_next() const = 0;
    // The following are asked while points are chosen. The handles' frame, in the world:
    virtual MotionFrame frame(const Session& session) const = 0;
    virtual void begin_motion(const Session& session) = 0;
    virtual Command wanted(const Session& session) = 0;
    virtual void committed() {}
    virtual void choose_line(const Session& session) { (void)session; } // by a double click
    virtual const char* axes_words(const Session& session) const = 0;

    // One share per point: how much of the motion it takes, 0..1.
    virtual std::vector<float> shares() const = 0;
    struct Paint {       // of a point
        glm::vec2 at{0}; // in the window
        double pixels_per_metre = 0;
        float share = 0;
        bool lit = false;
    };
    virtual void paint_point(const ui::Theme& theme, int point, const Paint& how) const = 0;
    virtual void paint_motion(const Session& session, const ui::Theme& theme,
                              const ViewportInput& input) const = 0;
    static void paint_words(const ui::Theme& theme, const ViewportInput& input,
                            const std::string& words, bool stopped);

    static std::vector<std::string> numbers_below(const std::string& name); // of a motion
    // The angles of a turn about an axis, along the axes that the angles are about.
    static glm::dvec3 turn_of(const Motion& motion, const glm::dvec3& axis);
    // Rounding by a transform that was undone is no digit of what a hand or keys said.
    static glm::dvec3 without_rounding(const glm::dvec3& v) { return glm::round(v * 1e9) / 1e9; }

    Id object_ = 0;
    std::vector<glm::dvec3> at_world_; // one per point
    std::vector<int> chosen_;          // in the order they were chosen
    std::optional<int> hovered_;
    MotionGesture gesture_;
    bool proportional_ = false;

private:
    std::optional<int> point_at(const Camera& camera, const ViewportInput& input) const;
    void press(Session& session, const ViewportInput& input);
    void end_box(Session& session, const ViewportInput& input);
    void begin(const Session& session, const ViewportInput& input, const GizmoHandle& handle,
               MotionKind kind = MotionKind::move);
    void ended(Gesture::State state);
    void paint_points(const Session& session, const ui::Theme& theme,
                      const ViewportInput& input) const;

    Reach reach_px_;
    std::optional<int> pressed_; // a click on it chooses it alone
    GizmoHandle hovered_handle_;
    std::optional<glm::dvec2> box_px_;   // where it began
    std::optional<MotionKind> grabbing_; // a gesture by its key begins in this frame
};

} // namespace trivar
