// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lines/stroke.h"

#include <span>

namespace trivar {

// A LineRecord is where a line of a drawing was, by which it is known again.
struct LineRecord {
    std::uint64_t id = 0;
    bool hidden = false;
    std::vector<glm::vec3> points; // voxels, about one per voxel of its length
    bool operator==(const LineRecord&) const = default;
};

LineRecord record_of(const Stroke& stroke);

// LineIds gives the lines of a drawing the ids that they had in the drawing before, so that what
// belongs to a line (a hand's changes, the phase of a wobble) stays with it while the view turns or
// the level moves. A line takes the id of the line before that most of its length lies along; an id
// goes to one line only, the longest first. Lines that were joined to others, or too short to be
// drawn, are remembered for a few drawings, so that they have their ids again when they are back.
class LineIds {
public:
    LineIds() = default;
    explicit LineIds(std::vector<LineRecord> before)
        : before_(std::move(before)),
          age_(before_.size(), 0)
    {
    }

    // Sets the ids of strokes of all kinds, and keeps where they are for the next call. Lines that
    // are new keep their own id, or have a free one where it is taken. O(n log n), 0.5 us per voxel
    // of length.
    void operator()(std::span<std::vector<Stroke>> kinds);

private:
    std::vector<LineRecord> before_;
    std::vector<int> age_; // of the records: number of drawings since they were drawn
};

} // namespace trivar
