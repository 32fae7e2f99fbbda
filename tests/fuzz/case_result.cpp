// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/case_result.h"

#include "core/base/text.h"

#include <fmt/format.h>
#include <sstream>

namespace trivar::testing {

std::string begin_line(int number)
{
    return fmt::format("{}\n", number);
}

std::string end_line(const CaseResult& result)
{
    return fmt::format("{} {} {} {} {}\n", result.number, static_cast<int>(result.end),
                       result.memory_bytes, result.processor_s, printable(result.what));
}

CaseLine case_line(const std::string& line)
{
    CaseLine out;
    int end = 0;
    std::istringstream words(line);
    words >> out.result.number;
    words >> end >> out.result.memory_bytes >> out.result.processor_s;
    out.ended = !words.fail();
    out.result.end = static_cast<CaseEnd>(end);
    std::getline(words >> std::ws, out.result.what);
    return out;
}

} // namespace trivar::testing
