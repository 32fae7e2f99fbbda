// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/words/markdown.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// A ManualPage is a page for artists, from a Markdown file of a folder; its name is the file's,
// without .md.
struct ManualPage {
    std::string name, title; // the title is its first heading, which is not among the blocks
    std::vector<Block> blocks;
};

inline constexpr const char* keys_page = "keys"; // the last; followed by the keys there are

// The pages of a folder, in the order in which one would read them. Pictures have their full path.
std::vector<ManualPage> manual_in(const std::string& folder);

const ManualPage* page_of(const std::vector<ManualPage>& pages, std::string_view name);
// The page to which a link leads: "place.md#gaps" is place; empty: no page of these.
std::string linked_page(std::string_view target);

// A FoundPassage is a place that contains all the words, in any case of letters; for each page the
// best one: its title, a heading, or else any block.
struct FoundPassage {
    std::string page, words; // the words round it
    std::size_t block = 0;
};
std::vector<FoundPassage> found_in(const std::vector<ManualPage>& pages, std::string_view words);

} // namespace trivar
