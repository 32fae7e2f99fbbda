// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/objects/voxels.h"
#include "editor/hands/gesture.h"
#include "editor/hands/tool.h"

#include <optional>
#include <span>

namespace trivar {

// Works on the levels of volume data: a click on a line chooses its level, a drag up and down
// changes the value, live, and so does the wheel with Ctrl. A dragged value halts where the length
// of the lines hardly changes, as on the histogram, unless Ctrl is held.
class SilhouettesTool : public Tool {
public:
    using Tool::Tool;
    ToolState state() const override;
    void begin(Session& session) override;
    void use(Session& session, const ViewportInput& input) override;
    bool awaits(const ui::Chord& chord) const override;
    void take_keys(Session& session) override;
    void cancel(Session& session) override;
    void overlay(const Session& session, const ui::Theme& theme,
                 const ViewportInput& input) const override;
    void options(Session& session, const ui::Theme& theme, float width) override;
    std::vector<Hint> hints(const Session& session) const override;

private:
    bool turns_level() const; // the wheel, while Ctrl is held
    struct Change {           // of the chosen level
        Id object = 0;
        int level = 0;
        double from_value = 0, value = 0, shift = 0; // shift: pixels of a drag, or notches
        bool by_wheel = false;                       // while Ctrl is held, not by a drag
        glm::dvec2 last_px{0};
        bool moved = false;
        bool halted = false; // the value is where the length of the lines hardly changes
    };
    void press(Session& session, const ViewportInput& input);
    void drag(Session& session, const ViewportInput& input, std::span<const double> plateaus);
    void turn_wheel(Session& session, const ViewportInput& input);
    void take_digits(Session& session) const;
    std::optional<Command> wanted(const Session& session) const;

    GestureWith<Change> gesture_;
    int levels_ = 0;     // number of them in the last frame: digits choose one of several
    bool edits_ = false; // a field of the bar proposes
};

} // namespace trivar
