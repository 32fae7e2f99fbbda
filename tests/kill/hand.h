// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/kill/screen.h"
#include "tests/kill/watched_program.h"

#include <random>

namespace trivar::testing {

// Chance that is the same on every machine.
class Dice {
public:
    explicit Dice(unsigned seed) : numbers_(seed) {}
    unsigned below(unsigned count) { return static_cast<unsigned>(numbers_() % count); }
    void pause(unsigned most_us); // some of that

private:
    std::mt19937 numbers_;
};

// A hand that works in a window by keys, patiently or faster than it draws.
class Hand {
public:
    Hand(Screen& screen, WatchedProgram& window, Dice& dice)
        : screen_(screen),
          window_(window),
          dice_(dice)
    {
    }
    void make_step(bool patiently);
    void hide_and_show(unsigned times); // as fast as one can
    void save_copy();
    void give_name(); // that is offered, untitled.trivar

private:
    void strike(const Stroke& stroke) { screen_.strike(window_.id(), stroke); }
    Screen& screen_;
    WatchedProgram& window_;
    Dice& dice_;
};

} // namespace trivar::testing
