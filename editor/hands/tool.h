// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/keys.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace trivar {

class Session;
class PartsTool;
class ModelTool;
struct ViewportInput;
struct Helpers;
enum class MotionKind;
namespace ui {
struct Theme;
}

// One hint of the status line: "left", "middle", "right", "wheel" are drawn as mice, anything else
// as a key.
struct Hint {
    std::vector<std::string> inputs; // "left", "Ctrl"; "@Move": the key of the action of that name
    std::string verb;
};

// ToolFacts are what is the same for a tool at any time.
struct ToolFacts {
    std::string name = {};
    const char* icon = "";
    std::string help = {};            // one sentence
    std::string page = {};            // of the manual
    std::vector<ui::Chord> keys = {}; // the first is shown
};

// A ToolState says how the window meets a tool in a frame.
struct ToolState {
    bool busy = false;                 // a gesture is going on
    bool waits = false;                // for what it is to work on
    bool crosshair = false;            // in place of the arrow
    bool takes_wheel = false;          // it does not zoom then
    bool shows_volume_at_work = false; // of the selected placement; at rest it is always shown
    // Another number (0 .. 65535) wherever its helpers are others without a gesture: by what is
    // chosen in its bar, or in the picture.
    int mode = 0;
};

// A way of working in the viewport. A gesture shows its result as a proposal, commits at most once
// and leaves no trace when it is cancelled. A tool is one file in editor/tools and one line in
// all_tools().
class Tool {
public:
    explicit Tool(ToolFacts facts) : facts_(std::move(facts)) {}
    virtual ~Tool() = default;
    const ToolFacts& facts() const { return facts_; }
    const std::string& name() const { return facts_.name; }
    virtual ToolState state() const { return {}; }
    // Its key lets the tool at work move so what that has chosen, where it has chosen something.
    virtual std::optional<MotionKind> motion() const { return {}; }
    bool busy() const { return state().busy; }

    virtual void begin(Session&) {} // it was chosen by its key
    virtual void use(Session& session, const ViewportInput& input) = 0;
    virtual void take_keys(Session&) {} // while busy
    // Whether the key was meant for a gesture that could not begin: then nobody else has it.
    virtual bool awaits(const ui::Chord&) const { return false; }
    // Its brush or ball becomes so much larger; false where it has none.
    virtual bool resize(Session&, double factor) { return (void)factor, false; }
    virtual void cancel(Session&) {} // the gesture

    // Draws lines in the scene, a picture over it, and its settings in the options bar.
    virtual Helpers helpers(const Session&, const ui::Theme&) const;
    virtual void overlay(const Session&, const ui::Theme&, const ViewportInput&) const {}
    virtual void options(Session&, const ui::Theme&, float width) { (void)width; }
    virtual std::vector<Hint> hints(const Session& session) const = 0;

    // The tool as one that works on parts of an object, and as one that works with models that need
    // not be in the scene; null: it is none.
    virtual PartsTool* parts() { return nullptr; }
    virtual ModelTool* models() { return nullptr; }

private:
    ToolFacts facts_;
};

} // namespace trivar
