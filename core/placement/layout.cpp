// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/layout.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/placement/center_line.h"
#include "core/placement/check.h"
#include "core/placement/contact.h"
#include "core/placement/depth_jumps.h"
#include "core/placement/profile.h"
#include "core/placement/sharp.h"
#include "core/placement/sketch.h"
#include "core/placement/view.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace trivar {
namespace {

constexpr double most_missed = 0.6;
constexpr int rounds = 4; // number of measurements with new rays; planes need one
constexpr std::size_t profile_steps = 129;
constexpr double sharpest = 2.4; // largest turn within the width of the strip, radians
// The strip may be narrower or wider in the picture than its width seen face on by these factors.
constexpr double narrowest = 0.25, widest_guess = 2;

std::vector<double> smoothed(std::vector<double> values, int passes)
{
    for (int pass = 0; pass < passes; ++pass) {
        std::vector<double> out = values;
        for (std::size_t i = 1; i + 1 < values.size(); ++i)
            out[i] = (values[i - 1] + 2 * values[i] + values[i + 1]) / 4;
        values = std::move(out);
    }
    return values;
}

std::vector<glm::dvec3> directions(const RayGrid& grid)
{
    std::vector<glm::dvec3> out;
    for (const Ray& ray : grid.rays) out.push_back(ray.direction);
    return out;
}

std::vector<double> greville(const Knots& knots)
{
    std::vector<double> out;
    for (int i = 0; i < knots.count(); ++i) out.push_back(knots.greville(i));
    return out;
}

// row() returns one row of nodes, middle() the mean of the two middle columns.
template <class T> std::vector<T> row(const RayGrid& grid, const std::vector<T>& values, int i)
{
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(grid.index(i, 0));
    return {first, first + grid.columns};
}
std::vector<glm::dvec3> middle(const RayGrid& grid, const std::vector<glm::dvec3>& values)
{
    std::vector<glm::dvec3> out;
    for (int i = 0; i < grid.rows; ++i)
        out.push_back((values[grid.index(i, (grid.columns - 1) / 2)] +
                       values[grid.index(i, grid.columns / 2)]) /
                      2.0);
    return out;
}

// Finds the range of rows of the shrunk strip of which most rays hit something.
std::array<double, 2> hit_range(const RayGrid& grid)
{
    std::array<double, 2> out{1, 0};
    for (int i = 0; i < grid.rows; ++i) {
        int hits = 0;
        for (int j = 0; j < grid.columns; ++j) hits += grid.hit[grid.index(i, j)];
        if (2 * hits <= grid.columns) continue;
        const double a = grid.a[static_cast<std::size_t>(i)];
        out = {std::min(out[0], a), std::max(out[1], a)};
    }
    return out;
}

Curve<glm::dvec2> piece(const Curve<glm::dvec2>& curve, const std::array<double, 2>& range)
{
    std::vector<glm::dvec2> points;
    constexpr int count = 400; // every few pixels of a stroke across the picture
    for (int i = 0; i <= count; ++i)
        points.push_back(evaluate(curve, range[0] + (range[1] - range[0]) * i / count).value);
    return fit_sketch(points, 0.1);
}

// Half of the strip's width in pixels at `steps` equal steps of the center line. The width in
// metres is taken at the line's depth, which is smoothed so that a step of the scene makes no
// notch.
std::vector<double> half_width_px(const RayGrid& center, const Camera& camera, double width,
                                  std::size_t steps)
{
    const View view(camera);
    std::vector<double> depth;
    for (std::size_t k = 0; k < center.rays.size(); ++k)
        depth.push_back(view.project(center.point(k)).depth_world);
    const int passes = static_cast<int>(depth.size()) / 2;
    depth = smoothed(std::move(depth), passes);
    std::vector<double> out;
    for (std::size_t i = 0; i < steps; ++i) {
        const double t = static_cast<double>(i) / static_cast<double>(steps - 1);
        out.push_back(width / 2 / view.pixel_size(profile_at(depth, t)));
    }
    return out;
}

class Builder {
public:
    Builder(const Camera& camera, const PlacementParameters& parameters, const ModelFrame& frame,
            const RayScene& scene, Timings& timings, Jumps jumps)
        : camera_(camera),
          parameters_(parameters),
          frame_(frame),
          scene_(scene),
          timings_(timings),
          width_(parameters.width_profile)
    {
        if (jumps == Jumps::bridged) jumps_.emplace(camera, scene, parameters.skip_back_faces);
    }

