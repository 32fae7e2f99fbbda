// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/file_sentences.h"

#include "core/base/number_text.h"
#include "core/base/text.h"

#include <fmt/format.h>

namespace trivar {

std::string counted(std::size_t count, const char* one, const char* several)
{
    return with_commas(count) + " " + (count == 1 ? one : several);
}

std::string shown(std::string_view words)
{
    constexpr std::size_t most = 60;
    return printable(words.substr(0, most)) + (words.size() > most ? "..." : "");
}

void NameList::add(std::string_view name)
{
    constexpr std::size_t most = 3;
    if (count_++ < most) first_.push_back(shown(name));
}

std::string NameList::text() const
{
    std::string text;
    for (std::size_t i = 0; i < first_.size(); ++i)
        text += (i == 0 ? "" : i + 1 == count_ ? " and " : ", ") + first_[i];
    if (count_ > first_.size()) text += fmt::format(" and {} more", count_ - first_.size());
    return text;
}

std::string not_a_number(TextScan scan)
{
    const std::string_view word = scan.word();
    if (word.empty()) return "is missing";
    return fmt::format("is '{}', which is not a number from -3.4e38 to 3.4e38", shown(word));
}

std::string faces_left_out(std::size_t count, const std::string& first, std::size_t vertices)
{
    return fmt::format("{} left out ({}{}); the file has {}",
                       counted(count, "face names a vertex that is not there and was",
                               "faces name vertices that are not there and were"),
                       count == 1 ? "" : "the first: ", first,
                       counted(vertices, "vertex", "vertices"));
}

std::string no_whole_face(const std::string& first, std::size_t vertices)
{
    return fmt::format(
        "every face names a vertex that is not there (the first: {}); the file has {}", first,
        counted(vertices, "vertex", "vertices"));
}

std::string points_alone(const std::string& file)
{
    return file + ": it is a point cloud, which is not shown; make a mesh of its points in another "
                  "program, such as MeshLab (Screened Poisson) or CloudCompare, and open that";
}

} // namespace trivar
