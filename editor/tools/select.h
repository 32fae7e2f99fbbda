// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/tools/tool.h"

namespace trivar {

// Click to select what is under the mouse, click nothing to select nothing.
class SelectTool : public Tool {
public:
    std::string name() const override { return "Select"; }
    const char* icon() const override;
    std::string help() const override { return "Click an object to select it."; }
    std::vector<ui::Chord> keys() const override { return {{'Q'}, {'1'}}; }
    void use(Session& session, const ViewportInput& input) override;
    void options(Session& session, const ui::Theme& theme, float width) override;
    std::vector<Hint> hints(const Session& session) const override;
};

} // namespace trivar
