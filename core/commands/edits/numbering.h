// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"

#include <map>
#include <set>
#include <string>

namespace trivar {

// Numbering gives names for copies. "Snake" gives "Snake 2", "Snake 2" gives "Snake 3": the first
// number that no object has yet.
class Numbering {
public:
    explicit Numbering(const Document& document);
    std::string next(const std::string& name);
    std::string unique(const std::string& name); // unchanged where no object has that name

private:
    std::set<std::string> taken_;
    std::map<std::string, int> numbers_;
};

} // namespace trivar
