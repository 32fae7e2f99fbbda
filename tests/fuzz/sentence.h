// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace trivar::testing {

// Returns the flaw of a sentence for the user: it is empty, longer than 400 bytes, or holds line
// ends, other control characters or bytes that are no UTF-8. Empty: none.
std::string flaw_of_sentence(std::string_view sentence);

// Throws Broken for the first of them that has a flaw.
void check_sentences(const std::vector<std::string>& sentences);

} // namespace trivar::testing
