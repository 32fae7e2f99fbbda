// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/rich_text.h"

#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// A piece of a page, from top to bottom. Code within a line is taken for a key.
struct Block {
    enum class Kind { heading, paragraph, item, row, picture, code } kind = Kind::paragraph;
    int level = 0;       // of a heading, from 1; of an item, how deep
    int number = 0;      // of an item in a numbered list; 0: it has a dot
    bool header = false; // of a row: names the columns
    std::string text;    // of code, with its line breaks; of a picture, its file
    std::vector<ui::Run> runs;
    std::vector<std::vector<ui::Run>> cells; // of a row
};

std::vector<Block> blocks_of(std::string_view markdown);

// The words of a block, without how they look.
std::string plain_text(const std::vector<ui::Run>& runs);

} // namespace trivar
