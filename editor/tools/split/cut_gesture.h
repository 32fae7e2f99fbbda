// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/cutting/cut.h"
#include "editor/hands/tool.h"
#include "editor/tools/split/drawn_cut.h"

namespace trivar {

// The cuts of an object and one more; what it has keeps how its pieces are closed.
CutThrough with_cut(const Session& session, Id object, PlainCut cut, const Cutting& settings);

// A CutGesture is a line or a stroke while the hand draws it over the active object.
class CutGesture {
public:
    bool going() const { return way_.has_value(); }
    // False, and nothing begins, where no object that can be cut is active.
    bool begin(Session& session, const ViewportInput& input, bool straight);
    // `one`: how it keeps and opens; `settings`: of an object that is not cut yet.
    void go_on(Session& session, const ViewportInput& input, const PlainCut& one,
               const Cutting& settings);
    void cancel(Session& session);
    void paint(const ui::Theme& theme, const ViewportInput& input) const;

private:
    std::optional<PlainCut> cut(const PlainCut& one, std::string* why) const;

    Id object_ = 0, under_ = 0;
    bool straight_ = true;
    std::optional<DrawnWay> way_;
};

} // namespace trivar
