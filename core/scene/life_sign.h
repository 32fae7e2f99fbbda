// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/locked_file.h"

#include <optional>
#include <string>

namespace trivar {

inline constexpr const char* life_sign_name = "life-sign-"; // of such files; a digest follows it
inline constexpr const char* reading_sign = " is read";     // after a path: not open yet

// A LifeSign tells the next program how this one ended. It is a small file in a folder, locked
// while the program has a scene open, that says on which state of the scene the program is at work.
// Who ends well or leaves the scene removes it. So a scene that ends every program that opens it is
// known by the signs that those left, and loses its last steps until it can be opened.
class LifeSign {
public:
    // Leaves a sign of the scene in a file, which has so many lines. There is none without a folder
    // that can be written to, or where a living program has such a sign: nothing is known then.
    LifeSign(const std::string& folder, std::string scene, std::size_t lines, bool at_work = false);
    ~LifeSign();
    LifeSign(const LifeSign&) = delete;
    LifeSign& operator=(const LifeSign&) = delete;

    const std::string& scene() const { return scene_; }
    // Returns the number of steps to leave out: none until two programs ended at work on its
    // present state, then 1, and with each program that ends at work on the rest 2, 4, 8 more.
    std::size_t steps_too_many() const;
    void take_back(std::size_t lines); // they were undone: now the scene has so many lines

    // Says how far the scene is and whether the program is at work on it, which a program that is
    // killed while it waits for the user is not. Another number of lines is another state.
    void follow(std::size_t lines, bool at_work);

private:
    static constexpr int deadly = 2; // programs in a row that ended at work on one state
    struct State {
        std::size_t lines = 0;
        bool at_work = false;
        int deaths = 0; // of programs at work on it
        int rounds = 0; // in which steps were taken back
        bool operator==(const State&) const = default;
    };
    static std::optional<State> read(const std::string& text);
    void write(const State& state);
    std::string scene_, path_;
    std::optional<LockedFile> file_; // none: there is no sign
    State state_;
};

} // namespace trivar
