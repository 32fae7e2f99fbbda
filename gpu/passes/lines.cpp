// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/passes/lines.h"

#include <algorithm>
#include <cstddef>
#include <epoxy/gl.h>

namespace trivar::gpu {

ProgramName line_program(std::vector<std::string> defines)
{
    return {"line", "line", std::move(defines)};
}

LinePass::LinePass()
{
    segments_.write({});
    const int stride = sizeof(Segment);
    vertices_.attribute(0, segments_, 3, stride, offsetof(Segment, before), 1);
    vertices_.attribute(1, segments_, 3, stride, offsetof(Segment, from), 1);
    vertices_.attribute(2, segments_, 3, stride, offsetof(Segment, to), 1);
    vertices_.attribute(3, segments_, 3, stride, offsetof(Segment, after), 1);
    vertices_.attribute(4, segments_, 4, stride, offsetof(Segment, color_from), 1);
    vertices_.attribute(5, segments_, 4, stride, offsetof(Segment, color_to), 1);
    vertices_.attribute(6, segments_, 4, stride, offsetof(Segment, along), 1);
    vertices_.attribute(7, segments_, 4, stride, offsetof(Segment, width_taper), 1);
    vertices_.attribute(9, segments_, 4, stride, offsetof(Segment, width_shares), 1);
    vertices_.integers(8, segments_, 2, stride, offsetof(Segment, id), 1);
}

void LinePass::load(const std::vector<Segment>& segments)
{
    count_ = static_cast<int>(segments.size());
    any_before_own_ =
        std::ranges::any_of(segments, [](const Segment& s) { return s.own_reach > 0; });
    if (count_ > 0) segments_.write(std::as_bytes(std::span(segments)));
}

void LinePass::draw(const Program& program, Parts parts) const
{
    program.set("parts", static_cast<int>(parts));
    vertices_.bind();
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count_);
}

void LinePass::draw_over(Tools& tools, const Targets& targets) const
{
    targets.to_encoded.bind();
    const Program& program = tools.use(line_program({"HELPERS"}));
    set_state({.depth = DepthTest::greater, .blend = true});
    draw(program, Parts::hidden);
    set_state({.depth = DepthTest::less_equal, .blend = true});
    draw(program, Parts::seen);
}

void LinePass::draw_within(Tools& tools, const Targets& targets) const
{
    targets.to_color.bind();
    set_state({.depth = DepthTest::greater, .blend = true});
    draw(tools.use(line_program({})), Parts::hidden);
    // Their depth comes before their colours: of two that cross the nearer one shows. That of ink
    // is only where it covers all of a pixel, so that no light rim parts lines that touch.
    const auto draw_ids = [&](std::vector<std::string> defines) {
        targets.to_ids.bind();
        set_state({.depth = DepthTest::less, .write_depth = true});
        draw(tools.use(line_program(std::move(defines))), Parts::seen);
    };
    draw_ids({"IDS", "WHOLE"});
    targets.to_color.bind();
    set_state({.depth = DepthTest::less_equal, .blend = true});
    draw(tools.use(line_program({})), Parts::seen);
    draw_ids({"IDS"});
    if (!any_before_own_) return;
    targets.to_color.bind();
    set_state({.depth = DepthTest::greater, .blend = true});
    draw_before_own(tools, targets, "");
}

void LinePass::draw_before_own(Tools& tools, const Targets& targets, const char* define) const
{
    std::vector<std::string> defines{"BEFORE_OWN"};
    if (*define) defines.emplace_back(define);
    targets.ids_depths.bind(3);
    draw(tools.use(line_program(defines)), Parts::before_own);
}

void LinePass::draw_mask(Tools& tools, float value) const
{
    const Program& program = tools.use(line_program({"MASK"}));
    program.set("value", value);
    draw(program, Parts::seen);
}

void LinePass::draw_cover(Tools& tools, const Targets& targets) const
{
    const auto keep_most = [](DepthTest depth) {
        set_state({.depth = depth, .blend = true});
        glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_FALSE);
    };
    glBlendEquation(GL_MAX);
    keep_most(DepthTest::less_equal);
    draw(tools.use(line_program({"COVER"})), Parts::seen);
    if (any_before_own_) {
        keep_most(DepthTest::greater);
        draw_before_own(tools, targets, "COVER");
    }
    glBlendEquation(GL_FUNC_ADD);
}

} // namespace trivar::gpu
