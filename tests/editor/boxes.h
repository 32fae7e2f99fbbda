// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/command.h"
#include "core/commands/objects/primitives.h"
#include "tests/editor/rig.h"

namespace trivar::testing {

// Two boxes side by side, the left one selected, seen from the front.
struct Boxes : Rig {
    explicit Boxes(const std::string& unnamed_folder = {}) : Rig({720, 520}, {}, unnamed_folder)
    {
        for (const double x : {-1.5, 1.5}) {
            AddBox box;
            box.transform.translation = {x, 0, 0};
            editor.session.run(box);
        }
        editor.session.selected = 1;
        editor.session.view.camera.eye = {0, -12, 3};
        editor.session.view.camera.target = {0, 0, 0};
        wait();
        move(layout().view.center() + glm::vec2(60, 90));
    }
    Transform of(Id id) const { return object(editor.session.document(), id).transform; }
    void let_go()
    {
        screen.input().push(ui::press(ui::Button::left, false));
        wait();
    }
    glm::vec2 away() const { return layout().view.center() + glm::vec2(60, 90); }
};

} // namespace trivar::testing
