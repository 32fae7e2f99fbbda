// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/paint.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace trivar {

// FootCards places the cards at the foot of the picture, none over another: each stands where the
// previous ones end.
class FootCards {
public:
    explicit FootCards(const ui::Rect& view) : view_(view) {}
    const ui::Rect& view() const { return view_; } // the whole picture
    // The part of the picture above the cards between two places across it, in pixels.
    ui::Rect above(float left, float right) const
    {
        ui::Rect room = view_;
        for (const ui::Rect& card : cards_)
            if (card.lo.x < right && card.hi.x > left) room.hi.y = std::min(room.hi.y, card.lo.y);
        return room;
    }
    void add(const std::optional<ui::Rect>& card)
    {
        if (card) cards_.push_back(*card);
    }

private:
    ui::Rect view_;
    std::vector<ui::Rect> cards_;
};

} // namespace trivar
