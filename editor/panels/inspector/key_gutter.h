// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/editor.h"
#include "ui/widgets.h"

#include <string>
#include <vector>

namespace trivar {

// The marks at the right of rows whose numbers can have keys: a hollow diamond is clicked for one
// in the present frame, is amber where there are keys in others, and solid on one.
class KeyGutter {
public:
    KeyGutter(Editor& editor, std::vector<Id> ids) // 0: the scene
        : editor_(editor),
          ids_(std::move(ids))
    {
    }
    // Beside the fields that are drawn next, of those names (core/document/parameters.h). With
    // `apart` each has a field of its own, whose number alone the keyboard means.
    void mark(const ui::Theme& theme, const ui::Row& row, const std::vector<std::string>& names,
              bool apart = false) const;

private:
    void menu(const KeyTarget& all, const std::string& shown) const;
    Editor& editor_;
    std::vector<Id> ids_;
};

// "transform.translation" and the axes that it has.
std::vector<std::string> axes_of(const std::string& parameter, int count = 3);

// What a row says of its value, and the names that this has among the numbers with keys, if any.
struct RowWords {
    RowWords(std::string sentence, std::vector<std::string> names = {})
        : help(std::move(sentence)),
          parameters(std::move(names))
    {
    }
    RowWords(std::string sentence, std::string name)
        : RowWords(std::move(sentence), std::vector{std::move(name)})
    {
    }
    RowWords(const char* sentence) : help(sentence) {}
    std::string help;
    std::vector<std::string> parameters;
};

} // namespace trivar
