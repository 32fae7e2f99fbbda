// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/help/key_lines.h"

#include "editor/panels/panels.h"

namespace trivar {
namespace {

// Returns the hints of the tool at hand, as the status line shows them.
std::vector<KeyLine> lines_of_tool(const Editor& editor)
{
    const Tool& tool = *editor.tools[editor.tool];
    std::vector<KeyLine> lines{{tool.name(), ""}, {tool.facts().help, " "}};
    for (const Hint& hint : tool.hints(editor.session)) {
        std::string how;
        for (const std::string& input : inputs_now(editor, hint)) {
            const bool first = how.empty() || how.ends_with(' ');
            how += input == "/" ? " or " : (first ? "" : "+") + input;
        }
        if (!how.empty()) lines.push_back({hint.verb, how});
    }
    return lines;
}

} // namespace

std::vector<KeyLine> key_lines(const Editor& editor)
{
    std::vector<KeyLine> lines = lines_of_tool(editor);
    const std::vector<KeyLine> mouse{
        {"Mouse", ""},
        {"Use the tool", "left"},
        {"Orbit about the point under the pointer", "middle, or Alt+left"},
        {"Pan", "Shift+middle, or Alt+Shift+left"},
        {"Zoom towards the pointer", "wheel, or Ctrl+middle"},
        {"Cancel a gesture", "right, or Esc"},
        {"Type a number", "click it"},
        {"Drag finely", "hold Shift"},
        {"While moving, rotating or scaling", ""},
        {"Along one axis; again: the object's own", "X, Y, Z"},
        {"In the plane across it", "Shift+X, Shift+Y, Shift+Z"},
        {"An exact amount, then the next", "type it, Tab"},
        {"Snap", "hold Ctrl"},
        {"Done", "left, or Enter"},
        {"While moving or scaling what lies on a stroke", ""},
        {"Along the stroke, across it, off the surface", "X, Y, Z"},
        {"While a stroke is drawn", ""},
        {"Straight on from here", "hold Shift"},
        {"Close the ring near its start", "hold Ctrl"},
        {"Switch between moving the model and laying a copy", "hold Alt"},
        {"The width", "wheel, or type it"}};
    lines.insert(lines.end(), mouse.begin(), mouse.end());
    std::string menu;
    for (const Action& each : editor.actions) {
        if (each.keys.empty()) continue;
        if (each.menu != menu) lines.push_back({each.menu, ""});
        menu = each.menu;
        std::string keys;
        for (const ui::Chord& chord : each.keys)
            keys += (keys.empty() ? "" : ", ") + ui::text_of(chord);
        lines.push_back({each.name, keys});
    }
    return lines;
}

} // namespace trivar
