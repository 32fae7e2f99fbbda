// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drawing/drawing_sheet.h"

#include <gtest/gtest.h>

namespace trivar::testing {

// Two lines, the second one hidden, whose slopes and depths grow from 0 to 99.
inline std::vector<Stroke> two_lines()
{
    std::vector<Stroke> out(2);
    for (int i = 0; i < 100; ++i) {
        const auto x = static_cast<float>(i);
        out[0].points.push_back({.at = {x, 10}, .depth = x, .slope = x, .p = {x / 2, 10, 0}});
        out[1].points.push_back({.at = {x, 20}, .depth = x, .slope = x, .p = {x / 2, 20, 5}});
    }
    out[0].id = 0xabc;
    out[1].id = 0x12;
    out[1].hidden = true;
    return out;
}

inline DrawingSheet two_line_drawing(const LineStyle& style = {.taper = 0,
                                                               .hidden = HiddenLines::faint})
{
    return {{{"bone & skin", inked(two_lines(), style)}}, {640, 480}};
}

// A text in which the first place of some words has others.
inline std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    const std::size_t at = text.find(from);
    EXPECT_NE(at, text.npos) << from;
    return at == text.npos ? text : text.replace(at, from.size(), to);
}

// A text without the path that has an id.
inline std::string without_path(const std::string& text, const std::string& id)
{
    const std::size_t at = text.find("<path id=\"" + id + "\"");
    EXPECT_NE(at, text.npos) << id;
    return at == text.npos ? text : text.substr(0, at) + text.substr(text.find('\n', at) + 1);
}

} // namespace trivar::testing
