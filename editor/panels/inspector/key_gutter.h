// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/editor.h"
#include "ui/widgets.h"

#include <string>
#include <vector>

namespace trivar {

// A KeyGutter draws the marks at the right of rows whose numbers can have keys: a hollow diamond is
// clicked to set a key in the present frame; it is amber where there are keys in other frames, and
// solid on a key.
class KeyGutter {
public:
    KeyGutter(Editor& editor, std::vector<Id> ids) // 0: the scene
        : editor_(editor),
          ids_(std::move(ids))
    {
    }
    // Draws the mark beside the fields that are drawn next, for parameters of these names
    // (core/document/parameters.h). With `apart` each parameter has a field of its own, and the
    // keyboard acts on that one alone.
    void mark(const ui::Theme& theme, const ui::Row& row, const std::vector<std::string>& names,
              bool apart = false) const;

private:
    void menu(const KeyTarget& all, const std::string& shown) const;
    Editor& editor_;
    std::vector<Id> ids_;
};

// "transform.translation" and the axes that it has.
std::vector<std::string> axes_of(const std::string& parameter, int count = 3);

// RowWords are the words of a row, and the names of its parameters with keys, if any.
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
