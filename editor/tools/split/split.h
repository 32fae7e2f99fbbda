// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/cutting/split.h"
#include "editor/hands/handles.h"
#include "editor/hands/viewport_input.h"
#include "editor/session/session.h"
#include "editor/tools/split/cut_gesture.h"
#include "ui/option_bar.h"

namespace trivar {

// The command with which an obstacle parts the objects besides what parts them already. Without
// one, they open across the way on which the first of them passes the obstacle, or that leads to
// it, and level with the ground, unless the obstacle is a lying bar. Nothing: the objects cannot be
// parted by it; `why` then says so.
std::optional<Split> split_at(const Session& session, const std::vector<Id>& objects, Id obstacle,
                              std::string* why = nullptr);

enum class SplitAt { obstacle, plane, stroke };

// Lets a click on an obstacle part what is selected, and shows the cut surface, both walls and the
// gap between them: under the mouse before the click, and of what is parted already. Or cuts the
// active object along a line or a stroke that is drawn over it. What parts or cuts the selected
// object has handles.
class SplitTool : public Tool {
public:
    using Tool::Tool;
    ToolState state() const override;
    void use(Session& session, const ViewportInput& input) override;
    void take_keys(Session&) override { handles_.take_keys(); }
    void cancel(Session& session) override;
    void overlay(const Session& session, const ui::Theme& theme,
                 const ViewportInput& input) const override;
    Helpers helpers(const Session& session, const ui::Theme& theme) const override;
    void options(Session& session, const ui::Theme& theme, float width) override;
    std::vector<Hint> hints(const Session& session) const override;
    void set_at(Session& session, SplitAt at); // as in the options bar

private:
    // Returns the selected objects that can be parted.
    static std::vector<Id> chosen(const Session& session);
    std::vector<Handle> handles(const Session& session, double scale) const;
    // Whether the mouse has not moved since it showed what it is on.
    bool rests(const Session& session, const ViewportInput& input) const
    {
        return shown_ != 0 && input.hovered &&
               shown_for_ == std::pair(input.mouse, session.view.camera);
    }
    void use_obstacles(Session& session, const ViewportInput& input);
    void add_obstacle_options(std::vector<ui::Option>& options, const Session& session,
                              const ui::Theme& theme);
    void add_cut_options(std::vector<ui::Option>& options, const Session& session,
                         const ui::Theme& theme);

    SplitAt at_ = SplitAt::obstacle;
    CutGesture cut_;
    Handles handles_;
    PlainCut one_;       // how the next cut keeps
    Splitting settings_; // of what it parts anew; what it cuts is closed and filled like that
    ObstacleUse use_;
    // The typed values; none: those that suit the size of the selected object.
    std::optional<double> gap_, clearance_;
    Id shown_ = 0; // the obstacle of which the opening is proposed; 0: none is
    // The mouse and the view for which it is. What opens under them may hide the obstacle, and its
    // handles may come there.
    std::pair<glm::dvec2, Camera> shown_for_;
};

} // namespace trivar
