// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/tiles/tile_files.h"
#include "editor/hands/motion.h"
#include "editor/session/session.h"
#include "gpu/picture.h"
#include "ui/frame.h"
#include "ui/keys.h"
#include "ui/paint.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace trivar {

// One hint of the status line: "left", "middle", "right", "wheel" are drawn as mice, anything else
// as a key.
struct Hint {
    std::vector<std::string> inputs; // "left", "Ctrl"; "@Move": the key of the action of that name
    std::string verb;
};

// A hand that clicks moves the mouse as far as this.
inline constexpr double click_slip_px = 3;

// A notch of the wheel makes a ball or a brush so much larger.
inline constexpr double radius_step = 1.1;

// What a tool sees of the viewport in one frame.
struct ViewportInput {
    ui::Rect rect;         // of the picture in the window
    double scale = 1;      // of the interface
    glm::dvec2 mouse{0};   // in the picture, pixels
    bool hovered = false;  // the mouse is over the picture and nothing lies above it
    bool pressed = false;  // the left button went down over the picture in this frame
    bool down = false;     // it went down over the picture and still is
    bool released = false; // it was let go in this frame
    bool double_clicked = false;
    double wheel = 0; // notches since the last frame, away from the hand, for who takes_wheel()
    std::vector<StrokeSample> moves; // since the last frame, while down
    Id under = 0;                    // the object under the mouse, where `pressed`
    // What is seen there, pixels of the picture, locked or not; 0: nothing.
    std::function<Id(glm::dvec2)> seen_at;
    // What is seen in a rectangle of the picture, pixels, and not locked.
    std::function<std::vector<Id>(glm::dvec2 lo, glm::dvec2 hi)> seen_in;
};

// How a model is laid best as a tile.
struct TileFit {
    bool strand = false; // end to end
    double overlap = 0;  // in shares of its cell
};

enum class PartChoice { all, none, others, more, same };

// A way of working in the viewport. A gesture shows its result as a proposal, commits at most once
// and leaves no trace when it is cancelled. A tool is one file in this folder and one line in
// all_tools().
class Tool {
public:
    virtual ~Tool() = default;
    virtual std::string name() const = 0;
    virtual const char* icon() const = 0;
    virtual std::string help() const = 0;            // one sentence
    virtual std::string page() const = 0;            // of the manual
    virtual std::vector<ui::Chord> keys() const = 0; // the first is shown
    virtual bool crosshair() const { return false; }

    virtual void begin(Session& session) { (void)session; } // it was chosen by its key
    // An object was added to work on, whatever was chosen before.
    virtual void take_up(Session& session, Id object) { (void)session, (void)object; }
    // How it moves what is chosen: of the tool at work, where that grabs something, else what is
    // selected.
    virtual std::optional<MotionKind> motion() const { return {}; }
    // What it has chosen goes so with the mouse from now on; false where it has nothing to move.
    virtual bool grab(Session& session, MotionKind kind)
    {
        return (void)session, (void)kind, false;
    }
    // Names of the numbers of the selected object that say where the parts are that it has chosen;
    // empty: no step has moved just them. Nothing: it has chosen none, and the object is meant.
    virtual std::optional<std::vector<std::string>> numbers(const Session& session) const
    {
        return (void)session, std::nullopt;
    }
    // Chooses among the parts that it works on; false where it has none, and objects are meant.
    virtual bool choose_parts(Session& session, PartChoice choice)
    {
        return (void)session, (void)choice, false;
    }
    // Removes the parts that it has chosen; false where it has chosen none, and objects are meant.
    virtual bool remove_parts(Session& session) { return (void)session, false; }
    // Whether neighbours of what it moves go along; nothing where it has no such switch.
    virtual std::optional<bool> proportional() const { return {}; }
    virtual void set_proportional(bool on) { (void)on; }
    virtual void use(Session& session, const ViewportInput& input) = 0;
    virtual bool busy() const { return false; }                 // a gesture is going on
    virtual bool waits() const { return false; }                // for what it is to work on
    virtual bool shows_volume() const { return !busy(); }       // of the selected placement
    virtual bool takes_wheel() const { return false; }          // it does not zoom then
    virtual void take_keys(Session& session) { (void)session; } // while busy
    // Its brush or ball becomes so much larger; false where it has none.
    virtual bool resize(Session& session, double factor)
    {
        (void)session, (void)factor;
        return false;
    }
    // Whether the key was meant for a gesture that could not begin: then nobody else has it.
    virtual bool awaits(const ui::Chord&) const { return false; }
    // Of a tool that works with models that need not be in the scene: the files of those that it
    // works with, none where they are no files' or there are none; nothing: it is no such tool.
    virtual std::optional<std::vector<std::string>> chosen_models(const Session&) const
    {
        return {};
    }
    // `also`: besides those that are chosen already.
    virtual void choose_model(Session&, const std::string& file, bool also)
    {
        (void)file, (void)also;
    }
    // How the model that was chosen last is laid best.
    virtual void fit_model(const TileFit& fit) { (void)fit; }
    // The file of a model that a gesture waits for, once. Whoever reads it calls take_read().
    virtual std::optional<std::string> take_wanted_model() { return {}; }
    virtual void take_read(Session& session, const TileFile& model) { (void)session, (void)model; }
    virtual void cancel(Session& session) { (void)session; } // the gesture
    // Another number (0 .. 65535) wherever its lines and veils are others without a gesture: by
    // what is chosen in its bar, or in the picture.
    virtual int mode() const { return 0; }
    // Of the volume of the selected placement all that bends with what it has hold of.
    virtual std::vector<VolumePart> held_parts(const Session&) const { return {}; }

    // What it draws: in the scene, over the picture, and its settings in the options bar.
    virtual std::vector<gpu::Line> lines(const Session&, const ui::Theme&) const { return {}; }
    virtual std::vector<gpu::Translucent> veils(const Session&, const ui::Theme&) const
    {
        return {};
    }
    virtual void overlay(const Session&, const ui::Theme&, const ViewportInput&) const {}
    virtual void options(Session&, const ui::Theme&, float width) { (void)width; }
    virtual std::vector<Hint> hints(const Session& session) const = 0;
};

} // namespace trivar
