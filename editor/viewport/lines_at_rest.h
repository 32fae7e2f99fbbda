// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/jobs/worker.h"
#include "editor/picture/picture_lines.h"

#include <optional>
#include <string>
#include <vector>

namespace trivar {

// A LinesAtRest draws the lines of a scene as files have them while the view rests, on a thread of
// its own: with their proof, hidden by other objects, where bodies meet, and of tiles. Until they
// are there, and while anything moves, quick lines are seen. A scene whose quick lines are all that
// it has asks for nothing.
class LinesAtRest {
public:
    // A Seen is what the window shows.
    struct Seen {
        const Evaluation& evaluated;
        const Document& document;
        const Camera& camera;
        const std::vector<Id>& hidden_here; // ascending
    };
    // Takes in what is finished, drops what nobody sees any more, and begins what is wanted once
    // that has rested a moment; once per frame. `into` draws the lines.
    void follow(const Seen& seen, bool moving, double time_s, PictureLines& into);

    long number() const { return number_; } // counts up with each change of the lines
    bool busy() const { return work_.busy(); }
    bool up_to_date() const { return wanted_.objects.empty() || (asked_ && !busy()); }
    std::optional<double> again_in_s() const; // when it wants to be asked again
    // Returns what is said of them above the picture: "Drawing lines", or how far certified ones
    // are proven, "Lines certified to 1/8 voxel, 12 boxes open", with loose ends if there are any,
    // and "before their share is taken" where only that is seen; then what is not drawn. Empty:
    // nothing.
    std::string words() const;

private:
    LineScene wanted_;                  // without objects: nothing is
    bool asked_ = false, done_ = false; // for its lines; they are there
    double moved_s_ = 0, now_s_ = 0;
    Ref<SceneLines> lines_;
    std::shared_ptr<LineDrawer> drawer_ = std::make_shared<LineDrawer>(); // of that thread
    long number_ = 0;
    Worker work_;
};

} // namespace trivar
