// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/voxels/dicom_file.h"

#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace trivar {

// A slice of a series: where it lies, the file that a sentence names, and that file's number.
struct PlacedSlice {
    DicomFrame frame;
    std::string name;
    long number = 0;
};

// Whether two slices have one direction and one distance of pixels, to a thousandth.
bool parallel(const DicomFrame& a, const DicomFrame& b);

// The slices of a grid, of the slices that a series has.
struct SliceOrder {
    std::vector<std::size_t> order; // numbers of slices, from the first along the normal
    glm::dvec3 step{0};             // mm, from a slice of the grid to the next: oblique if tilted
    // The place of each slice of the grid in `order`: the index, plus the share of the next one.
    // Whole numbers if the series is even.
    std::vector<double> at;
    bool even = true;
    std::vector<std::string> notices; // sentences without the name of the series
};

// Orders slices along the normal of their planes, whatever order they come in. Distances may differ
// by 1 % from the usual one (their median); else the grid has even slices, between which the series
// is to be interpolated linearly. A gantry's tilt moves each slice in its plane: the step is
// oblique then. Places may be off a line by half a pixel or a hundredth of the usual
// distance, since scanners round them; a notice says so. Of several slices at one place, which are
// different times, echoes or copies, the one with that number is taken, from 1 in the order of
// their numbers and then as they come. Throws Rejected for fewer than two places, slices that are
// not parallel or lie on no line, a time that no place has, and gaps that would take more than four
// times as many slices.
SliceOrder ordered_slices(const std::vector<PlacedSlice>& slices, int time = 1);

} // namespace trivar
