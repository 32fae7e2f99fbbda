// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace trivar::testing {

// Shown is the most that a frame of the window can show, as the program says before it shows it.
struct Shown {
    std::size_t steps = 0, of = 0; // in force, and with those that were undone
    std::size_t lines = 0;         // of the scene's file
    std::string path;              // of that; empty: without a name
};

// The built program with its window on a screen, at home in a folder of its own.
class WatchedProgram {
public:
    WatchedProgram(const std::vector<std::string>& files, const std::string& home,
                   const std::string& screen);
    ~WatchedProgram(); // kills it
    WatchedProgram(const WatchedProgram&) = delete;
    WatchedProgram& operator=(const WatchedProgram&) = delete;

    pid_t id() const { return id_; }
    // Waits for a frame like that, which may have come already; false where the program ended or
    // two minutes passed.
    bool wait_for(const std::function<bool(const Shown&)>& is_so);
    // Waits for so many more frames, but no longer than a moment: none may be due.
    void wait_for_frames(int count);
    void kill();           // SIGKILL; it may take a moment to go
    void wait_till_gone(); // and what it had said by then is known
    const std::vector<Shown>& shown() const { return shown_; } // frame by frame

private:
    bool listen(int patience_ms); // whether something was heard
    void take_lines();
    pid_t id_ = -1;
    int told_ = -1;
    bool gone_ = false;
    std::string half_; // of a line
    std::vector<Shown> shown_;
};

} // namespace trivar::testing
