// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/passes/targets.h"
#include "gpu/passes/tools.h"

namespace trivar::gpu {

// Lines over the finished picture: first, thin and dashed, where something hides them, then whole.
class LinePass {
public:
    LinePass();
    void draw(Tools& tools, const Targets& targets, const Frame& frame,
              const std::vector<Line>& lines, const glm::dvec3& origin_world);

private:
    Buffer segments_;
    VertexArray vertices_;
};

// Round highlighted instances; that of a draft costs a third and is rougher.
void draw_outline(Tools& tools, const Targets& targets, const Frame& frame, const Scene& scene,
                  const Outline& outline, bool draft);

} // namespace trivar::gpu
