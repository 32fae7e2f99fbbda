// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/objects/primitives.h"
#include "core/commands/volumes/lattice.h"
#include "tests/editor/panels/number_rows.h"

namespace trivar::testing {

// A ball in a lattice of 4 x 4 x 4 points (object 2), and its inspector.
struct LatticeRig : Rig {
    explicit LatticeRig(int height_px) : Rig({1100, height_px})
    {
        EXPECT_TRUE(editor.session.run(AddSphere{.shape = {.radius = 0.4}}));
        EXPECT_TRUE(editor.session.run(AddLattice{.objects = {1}}));
        editor.session.selected = 2;
        editor.preferences.timeline_open = false;
        wait();
    }
    const Object& lattice() const { return object(editor.session.document(), 2); }
    // Whether a number of that name is under the mouse.
    bool is_over(const std::string& name) const { return is_over_number(*this, name); }
};

} // namespace trivar::testing
