// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// CountedNotices counts what a reader left out or changed: each kind once, with the number of
// times, in the order in which the kinds were first met.
class CountedNotices {
public:
    // The sentences for one time and for several, in which {0} is the number and {1} the first
    // place. Both are literals, which tell the kinds apart.
    void add(const char* once, const char* often, std::size_t times = 1,
             std::string_view first = {});
    // Adds a sentence once.
    void say(std::string sentence);
    std::vector<std::string> sentences(const std::string& file_name) const;

private:
    struct Kind {
        std::string_view once, often;
        std::size_t times;
        std::string first;
    };
    std::vector<Kind> kinds_;
};

} // namespace trivar
