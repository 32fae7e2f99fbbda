// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/passes/segments.h"
#include "gpu/passes/targets.h"
#include "gpu/passes/tools.h"

namespace trivar::gpu {

// A LinePass draws the lines of a picture.
class LinePass {
public:
    LinePass();
    void load(const std::vector<Segment>& segments);
    bool any() const { return count_ > 0; }
    // Draws helpers over the finished picture: first their hidden parts, then the rest.
    void draw_over(Tools& tools, const Targets& targets) const;
    // Draws lines as part of a sample. They hide later layers, and can be picked.
    void draw_within(Tools& tools, const Targets& targets) const;
    // Draws lines into the bound mask, with one value everywhere.
    void draw_mask(Tools& tools, float value) const;

private:
    enum class Parts { hidden, seen, all };
    void draw(const Program& program, Parts parts) const;
    Buffer segments_;
    VertexArray vertices_;
    int count_ = 0;
};

ProgramName line_program(const char* define); // of line.frag; empty: none

} // namespace trivar::gpu
