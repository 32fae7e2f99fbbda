// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// What a reader left out or took otherwise than the file has it: each kind is said once, with how
// often it was met, in the order in which the kinds were met first.
class CountedNotices {
public:
    // The sentence for once and that for more often, in which {0} is the number and {1} what the
    // kind was first met at. Both are literals, which tell the kinds apart.
    void add(const char* once, const char* often, std::size_t times = 1,
             std::string_view first = {});
    // A sentence that is there once.
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
