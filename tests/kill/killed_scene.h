// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/kill/hand.h"
#include "tests/support/fixtures.h"

#include <memory>
#include <string>
#include <vector>

namespace trivar::testing {

// KillFindings are the results of rounds in which a window was killed.
struct KillFindings {
    int rounds = 0, named = 0, reopened_at_once = 0;
    std::size_t lines = 0; // of scenes' files, that came to be shown: steps, undos, redos
    int torn = 0, lost = 0, unopened = 0;
    std::vector<std::string> faults; // a sentence each
    void fault(int& kind, const std::string& sentence);
};

// A scene over which one window after the other is killed, each at a moment of chance.
class KilledScene {
public:
    KilledScene(Screen& screen, Dice& dice, bool named);
    // Opens the scene in a window, makes steps by keys, kills it; and looks at what it left, or the
    // next round does, which then opens the scene while the killed program is still going.
    void round(KillFindings& found);
    void settle(KillFindings& found); // looks at what the last of them left

private:
    bool is_here(const Shown& shown) const { return shown.path == path_; }
    void work(WatchedProgram& window);
    void look_at_first_frame(KillFindings& found) const;
    void remember(KillFindings& found);
    void look_at_file(KillFindings& found);

    Screen& screen_;
    Dice& dice_;
    TemporaryFolder home_;
    std::string path_; // empty: it has no name
    // The file of a scene that gets its name from the hand.
    std::string given_ = home_.file("untitled.trivar");
    Shown last_; // that was shown of it by any of its windows
    std::unique_ptr<WatchedProgram> killed_;
    bool naming_ = false; // the hand was giving a name when it was killed
    std::string round_;   // in words, for a fault's sentence
};

// So many rounds over scenes with a name and without; four a scene, or till a fault.
KillFindings kill_windows(Screen& screen, int rounds, unsigned seed);

} // namespace trivar::testing
