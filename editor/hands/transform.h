// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/hands/laid_motion.h"
#include "editor/hands/motion_gesture.h"

#include <memory>
#include <optional>

namespace trivar {

// A TransformTool moves, turns or scales the selection: by a drag on a handle, or after its key
// with the mouse free until a click. The proposal is what is seen; a gesture is one step. A click
// beside the handles selects. What lies on a stroke moves over the surface, with its stroke.
class TransformTool : public Tool {
public:
    TransformTool(ToolFacts facts, MotionKind kind, std::shared_ptr<TransformChoices> choices)
        : Tool(std::move(facts)),
          kind_(kind),
          choices_(std::move(choices))
    {
    }
    std::optional<MotionKind> motion() const override { return kind_; }
    ToolState state() const override
    {
        return {.busy = gesture_ || beginning_, .waits = beginning_};
    }
    void begin(Session& session) override;
    void use(Session& session, const ViewportInput& input) override;
    void take_keys(Session& session) override;
    bool awaits(const ui::Chord& chord) const override;
    void cancel(Session& session) override;
    void overlay(const Session& session, const ui::Theme& theme,
                 const ViewportInput& input) const override;
    void options(Session& session, const ui::Theme& theme, float width) override;
    std::vector<Hint> hints(const Session& session) const override;

private:
    std::optional<MotionFrame> handles_at(const Session& session) const;
    std::vector<HandleShape> handles(const Session& session, double scale) const;
    void start(const Session& session, const ViewportInput& input, Grasp grasp, bool by_key);
    void refuse(Session& session);
    // Whether the place of the selected object is not known yet.
    bool is_coming(const Session& session) const;
    // Returns the command for the present motion; nothing: nothing can lie at the mouse.
    std::optional<Command> wanted(const Camera& camera) const;
    // Beside all that it could lie on it stays where it was seen last.
    std::optional<Command> wanted_last(const Camera& camera);
    void commit(Session& session);
    std::string amount(const Session& session) const;
    std::string words(const Session& session) const;
    void gesture_overlay(const Session& session, const ui::Theme& theme,
                         const ViewportInput& input) const;
    std::vector<Hint> hints_at_work(const Session& session) const;
    std::vector<Hint> hints_at_rest(const Session& session) const;

    MotionKind kind_;
    std::shared_ptr<TransformChoices> choices_;
    MotionGesture gesture_;
    std::optional<LaidStand> laid_; // what the gesture moves, where it lies on a stroke
    // Begun by its key, as soon as it is known where the mouse is and where the objects lie.
    bool beginning_ = false;
    double refused_s_ = -1e9; // when there was nothing to move, although axes may follow
    GizmoHandle hovered_;
    std::optional<Command> last_; // what was wanted last
};

} // namespace trivar