    StripLayout build(Curve<glm::dvec2> curve)
    {
        StripLayout out{.axes = {Knots::uniform(parameters_.orders.x, parameters_.grid.x),
                                 Knots::uniform(parameters_.orders.y, parameters_.grid.y)},
                        .strip = strip_round(curve, {0, 0})};
        along_ = greville(out.axes[0]);
        across_ = greville(out.axes[1]);
        begin(out, curve);
        if (jumps_ && missed_ > most_missed) { // too little of it is on one surface
            jumps_.reset();
            begin(out, curve);
        }
        check_misses(out);
        for (int round = 0; round < rounds; ++round) {
            relax(out, 30, 1e-3);
            if (!measure(out)) break;
            cast(out, curve);
        }
        if (jumps_) out.jumps = jumps_->found();
        if (parameters_.sharp) sharpen(out);
        relax(out, 4000, 1e-5);
        std::erase_if(out.features, [&](const SceneSample& f) { return !lies_at(out, f.uv); });
        std::size_t contacts = 0;
        for (std::size_t k = 0; k < out.s.size(); ++k) contacts += out.touches(k);
        out.contact_share = static_cast<double>(contacts) / static_cast<double>(out.s.size());
        for (const double a : a_)
            out.narrowed += out.strip.narrowed[static_cast<std::size_t>(
                                std::lround(a * static_cast<double>(profile_steps - 1)))] != 0;
        return out;
    }

private:
    // Guesses sizes from the middle line, and shortens the strip to the part that meets the scene.
    void begin(StripLayout& out, Curve<glm::dvec2>& curve)
    {
        center_ = middle_line(curve);
        first_guess(out);
        cast(out, curve);
        if (parameters_.misses != Misses::shrink) return;
        const std::array<double, 2> range = hit_range(out.grid);
        if (range[0] <= 0 && range[1] >= 1) return;
        if (!(range[1] - range[0] > 0.1))
            throw Rejected("less than a tenth of the stroke meets an object; draw it over one");
        curve = piece(curve, range);
        center_ = middle_line(curve);
        first_guess(out);
        cast(out, curve);
    }

    RayGrid middle_line(const Curve<glm::dvec2>& curve)
    {
        return timed(timings_, "rays", [&] {
            RayGrid line = center_line(curve, 4 * parameters_.grid.x + 1, camera_, scene_,
                                       parameters_.skip_back_faces);
            if (!jumps_) return line;
            std::vector<glm::dvec2> points_px;
            for (const double a : line.a) points_px.push_back(evaluate(curve, a).value);
            if (!jumps_->bridge(line, points_px)) jumps_.reset();
            return line;
        });
    }

    void first_guess(StripLayout& out)
    {
        std::vector<glm::dvec3> points;
        for (std::size_t k = 0; k < center_.rays.size(); ++k) points.push_back(center_.point(k));
        const std::vector<double> length = walked_length(points, directions(center_));
        a_ = at_length_shares(length, center_.a, along_);
        v_.clear();
        for (std::size_t i = 0; i < along_.size(); ++i)
            v_.insert(v_.end(), across_.begin(), across_.end());
        scale_.assign(profile_steps, 1);
        set_sizes(out, length.back());
    }

    void set_sizes(StripLayout& out, double length)
    {
        out.length = length;
        if (!(length > 0))
            throw Rejected("the stroke is too short in the scene; draw a longer one");
        out.width = strip_width(frame_, parameters_, length);
        out.height = volume_height(frame_, parameters_, length);
    }

