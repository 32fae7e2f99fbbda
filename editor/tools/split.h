// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/split.h"
#include "editor/tools/tool.h"

namespace trivar {

// The command with which an obstacle parts the objects besides what parts them already. Without
// one, they open across the way on which the first of them passes the obstacle, or that leads to
// it, and level with the ground, unless the obstacle is a lying bar. Nothing: the objects cannot be
// parted by it; `why` then says so.
std::optional<Split> split_at(const Session& session, const std::vector<Id>& objects, Id obstacle,
                              std::string* why = nullptr);

// Lets a click on an obstacle part what is selected, and shows the cut surface, both walls and the
// gap between them: under the mouse before the click, and of what is parted already.
class SplitTool : public Tool {
public:
    std::string name() const override { return "Split"; }
    const char* icon() const override;
    std::string help() const override
    {
        return "Let an object part round obstacles and close behind them.";
    }
    std::string page() const override { return "split"; }
    std::vector<ui::Chord> keys() const override { return {{'K'}}; }
    void use(Session& session, const ViewportInput& input) override;
    void cancel(Session& session) override;
    std::vector<gpu::Line> lines(const Session& session, const ui::Theme& theme) const override;
    std::vector<gpu::Translucent> veils(const Session& session,
                                        const ui::Theme& theme) const override;
    void options(Session& session, const ui::Theme& theme, float width) override;
    std::vector<Hint> hints(const Session& session) const override;

private:
    // What is selected and can be parted.
    static std::vector<Id> chosen(const Session& session);

    Splitting settings_; // of what it parts anew
    ObstacleUse use_;
    Id shown_ = 0; // the obstacle of which the opening is proposed; 0: none is
};

} // namespace trivar
