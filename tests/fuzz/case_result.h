// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace trivar::testing {

struct CaseLimits {
    double processor_s = 10, wall_s = 60; // a busy machine takes long over what is soon done
    // The larger of the two counts. Under sanitizers memory is not judged.
    std::size_t memory_bytes = std::size_t{512} << 20, memory_by_file_bytes = 64;
};

struct CampaignOptions {
    std::uint64_t seed = 1;
    int first = 0, count = 100; // cases
    std::string keep;           // a folder for the files of cases that fail; empty: none are kept
    CaseLimits limits;
};

// How a case came to its end. Those from `broken` on are failures.
enum class CaseEnd { accepted, refused, broken, too_large, crash, hang };

struct CaseResult {
    int number = 0;
    CaseEnd end = CaseEnd::accepted;
    std::size_t memory_bytes = 0; // at most; 0: it cannot be told
    double processor_s = 0;       // of all threads
    std::string what = {};        // a sentence where it was not accepted
};
inline bool failed(const CaseResult& result)
{
    return result.end >= CaseEnd::broken;
}

// The lines that the process that runs the cases writes to the one that watches it.
std::string begin_line(int number);
std::string end_line(const CaseResult& result);
struct CaseLine {
    bool ended = false; // false: the case of that number begins
    CaseResult result;
};
CaseLine case_line(const std::string& line); // without its line break

} // namespace trivar::testing
