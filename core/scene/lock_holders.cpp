// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/lock_holders.h"

#include <fmt/format.h>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace trivar {
namespace {

// Lists the processes that hold a lock on a file, from lines like "7: FLOCK ADVISORY WRITE 1234
// fe:00:131 0 EOF": the process and, after the device, the number of the file. The device is
// ignored: some file systems show another one there than in `stat`, and an extra holder only costs
// one more check.
std::vector<long> holders_of(ino_t number)
{
    std::vector<long> holders;
    std::ifstream locks("/proc/locks");
    for (std::string line; std::getline(locks, line);) {
        std::istringstream words(line);
        std::string at, kind, manner, access, file;
        long process = 0;
        if (!(words >> at >> kind >> manner >> access >> process >> file) || kind != "FLOCK")
            continue;
        if (file.substr(file.rfind(':') + 1) == std::to_string(number)) holders.push_back(process);
    }
    return holders;
}

// Parses a hexadecimal set of signals after the name in a line of /proc/PROCESS/status.
unsigned long long signals_of(const std::string& line)
{
    unsigned long long set = 0;
    std::istringstream(line.substr(line.find(':') + 1)) >> std::hex >> set;
    return set;
}

bool was_killed(long process)
{
    constexpr unsigned long long kill = 1ULL << 8; // signal 9
    std::ifstream status(fmt::format("/proc/{}/status", process));
    for (std::string line; std::getline(status, line);)
        if ((line.starts_with("SigPnd:") || line.starts_with("ShdPnd:")) &&
            (signals_of(line) & kill) != 0)
            return true;
    return false;
}

bool is_exiting(long process)
{
    constexpr unsigned exiting = 0x4, signaled = 0x400; // PF_EXITING, PF_SIGNALED of the kernel
    std::ifstream stat(fmt::format("/proc/{}/stat", process));
    std::string line;
    std::getline(stat, line);
    // The line is "1234 (name) S parent group session terminal its_group flags"; a name may contain
    // any character.
    std::istringstream words(line.substr(line.rfind(')') + 1));
    std::string state;
    long number = 0;
    unsigned flags = 0;
    words >> state;
    for (int i = 0; i < 5; ++i) words >> number;
    words >> flags;
    return (flags & (exiting | signaled)) != 0;
}

} // namespace

bool held_by_the_dying(const struct stat& file)
{
    for (const long process : holders_of(file.st_ino))
        if (was_killed(process) || is_exiting(process)) return true;
    return false;
}

} // namespace trivar