    void cast(StripLayout& out, const Curve<glm::dvec2>& curve)
    {
        timed(timings_, "rays", [&] {
            half_px_ = half_width_px(center_, camera_, out.width, profile_steps);
            for (std::size_t i = 0; i < profile_steps; ++i)
                half_px_[i] *= width_.at(
                    length_share(static_cast<double>(i) / static_cast<double>(profile_steps - 1)));
            const double picture = glm::length(camera_.size_px);
            if (!(*std::max_element(half_px_.begin(), half_px_.end()) < picture))
                throw Rejected(fmt::format("a width of {} m is more than the picture shows; "
                                           "reduce the width or zoom out",
                                           number_text(out.width)));
            if (sharpest_turn(curve, half_px_) > sharpest)
                throw Rejected(
                    "the turn is too tight for this width; draw a wider turn or reduce the width");
            for (std::size_t i = 0; i < profile_steps; ++i) half_px_[i] *= scale_[i];
            out.strip = strip_round(curve, half_px_);
            out.grid = shoot(out.strip, a_, v_, camera_, scene_, parameters_.skip_back_faces);
            std::vector<std::size_t> beyond;
            if (jumps_) beyond = jumps_->bridge(out.grid, out.strip, center_);
            if (out.grid.missed_share() < 1)
                out.grid = filled(std::move(out.grid), parameters_.misses);
            for (const std::size_t k : beyond) out.grid.hit[k] = 0;
            missed_ = out.grid.missed_share();
        });
    }

    // Returns the share of the stroke's length before a parameter of the strip.
    double length_share(double a) const
    {
        const auto above = std::upper_bound(a_.begin() + 1, a_.end() - 1, a);
        const auto i = static_cast<std::size_t>(above - a_.begin());
        const double gap = a_[i] - a_[i - 1];
        const double f = gap > 0 ? std::clamp((a - a_[i - 1]) / gap, 0.0, 1.0) : 0;
        return along_[i - 1] * (1 - f) + along_[i] * f;
    }

    void check_misses(const StripLayout&) const
    {
        if (missed_ > most_missed)
            throw Rejected(fmt::format("{} of the model would have no surface beneath it; "
                                       "draw the stroke over an object or reduce the width",
                                       percent_text(missed_)));
    }

    // Relaxes the nodes from their last positions; the tolerance is a share of the height.
    void relax(StripLayout& out, int most_sweeps, double tolerance)
    {
        timed(timings_, "springs", [&] {
            const RayGrid& grid = out.grid;
            SpringSheet& sheet = out.sheet;
            sheet = {};
            sheet.rows = grid.rows;
            sheet.columns = grid.columns;
            for (const double t : along_) sheet.along.push_back(t * out.length);
            for (const double t : across_) sheet.across.push_back(t * out.width);
            sheet.pull = 1 / std::pow(parameters_.stiffness * out.length, 2);
            sheet.bending = parameters_.bending;
            sheet.on_edge = out.on_ridge;
            sheet.direction = spring_directions(grid);
            for (std::size_t k = 0; k < grid.rays.size(); ++k)
                sheet.p0.push_back(grid.point(k) + parameters_.clearance * sheet.direction[k]);
            set_lower_bounds(sheet, grid, out.height);
            set_upper_bounds(sheet, out.height);
            out.s.resize(grid.rays.size(), 0);
            for (std::size_t k = 0; k < out.s.size(); ++k)
                out.s[k] = std::clamp(out.s[k], sheet.lo[k], sheet.hi[k]);
            out.loose.assign(grid.rays.size(), 0);
            if (parameters_.springs) {
                RestShape rest = rest_shape(sheet, out.s,
                                            {.roughness_deg = parameters_.roughness_deg,
                                             .neighborhood = parameters_.neighborhood,
                                             .free_ends = parameters_.free_ends,
                                             .tolerance = tolerance * out.height,
                                             .most_sweeps = most_sweeps});
                out.s = std::move(rest.s);
                out.loose = std::move(rest.loose);
                out.spring_iterations += rest.sweeps;
            }
        });
    }

