// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace trivar {

class Session;
struct VolumePart;
enum class MotionKind;

enum class PartChoice { all, none, others, more, same };

// A PartsTool is a tool that works on parts of the selected object, of which it has chosen some:
// points of a cage, tiles, incisions. A function returns false where objects are meant instead.
class PartsTool {
public:
    virtual ~PartsTool() = default;
    virtual bool choose(Session&, PartChoice) { return false; }
    // Moves its chosen parts with the mouse from now on; false if it has nothing to move.
    virtual bool grab(Session&, MotionKind) { return false; }
    virtual bool remove(Session&) { return false; }
    // Names of the numbers of the selected object that say where the chosen parts are; empty: no
    // step has moved just them. Nothing: it has chosen none, and the object is meant.
    virtual std::optional<std::vector<std::string>> numbers(const Session&) const { return {}; }
    // Whether neighbours of what it moves go along; null where it has no such switch.
    virtual bool* proportional() { return nullptr; }
    // Returns the parts of the volume of the selected placement that bend with what it holds.
    virtual std::vector<VolumePart> held(const Session&) const;
};

} // namespace trivar
