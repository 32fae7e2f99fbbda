// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/command.h"
#include "core/commands/objects/group.h"

#include <set>
#include <string>
#include <vector>

namespace trivar {

// An OutlineRow is a row of the scene's outline; groups stand above their contents.
struct OutlineRow {
    Id id = 0;
    int depth = 0;
    bool group = false, open = false;
    bool found = true; // false: only there because something in it matches the filter
};

// The rows of a document in their order, without the contents of closed groups. The filter's
// letters are found in names in order, "type:model" in types; the groups round a match stay, and
// are open.
std::vector<OutlineRow> outline(const Document& document, const std::string& filter,
                                const std::set<Id>& closed);

// A RowDrop says where dragged rows would go.
struct RowDrop {
    Reorder command;
    int line = -1;       // it would be drawn above this row, or below the last
    int onto = -1;       // or into this one
    std::string refused; // why it cannot be
};
// `at` counts rows from the top: 2.5 is the middle of the third. Rows that would not move give a
// command without objects.
RowDrop row_drop(const Document& document, const std::vector<OutlineRow>& rows,
                 const std::vector<Id>& dragged, double at);

// OutlinerState is the state of the outliner between two frames.
struct OutlinerState {
    std::string filter;
    bool focus_filter = false; // the keyboard goes there in the next frame
    std::set<Id> closed;       // groups
    Id renaming = 0;
    std::string new_name;    // of it, as typed so far
    Id shown = 0;            // the active object that was scrolled to
    std::vector<Id> dragged; // rows in the hand
    bool scrolling = false;  // by itself, as the hand is near an edge of the list
    // A hand that goes down a column gives all rows the state that it gave the first one.
    enum class Column { none, eye, lock } painting = Column::none;
    bool paint = false; // hidden, or locked
    std::vector<Id> painted;
};

std::string type_of(const Object& object);
const char* icon_of(const Object& object);

} // namespace trivar
