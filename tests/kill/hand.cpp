// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kill/hand.h"

#include <chrono>
#include <initializer_list>
#include <thread>

namespace trivar::testing {

void Dice::pause(unsigned most_us)
{
    std::this_thread::sleep_for(std::chrono::microseconds(below(most_us)));
}

void Hand::make_step(bool patiently)
{
    const auto strike_all = [&](std::initializer_list<Stroke> strokes) {
        for (const Stroke& stroke : strokes) {
            strike(stroke);
            if (patiently) window_.wait_for_frames(2);
        }
    };
    switch (dice_.below(8)) {
    case 0: return strike_all({{.key = "z", .ctrl = true}}); // undo
    case 1: return strike_all({{.key = "y", .ctrl = true}}); // redo
    case 2: return strike_all({{.key = "d", .ctrl = true}}); // duplicate
    case 3:
    case 4: return strike_all({{"a"}, {"g"}, {"1"}, {"Return"}}); // all moved by a metre
    case 5:
    case 6:
        strike({.key = "a", .shift = true});
        window_.wait_for_frames(3);                    // the menu opens
        return strike_all({{"b"}});                    // a box
    default: return strike_all({{"a"}, {"h"}, {"h"}}); // all hidden and shown
    }
}

void Hand::hide_and_show(unsigned times)
{
    constexpr unsigned most_us = 8'000;
    strike({"a"});
    for (; times > 0; --times) {
        strike({"h"});
        dice_.pause(most_us);
    }
}

void Hand::save_copy()
{
    strike({.key = "s", .ctrl = true, .alt = true});
}

void Hand::give_name()
{
    strike({.key = "s", .ctrl = true, .shift = true});
    window_.wait_for_frames(4); // the dialog opens
    strike({"Return"});
}

} // namespace trivar::testing
