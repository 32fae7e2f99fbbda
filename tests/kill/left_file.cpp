// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kill/left_file.h"

#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/scene/kept_scenes.h"
#include "core/scene/log.h"

namespace trivar::testing {
namespace {

History whole_history(const std::string& text)
{
    const Log log = read_log(text, "the file");
    if (!log.notice.empty()) throw Rejected(log.notice);
    return replay(log);
}

// Up to and with the last of them; empty: there are fewer.
std::string first_lines(const std::string& text, std::size_t count)
{
    std::size_t end = 0;
    for (; count > 0; --count) {
        end = text.find('\n', end);
        if (end == text.npos) return {};
        ++end;
    }
    return text.substr(0, end);
}

} // namespace

bool holds(const std::string& text, const Shown& shown)
{
    static_cast<void>(whole_history(text)); // it can be read
    const std::string then = first_lines(text, shown.lines);
    if (then.empty()) return shown.lines == 0;
    const History history = whole_history(then);
    return history.position() == shown.steps && history.steps().size() == shown.of;
}

std::string latest_kept(const std::string& folder)
{
    for (const std::string& path : paths_of(scenes_in(folder, kept_name)))
        if (!whole_history(read_text_file(path)).steps().empty()) return path;
    return {};
}

} // namespace trivar::testing
