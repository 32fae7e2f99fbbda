// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/editor.h"
#include "ui/paint.h"

#include <functional>
#include <optional>

namespace trivar {

// A KeySpot is a thing of keys that a hand can take, at its place in pixels: the keys of one frame,
// or the handle of a single key.
struct KeySpot {
    glm::vec2 at{0};
    std::vector<KeyName> keys;
    std::optional<KeyHandle> handle = {};
};

// A KeyField is a part of the timeline in which keys are taken.
struct KeyField {
    std::vector<KeySpot> spots;                      // the last ones lie on top
    std::function<glm::dvec2(glm::vec2 p_px)> meant; // the frame there, and the share of the height
    // The range of values that a track shows, from bottom to top; empty: a drag does not change
    // values.
    std::function<glm::dvec2(const TrackName&)> values = {};
    float reach_px = 8;
    // The state of the area that takes the mouse where nothing else does, as ImGui items tell it.
    bool hovered = false, active = false, activated = false;
};

const KeySpot* spot_at(const KeyField& field, glm::vec2 p_px);
bool is_chosen(const KeysView& view, const std::vector<KeyName>& keys);

// Lets the mouse, or a gesture that was begun by a key, choose keys and change them. Called once
// per frame; it also opens and draws the menu of what is under the right button.
void use_keys(Editor& editor, const ui::Theme& theme, const KeyField& field);
// Paints the box that is being drawn, if there is one.
void paint_key_box(const ui::Theme& theme, const KeysView& view);

} // namespace trivar
