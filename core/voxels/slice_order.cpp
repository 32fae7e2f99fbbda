// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/slice_order.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/files/file_sentences.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace trivar {
namespace {

constexpr double even_within = 0.01; // of the usual distance

void check_parallel(const std::vector<PlacedSlice>& slices)
{
    constexpr double same_direction = 1e-3, same_spacing = 1e-3; // radians; share
    const PlacedSlice& first = slices[0];
    for (const PlacedSlice& each : slices) {
        if (glm::length(each.frame.along_row - first.frame.along_row) > same_direction ||
            glm::length(each.frame.along_column - first.frame.along_column) > same_direction)
            throw Rejected(fmt::format("{} and {} lie in different directions; the slices of a "
                                       "volume are parallel",
                                       first.name, each.name));
        const glm::dvec2 differ = glm::abs(each.frame.spacing - first.frame.spacing);
        if (differ.x > same_spacing * first.frame.spacing.x ||
            differ.y > same_spacing * first.frame.spacing.y)
            throw Rejected(fmt::format("the pixels of {} and {} are not equally far apart",
                                       first.name, each.name));
    }
}

class Ordering {
public:
    explicit Ordering(const std::vector<PlacedSlice>& slices)
        : slices_(slices),
          normal_(
              glm::normalize(glm::cross(slices[0].frame.along_row, slices[0].frame.along_column)))
    {
    }

    SliceOrder order()
    {
        sort();
        check_apart();
        check_line();
        make_even();
        return std::move(out_);
    }

private:
    const PlacedSlice& slice(std::size_t k) const { return slices_[out_.order[k]]; }

    void sort()
    {
        out_.order.resize(slices_.size());
        std::iota(out_.order.begin(), out_.order.end(), std::size_t{0});
        std::vector<double> height(slices_.size());
        for (std::size_t k = 0; k < slices_.size(); ++k)
            height[k] = glm::dot(slices_[k].frame.position, normal_);
        std::ranges::stable_sort(out_.order, {}, [&](std::size_t k) { return height[k]; });
        for (const std::size_t k : out_.order) height_.push_back(height[k] - height[out_.order[0]]);
        for (std::size_t k = 0; k + 1 < height_.size(); ++k)
            gaps_.push_back(height_[k + 1] - height_[k]);
    }

    // Slices nearer than a hundredth of the usual distance are one slice twice. Where all are there
    // twice, the usual distance is nothing but rounding, far below that of pixels.
    void check_apart()
    {
        constexpr double of_pixels = 1e-3;
        const glm::dvec2 spacing = slice(0).frame.spacing;
        const double nearest =
            std::max(even_within * usual_gap(), of_pixels * std::min(spacing.x, spacing.y));
        std::size_t doubles = 0, first = 0;
        for (std::size_t k = gaps_.size(); k-- > 0;)
            if (!(gaps_[k] > nearest)) {
                doubles += 1;
                first = k;
            }
        if (doubles == 0) return;
        throw Rejected(
            fmt::format("{} and {} lie at the same place{}; remove one of them, or, if these are "
                        "different times "
                        "or echoes, read one by itself",
                        slice(first).name, slice(first + 1).name,
                        doubles > 1 ? fmt::format(", and so do {} more", doubles - 1) : ""));
    }

    // The first pixels of all slices lie on a line, which is oblique where the gantry was tilted.
    void check_line()
    {
        const DicomFrame& first = slice(0).frame;
        direction_ = (slice(height_.size() - 1).frame.position - first.position) / height_.back();
        const double tolerance = 0.05 * std::min(first.spacing.x, first.spacing.y) + 1e-3; // mm
        for (std::size_t k = 0; k < height_.size(); ++k) {
            const glm::dvec3 on_line = first.position + direction_ * height_[k];
            const double off = glm::length(slice(k).frame.position - on_line);
            if (off > tolerance)
                throw Rejected(fmt::format("{} lies {} mm beside the line through the first and "
                                           "the last slice; the slices of a volume lie on one",
                                           slice(k).name, number_text(off)));
        }
        const double tilt = glm::degrees(std::atan(glm::length(direction_ - normal_)));
        constexpr double told_from = 0.05;
        if (tilt > told_from)
            out_.notices.push_back(
                fmt::format("its slices are moved in their planes, as by a gantry "
                            "tilted by {:.1f} degrees; the grid is oblique "
                            "likewise",
                            tilt));
    }

    void make_even()
    {
        const double usual = usual_gap();
        std::size_t uneven = 0, first = 0;
        for (std::size_t k = gaps_.size(); k-- > 0;)
            if (std::abs(gaps_[k] - usual) > even_within * usual) {
                uneven += 1;
                first = k;
            }
        double count = static_cast<double>(height_.size());
        if (uneven > 0) {
            out_.even = false;
            count = std::round(height_.back() / usual) + 1;
            if (count > 4 * static_cast<double>(height_.size()) + 4)
                throw Rejected(fmt::format("between {} and {} {} mm have no slice, where {} "
                                           "mm are usual; so much cannot be interpolated",
                                           slice(widest()).name, slice(widest() + 1).name,
                                           number_text(gaps_[widest()], {.digits = 4}),
                                           number_text(usual, {.digits = 4})));
            count = std::max(count, 2.0);
        }
        const double step = height_.back() / (count - 1);
        out_.step = direction_ * step;
        for (int k = 0; k < static_cast<int>(count); ++k)
            out_.at.push_back(out_.even ? k : place_of(k * step));
        if (uneven > 0)
            out_.notices.push_back(
                fmt::format("its slices are not evenly apart: {} mm from {} to {}, where {} mm are "
                            "usual{}; {} slices {} mm apart were interpolated linearly",
                            number_text(gaps_[first], {.digits = 4}), slice(first).name,
                            slice(first + 1).name, number_text(usual, {.digits = 4}),
                            uneven > 1 ? fmt::format(", and {} more such", uneven - 1) : "", count,
                            number_text(step, {.digits = 4})));
    }

    double usual_gap() const // the median
    {
        std::vector<double> sorted = gaps_;
        std::ranges::sort(sorted);
        return sorted[sorted.size() / 2];
    }

    std::size_t widest() const
    {
        return static_cast<std::size_t>(std::ranges::max_element(gaps_) - gaps_.begin());
    }

    // The place among the ordered slices of a height above the first one.
    double place_of(double height) const
    {
        const auto above = std::ranges::upper_bound(height_, height);
        if (above == height_.end()) return static_cast<double>(height_.size() - 1);
        const auto below = static_cast<std::size_t>(above - height_.begin()) - 1;
        return static_cast<double>(below) + (height - height_[below]) / gaps_[below];
    }

    const std::vector<PlacedSlice>& slices_;
    glm::dvec3 normal_, direction_{0};
    std::vector<double> height_, gaps_; // mm along the normal, in order
    SliceOrder out_;
};

} // namespace

SliceOrder ordered_slices(const std::vector<PlacedSlice>& slices)
{
    if (slices.size() < 2) throw Rejected("it has 1 slice; a volume has at least 2");
    check_parallel(slices);
    return Ordering(slices).order();
}

} // namespace trivar
