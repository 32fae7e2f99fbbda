// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"

#include <functional>
#include <string>
#include <vector>

namespace trivar {

struct Editor;

// LeftBehind lists the effects of a deletion on the objects that are left.
struct LeftBehind {
    std::vector<std::string> lines;   // sentences for the user, at most one per outcome
    std::vector<Id> dependents, gone; // objects that used deleted ones; the deleted ones they used
};

// Finds the effects of a deletion on objects that used the deleted ones: by lying on them, as
// tiles, as obstacles, blades or curves. `lies_on` says of a stroke that is not attached whether it
// lies on an object.
LeftBehind left_behind(const Document& before, const Document& after,
                       const std::function<bool(Id laid, Id on)>& lies_on);

// Deletes the objects in one step and says what that did to others, with buttons that take it back
// and that bind them to another object.
void delete_objects(Editor& editor, const std::vector<Id>& ids);

// BindChoice is what waits for the choice of another object: the menu opens when it is asked for.
struct BindChoice {
    std::vector<Id> dependents, gone;
    std::size_t step = 0; // number of steps in force after the deletion
    bool asked = false;
};
// The objects that all of them can be bound to.
std::vector<Id> can_be_bound_to(const Editor& editor, const std::vector<Id>& dependents);
// Undoes the deletion, binds the users of the deleted objects to another one, and deletes again. If
// other steps were made since, it binds the objects whose host or base is missing now.
void bind_to(Editor& editor, const BindChoice& choice, Id to);

} // namespace trivar