    // Returns the directions in which nodes move: toward the camera, along the normals, or between.
    std::vector<glm::dvec3> spring_directions(const RayGrid& grid) const
    {
        std::vector<glm::dvec3> out;
        for (const Ray& ray : grid.rays) out.push_back(-ray.direction);
        if (parameters_.offset == 0) return out;
        for (int i = 0; i < grid.rows; ++i)
            for (int j = 0; j < grid.columns; ++j) {
                // The mean of three nodes keeps neighbours at a crease from passing each other.
                const auto at = [&](int di, int dj) {
                    return grid.point(grid.index(std::clamp(i + di, 0, grid.rows - 1),
                                                 std::clamp(j + dj, 0, grid.columns - 1)));
                };
                const glm::dvec3 n = glm::cross(at(2, 0) - at(-2, 0), at(0, 2) - at(0, -2));
                glm::dvec3& d = out[grid.index(i, j)];
                if (!(glm::dot(n, d) > 0)) continue;
                d = glm::normalize(glm::mix(d, glm::normalize(n), parameters_.offset));
            }
        return out;
    }

    // Keeps nodes from sinking into the surface that their rays hit, or into the surface below if
    // they hit none.
    void set_lower_bounds(SpringSheet& sheet, const RayGrid& grid, double height) const
    {
        std::vector<Ray> down;
        std::vector<std::size_t> missed;
        sheet.lo.assign(sheet.p0.size(), 0);
        for (std::size_t k = 0; k < sheet.p0.size(); ++k) {
            if (grid.hit[k]) continue;
            sheet.lo[k] = -10 * height;
            missed.push_back(k);
            down.push_back({sheet.p0[k], -sheet.direction[k]});
        }
        if (parameters_.offset == 0 || !parameters_.springs) return;
        const auto below = scene_.hits(down, parameters_.skip_back_faces);
        for (std::size_t m = 0; m < missed.size(); ++m) {
            double& lo = sheet.lo[missed[m]];
            if (below[m])
                lo = std::max(lo, std::min(0.0, parameters_.clearance - below[m]->distance));
        }
    }

    // Bounds how far nodes may rise. Toward the camera nothing is in the way of a node that it
    // sees; in other directions the next surface is the bound.
    void set_upper_bounds(SpringSheet& sheet, double height) const
    {
        sheet.hi.assign(sheet.p0.size(), std::numeric_limits<double>::infinity());
        if (parameters_.offset == 0 || !parameters_.springs) return;
        const double start = 1e-6 * (height + glm::length(sheet.p0.front()));
        std::vector<Ray> up;
        for (std::size_t k = 0; k < sheet.hi.size(); ++k)
            up.push_back({sheet.p0[k] + start * sheet.direction[k], sheet.direction[k]});
        const auto above = scene_.hits(up, parameters_.skip_back_faces);
        for (std::size_t k = 0; k < sheet.hi.size(); ++k)
            if (above[k])
                sheet.hi[k] = std::max(0.0, above[k]->distance + start - parameters_.clearance);
    }

    // Adds knots and nodes where the scene has creases.
    void sharpen(StripLayout& out)
    {
        auto sharp = timed(timings_, "rays",
                           [&] { return sharpened(out, View(camera_), scene_, parameters_); });
        if (!sharp) return;
        out = std::move(*sharp);
        along_ = greville(out.axes[0]), across_ = greville(out.axes[1]), a_ = out.grid.a;
    }

    // Says whether all nodes round a place touch the scene.
    bool lies_at(const StripLayout& out, glm::dvec2 uv) const
    {
        const int i = bracket(along_, uv.x).first, j = bracket(across_, uv.y).first;
        return out.touches(out.grid.index(i, j)) && out.touches(out.grid.index(i + 1, j)) &&
               out.touches(out.grid.index(i, j + 1)) && out.touches(out.grid.index(i + 1, j + 1));
    }

