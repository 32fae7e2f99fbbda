// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/editor/rig.h"
#include "tests/fuzz/hands/gesture.h"

#include <filesystem>

namespace trivar::testing {

// A Hand makes gestures in a window without a screen, by the events of a mouse and a keyboard.
class Hand {
public:
    // The editor opens the scene; files are named and saved in the folder that it lies in.
    explicit Hand(const std::filesystem::path& scene);

    // Throws Broken where the window does not come to rest in time.
    void make(const Gesture& gesture);
    void settle(); // frames until nothing works in the background any more
    Editor& editor() { return rig_->editor; }
    // The longest frame since the last call, seconds of processor time of the frame thread.
    double longest_frame_s() { return std::exchange(longest_frame_s_, 0.0); }

private:
    void frame();
    std::string going_on();
    void close_dialogs();
    void drain(); // frames until all events are taken
    void push(ui::Event event) { rig_->screen.input().push(std::move(event)); }
    void strike(const ui::Chord& chord);
    void strike(const std::string& key, int times = 1); // nothing where it is no key's name
    void type(const std::string& text);
    void hold(const std::vector<std::string>& keys, bool down);
    void stroke(const Gesture& gesture);
    void click(const Gesture& gesture);
    void choose(const Gesture& gesture);
    void come_between(const std::string& what);
    void lose_focus();
    void resize(glm::ivec2 size_px);
    void wait_for_background(double at_most_s);
    ui::Rect place(const Gesture& gesture) const;
    ui::Rect place_of_object(int number) const;
    glm::vec2 at(const Gesture& gesture, std::size_t point) const;

    std::filesystem::path folder_;
    std::unique_ptr<Rig> rig_;
    glm::vec2 mouse_{0};
    bool patient_ = true;
    double longest_frame_s_ = 0;
};

} // namespace trivar::testing
