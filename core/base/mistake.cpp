// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/mistake.h"

#include "core/base/rejected.h"
#include "core/base/text.h"

#include <algorithm>
#include <fmt/format.h>
#include <new>
#include <string_view>
#include <system_error>

namespace trivar {
namespace {

bool is_of_memory(const std::exception& trouble)
{
    return dynamic_cast<const std::bad_alloc*>(&trouble) != nullptr;
}

} // namespace

void mistaken(const char* wrong, const char* file, int line)
{
    const std::string_view path(file);
    throw Mistake(fmt::format("{} ({}:{})", wrong, path.substr(path.rfind('/') + 1), line));
}

bool is_mistake(const std::exception& trouble)
{
    return !dynamic_cast<const Rejected*>(&trouble) && !dynamic_cast<const Cancelled*>(&trouble) &&
           !dynamic_cast<const std::system_error*>(&trouble) && !is_of_memory(trouble);
}

std::string words_of(const std::exception& trouble)
{
    if (is_of_memory(trouble)) return "There is not enough memory for it";
    std::string words = trouble.what();
    if (!is_mistake(trouble)) return words;
    std::ranges::replace(words, '\n', ' '); // a library's, of several lines
    return short_sentence("Trivar made a mistake here: " + words);
}

} // namespace trivar