    // Changes the parameters so that nodes are at equal lengths on the present surface; false if
    // nothing changed.
    bool measure(StripLayout& out)
    {
        const RayGrid& grid = out.grid;
        const std::vector<glm::dvec3> points = out.points();
        const std::vector<glm::dvec3> views = directions(grid);
        const std::vector<double> length = walked_length(middle(grid, points), middle(grid, views));
        const std::vector<double> a = at_length_shares(length, grid.a, along_);
        double change = 0;
        for (std::size_t i = 0; i < a.size(); ++i)
            change = std::max(change, std::abs(a[i] - a_[i]));
        const double old_width = out.width, old_length = out.length;
        set_sizes(out, length.back());
        std::vector<double> factor;
        for (int i = 0; i < grid.rows; ++i) {
            const std::vector<double> walked =
                walked_length(row(grid, points, i), row(grid, views, i));
            const std::vector<double> v = at_length_shares(walked, row(grid, grid.v, i), across_);
            for (int j = 0; j < grid.columns; ++j) {
                double& old = v_[grid.index(i, j)];
                change = std::max(change, std::abs(v[static_cast<std::size_t>(j)] - old));
                old = v[static_cast<std::size_t>(j)];
            }
            // A narrowed row is meant to be that much narrower.
            const double at = grid.a[static_cast<std::size_t>(i)];
            const double kept =
                (profile_at(out.strip.left_px, at) + profile_at(out.strip.right_px, at)) /
                (2 * profile_at(half_px_, at));
            const double wanted = old_width * width_.at(along_[static_cast<std::size_t>(i)]);
            factor.push_back(walked.back() > 0 ? wanted * kept / walked.back() : 1);
        }
        factor = smoothed(std::move(factor), 4);
        std::size_t i = 0;
        for (std::size_t step = 0; step < profile_steps; ++step) {
            const double t = static_cast<double>(step) / static_cast<double>(profile_steps - 1);
            while (i + 2 < grid.a.size() && grid.a[i + 1] < t) ++i;
            const double gap = grid.a[i + 1] - grid.a[i];
            const double f = gap > 0 ? std::clamp((t - grid.a[i]) / gap, 0.0, 1.0) : 0;
            const double next = std::clamp(scale_[step] * (factor[i] * (1 - f) + factor[i + 1] * f),
                                           narrowest, widest_guess);
            change = std::max(change, std::abs(next - scale_[step]));
            scale_[step] = next;
        }
        a_ = a;
        change = std::max(
            {change, std::abs(out.width / old_width - 1), std::abs(out.length / old_length - 1)});
        return change > 1e-12;
    }

    const Camera& camera_;
    const PlacementParameters& parameters_;
    const ModelFrame& frame_;
    const RayScene& scene_;
    Timings& timings_;
    std::optional<DepthJumps> jumps_; // where they are bridged
    RayGrid center_;
    std::vector<double> along_, across_;  // wanted places of the nodes, as shares of the lengths
    std::vector<double> a_, v_;           // where on the strip that is
    std::vector<double> scale_, half_px_; // of the half width, at profile_steps
    double missed_ = 1;
    Profile width_;
};

} // namespace

StripLayout lay_out(const Sketch& sketch, const PlacementParameters& parameters,
                    const ModelFrame& frame, const RayScene& scene, Timings& timings, Jumps jumps)
{
    check(parameters);
    Curve<glm::dvec2> center =
        timed(timings, "sketch", [&] { return fit_sketch(stroke_points(sketch)); });
    if (!parameters.skip_back_faces && sketch.camera.perspective)
        check_enclosed(sketch.camera, scene);
    return Builder(sketch.camera, parameters, frame, scene, timings, jumps)
        .build(std::move(center));
}

} // namespace trivar
