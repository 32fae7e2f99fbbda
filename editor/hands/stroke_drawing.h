// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/placement.h"

namespace trivar {

// StrokeKeys is what is held while a stroke is drawn.
struct StrokeKeys {
    bool straight = false; // the stroke goes straight on from where this began to be held
    bool close = false;    // the end snaps to the start when it comes near
    double pressure = 1;   // of the samples to come
    double scale = 1;      // of the interface
};

// A StrokeDrawing is a stroke while the hand draws it: pixels of the picture, seconds since it
// began.
class StrokeDrawing {
public:
    void begin(const Camera& camera, double time_s);
    // Takes more of the hand's way; returns whether the stroke has changed.
    bool take(const std::vector<StrokeSample>& moves, const StrokeKeys& keys);
    const Sketch& sketch() const { return sketch_; }
    bool is_click() const; // the hand never left the place where it began
    bool is_ring() const { return snapped_; }

private:
    void add(StrokeSample sample);

    Sketch sketch_;
    double began_s_ = 0;
    std::size_t corner_ = 0; // samples before the straight piece
    bool straight_ = false, snapped_ = false;
};

} // namespace trivar
