// SPDX-License-Identifier: GPL-3.0-or-later
// Kills the editor's window at moments of chance and opens its scene again.
//   manual_kills [ROUNDS [SEED]]
#include "tests/kill/killed_scene.h"

#include <cstdlib>
#include <fmt/format.h>

int main(int count, char** arguments)
{
    using namespace trivar::testing;
    const auto screen = Screen::open();
    if (!screen) {
        fmt::print(stderr, "There is no Xvfb to show the window.\n");
        return 1;
    }
    const int rounds = count > 1 ? std::atoi(arguments[1]) : 300;
    const unsigned seed = count > 2 ? static_cast<unsigned>(std::atoi(arguments[2])) : 1;
    const KillFindings found = kill_windows(*screen, rounds, seed);
    for (const std::string& fault : found.faults) fmt::print("{}\n", fault);
    fmt::print(
        "{} rounds, {} with a name, {} reopened while the killed program was going; {} lines "
        "of their logs were shown: {} logs torn, {} lost, {} not opened\n",
        found.rounds, found.named, found.reopened_at_once, found.lines, found.torn, found.lost,
        found.unopened);
    return found.faults.empty() ? 0 : 1;
}
