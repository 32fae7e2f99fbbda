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
    // Draws into the bound mask's second channel how much lines cover of each pixel.
    void draw_cover(Tools& tools, const Targets& targets) const;

private:
    enum class Parts { seen, hidden, before_own }; // line.vert
    void draw(const Program& program, Parts parts) const;
    // Draws the parts that lie behind the surface of their own object, which does not hide them.
    void draw_before_own(Tools& tools, const Targets& targets, const char* define) const;
    Buffer segments_;
    VertexArray vertices_;
    int count_ = 0;
    bool any_before_own_ = false;
};

ProgramName line_program(std::vector<std::string> defines); // of line.frag

} // namespace trivar::gpu
