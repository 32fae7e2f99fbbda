// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/placement.h"
#include "tests/editor/rig.h"

namespace trivar::testing {

// The box laid on the wide plane, from the left to the right, and nothing but Select at work.
struct LaidRig : Rig {
    explicit LaidRig(glm::ivec2 size = {720, 520}, const std::string& unnamed_folder = {})
        : Rig(size, {}, unnamed_folder)
    {
        two_objects();
        key({'D'});
        draw(stroke());
        wait();
        key({'Q'});
        wait();
        EXPECT_TRUE(is_laid());
    }
    bool is_laid(Id id = 2) const
    {
        const auto found = editor.session.evaluated().objects.find(id);
        return found != editor.session.evaluated().objects.end() && found->second->placement;
    }
    const PlacementStep& step(Id id = 2) const
    {
        return *object(editor.session.document(), id).stroke;
    }
    const Placement& laid(Id id = 2) const
    {
        return *editor.session.evaluated().objects.at(id)->placement;
    }
    // The middle of its contact surface, in the world.
    glm::dvec3 middle(Id id = 2) const { return evaluate(laid(id).contact, {0.5, 0.5}).value; }
    glm::dvec3 ahead(Id id = 2) const
    {
        return glm::normalize(evaluate(laid(id).contact, {0.5, 0.5}, 1).u);
    }
};

} // namespace trivar::testing
