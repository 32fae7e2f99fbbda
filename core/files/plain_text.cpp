// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/plain_text.h"

#include "core/base/rejected.h"

#include <algorithm>

namespace trivar {
namespace {

constexpr std::string_view utf8_mark = "\xef\xbb\xbf";

// Finds a '\r' that is not followed by '\n', from `at` on.
std::size_t lone_return(std::string_view text, std::size_t at)
{
    while ((at = text.find('\r', at)) != text.npos && text.substr(at + 1, 1) == "\n") at += 2;
    return at;
}

// Says whether the first two characters have a zero byte each, before or after: UTF-16.
bool two_bytes_each(std::string_view bytes)
{
    if (bytes.size() < 4) return false;
    const auto shows = [](char c) { return c >= ' ' && c <= '~'; };
    return (shows(bytes[0]) && bytes[1] == 0 && shows(bytes[2]) && bytes[3] == 0) ||
           (bytes[0] == 0 && shows(bytes[1]) && bytes[2] == 0 && shows(bytes[3]));
}

} // namespace

void refuse_wide_text(std::string_view bytes, const std::string& name)
{
    const std::string_view wide_marks[] = {"\xff\xfe", "\xfe\xff", {"\0\0\xfe\xff", 4}};
    const bool marked =
        std::ranges::any_of(wide_marks, [&](auto mark) { return bytes.starts_with(mark); });
    if (marked || two_bytes_each(bytes))
        throw Rejected(name + ": its text is UTF-16 or UTF-32; save it as UTF-8");
}

std::string_view without_mark(std::string_view bytes)
{
    if (bytes.starts_with(utf8_mark)) bytes.remove_prefix(utf8_mark.size());
    return bytes;
}

PlainText::PlainText(std::string_view bytes, const std::string& name) : view_(without_mark(bytes))
{
    refuse_wide_text(bytes, name);
    std::size_t at = lone_return(view_, 0);
    if (at == view_.npos) return;
    for (copy(); at != view_.npos; at = lone_return(view_, at)) copy_[at] = '\n';
}

void PlainText::join_lines()
{
    if (view_.find("\\\n") == view_.npos && view_.find("\\\r\n") == view_.npos) return;
    copy();
    for (std::size_t i = 0; (i = copy_.find('\\', i)) != copy_.npos; ++i) {
        std::size_t end = i + 1;
        if (end < copy_.size() && copy_[end] == '\r') ++end;
        if (end >= copy_.size() || copy_[end] != '\n') continue;
        std::fill_n(copy_.begin() + static_cast<std::ptrdiff_t>(i), end + 1 - i, ' ');
        joined_.push_back(end);
    }
}

std::size_t PlainText::line_of(const char* at) const
{
    const auto offset = static_cast<std::size_t>(at - view_.data());
    const auto joined = std::ranges::lower_bound(joined_, offset) - joined_.begin();
    return static_cast<std::size_t>(1 + std::count(view_.data(), at, '\n') + joined);
}

void PlainText::copy()
{
    if (!copy_.empty()) return;
    copy_ = view_;
    view_ = copy_;
}

} // namespace trivar
