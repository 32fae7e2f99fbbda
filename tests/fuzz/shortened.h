// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace trivar::testing {

// Returns as few of the lines, in their order, as still fail: none of them can be left out alone.
// All of them must fail. Source: Zeller, Hildebrandt 2002, Simplifying and isolating
// failure-inducing input.
std::vector<std::string>
shortened(std::vector<std::string> lines,
          const std::function<bool(const std::vector<std::string>&)>& fails);

} // namespace trivar::testing
