// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/editor.h"
#include "ui/paint.h"

#include <functional>
#include <optional>

namespace trivar {

// Something of keys that a hand can take, where it stands in pixels: keys of one frame, or the
// handle of the one key.
struct KeySpot {
    glm::vec2 at{0};
    std::vector<KeyName> keys;
    std::optional<KeyHandle> handle = {};
};

// A part of the timeline in which keys are taken.
struct KeyField {
    std::vector<KeySpot> spots;                      // the last lie over the first
    std::function<glm::dvec2(glm::vec2 p_px)> meant; // frame there, and share of the height
    // Between which values a track is shown, from foot to top; empty: a drag changes none.
    std::function<glm::dvec2(const TrackName&)> values = {};
    float reach_px = 8;
    // Of the area that takes the mouse where nothing else does, as ImGui items tell it.
    bool hovered = false, active = false, activated = false;
};

const KeySpot* spot_at(const KeyField& field, glm::vec2 p_px);
bool is_chosen(const KeysView& view, const std::vector<KeyName>& keys);

// Lets the mouse, or a gesture that was asked for by a key, choose keys and change them. Once a
// frame; the menu of what is under the right button is opened here, and drawn.
void use_keys(Editor& editor, const ui::Theme& theme, const KeyField& field);
// The box that is being drawn, if one is.
void paint_key_box(const ui::Theme& theme, const KeysView& view);

} // namespace trivar
