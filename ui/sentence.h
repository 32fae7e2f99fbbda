// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace trivar::ui {

// With a capital, unless it begins with a file's name; and with a full stop as well.
std::string capitalised(std::string text);
std::string sentence(std::string text);

} // namespace trivar::ui
