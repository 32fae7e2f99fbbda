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
    for (const PlacedSlice& each : slices)
        if (!parallel(slices[0].frame, each.frame))
            throw Rejected(fmt::format("{} and {} have different directions or distances of "
                                       "pixels; the slices of a volume are parallel",
                                       slices[0].name, each.name));
}

double median(std::vector<double> values)
{
    std::ranges::sort(values);
    return values.empty() ? 0 : values[values.size() / 2];
}

class Ordering {
public:
    explicit Ordering(const std::vector<PlacedSlice>& slices)
        : slices_(slices),
          normal_(
              glm::normalize(glm::cross(slices[0].frame.along_row, slices[0].frame.along_column)))
    {
    }

    SliceOrder order(int time)
    {
        sort();
        take_time(time);
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
        take_gaps();
    }

    void take_gaps()
    {
        gaps_.clear();
        for (std::size_t k = 0; k + 1 < height_.size(); ++k)
            gaps_.push_back(height_[k + 1] - height_[k]);
    }

    // Slices nearer than a hundredth of the usual distance are at one place; values far below the
    // distance of pixels are rounding.
    double nearest() const
    {
        constexpr double of_pixels = 1e-3;
        const double rounding = of_pixels * pixel();
        std::vector<double> apart;
        std::ranges::copy_if(gaps_, std::back_inserter(apart),
                             [&](double gap) { return gap > rounding; });
        return std::max(even_within * median(std::move(apart)), rounding);
    }
    double pixel() const
    {
        const glm::dvec2 spacing = slice(0).frame.spacing;
        return std::min(spacing.x, spacing.y);
    }

    void take_time(int time)
    {
        const double same_place = nearest();
        const auto wanted = static_cast<std::size_t>(time);
        std::vector<std::size_t> order;
        std::vector<double> height;
        std::size_t most = 0, fewest = slices_.size(), fullest = 0;
        for (std::size_t k = 0, end = 0; k < out_.order.size(); k = end) {
            for (end = k + 1; end < out_.order.size() && !(gaps_[end - 1] > same_place);) ++end;
            std::sort(out_.order.begin() + static_cast<std::ptrdiff_t>(k),
                      out_.order.begin() + static_cast<std::ptrdiff_t>(end),
                      [&](std::size_t a, std::size_t b) {
                          return std::pair(slices_[a].number, a) < std::pair(slices_[b].number, b);
                      });
            if (end - k > most) fullest = k;
            most = std::max(most, end - k);
            fewest = std::min(fewest, end - k);
            if (wanted > end - k) continue;
            order.push_back(out_.order[k + wanted - 1]);
            height.push_back(height_[k]);
        }
        if (order.empty())
            throw Rejected(fmt::format("it has {} at each place; there is no time {}",
                                       counted(most, "slice", "slices"), time));
        if (order.size() < 2)
            throw Rejected(fmt::format("its {} slices lie at one place; a volume has at least 2 "
                                       "places",
                                       slices_.size()));
        if (most > 1)
            out_.notices.push_back(fmt::format(
                "{}{} slices lie at {}, such as {} and {}: times, echoes or copies; number {} was "
                "taken",
                fewest < most ? "up to " : "", most, fewest < most ? "one place" : "each place",
                slice(fullest).name, slice(fullest + 1).name, time));
        out_.order = std::move(order);
        const double lowest = height[0];
        height_ = std::move(height);
        for (double& each : height_) each -= lowest;
        take_gaps();
    }

    // The first pixels of all slices lie on a line, which is oblique where the gantry was tilted.
    void check_line()
    {
        const DicomFrame& first = slice(0).frame;
        direction_ = (slice(height_.size() - 1).frame.position - first.position) / height_.back();
        constexpr double rounding = 1e-3; // mm
        const double told_from = 0.05 * pixel() + rounding,
                     tolerance = std::max(pixel() / 2, even_within * median(gaps_)) + rounding;
        double most_off = 0;
        for (std::size_t k = 0; k < height_.size(); ++k) {
            const glm::dvec3 on_line = first.position + direction_ * height_[k];
            const double off = glm::length(slice(k).frame.position - on_line);
            if (off > tolerance)
                throw Rejected(fmt::format("{} lies {} mm beside the line through the first and "
                                           "the last slice; the slices of a volume lie on one",
                                           slice(k).name, number_text(off)));
            most_off = std::max(most_off, off);
        }
        if (most_off > told_from)
            out_.notices.push_back(fmt::format("its slices lie up to {} mm beside a line, about as "
                                               "positions are rounded; they were taken as on it",
                                               number_text(most_off)));
        const double tilt = glm::degrees(std::atan(glm::length(direction_ - normal_)));
        constexpr double least_tilt = 0.05;
        if (tilt > least_tilt && glm::length(direction_ - normal_) * height_.back() > 2 * told_from)
            out_.notices.push_back(
                fmt::format("its slices are moved in their planes, as by a gantry "
                            "tilted by {:.1f} degrees; the grid is oblique "
                            "likewise",
                            tilt));
    }

    void make_even()
    {
        const double usual = median(gaps_);
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

bool parallel(const DicomFrame& a, const DicomFrame& b)
{
    constexpr double same_direction = 1e-3, same_spacing = 1e-3; // radians; share
    return glm::length(a.along_row - b.along_row) <= same_direction &&
           glm::length(a.along_column - b.along_column) <= same_direction &&
           glm::all(glm::lessThanEqual(glm::abs(a.spacing - b.spacing), same_spacing * a.spacing));
}

SliceOrder ordered_slices(const std::vector<PlacedSlice>& slices, int time)
{
    if (slices.size() < 2) throw Rejected("it has 1 slice; a volume has at least 2");
    check_parallel(slices);
    return Ordering(slices).order(time);
}

} // namespace trivar
