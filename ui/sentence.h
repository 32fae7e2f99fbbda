// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace trivar::ui {

// The text with a capital first letter, unless it begins with a file's name; the second function
// adds a full stop too.
std::string capitalised(std::string text);
std::string sentence(std::string text);

} // namespace trivar::ui
