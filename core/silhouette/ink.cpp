// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/silhouette/ink.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr float outermost = 0.05f;  // share of the points that a range leaves out on each side
constexpr float faint = 0.3f;       // opacity
constexpr float fine_hidden = 0.6f; // share of the width of a hidden line
constexpr float finest_end = 0.2f;  // share of the width at a loose end
constexpr float wave = 24;          // pixels, of a wobble

// The part of a range that a value is at, 0 .. 1.
class ValueRange {
public:
    explicit ValueRange(std::vector<float> values)
    {
        if (values.empty()) return;
        const auto at = [&](float share) {
            const auto i =
                static_cast<std::ptrdiff_t>(share * static_cast<float>(values.size() - 1));
            std::nth_element(values.begin(), values.begin() + i, values.end());
            return values[static_cast<std::size_t>(i)];
        };
        least_ = at(outermost);
        greatest_ = at(1 - outermost);
    }
    float share(float value) const
    {
        return greatest_ > least_ ? std::clamp((value - least_) / (greatest_ - least_), 0.0f, 1.0f)
                                  : 0.5f;
    }

private:
    float least_ = 0, greatest_ = 0;
};

glm::vec3 hue(float share) // from red over yellow, green and cyan to blue
{
    const float h = 4 * share;
    return glm::clamp(glm::vec3(std::abs(h - 3) - 1, 2 - std::abs(h - 2), 2 - std::abs(h - 4)),
                      0.0f, 1.0f);
}

// A number from -1 to 1 that belongs to a whole number and a seed [Jenkins, one at a time].
float noise_at(std::int64_t i, std::uint64_t seed)
{
    std::uint64_t h = static_cast<std::uint64_t>(i) * 0x9E3779B97F4A7C15u ^ seed;
    h ^= h >> 29;
    h *= 0xBF58476D1CE4E5B9u;
    h ^= h >> 32;
    return static_cast<float>(h & 0xFFFF) / 32767.5f - 1;
}

// Smooth noise along a line.
float wobble_at(float way, std::uint64_t seed)
{
    const float x = way / wave, whole = std::floor(x), t = x - whole;
    const auto i = static_cast<std::int64_t>(whole);
    return std::lerp(noise_at(i, seed), noise_at(i + 1, seed), t * t * (3 - 2 * t));
}

// Inker knows the ranges of all strokes of a drawing.
class Inker {
public:
    Inker(std::span<const Stroke> strokes, const LineStyle& style)
        : style_(style),
          slopes_(values(strokes, [](const StrokePoint& p) { return p.slope; })),
          depths_(values(strokes, [](const StrokePoint& p) { return p.depth; })),
          bends_(values(strokes, [](const StrokePoint& p) { return std::abs(p.bend); }))
    {
    }
    InkedLine operator()(const Stroke& stroke) const
    {
        InkedLine out;
        out.hidden = stroke.hidden;
        out.edge = stroke.edge;
        if (stroke.hidden && style_.hidden == HiddenLines::faint) out.opacity = faint;
        out.dashed = stroke.hidden && style_.hidden == HiddenLines::dashed;
        const auto length = static_cast<float>(stroke.length());
        const float taper = std::min(style_.taper, 0.35f * length);
        const bool fine = stroke.hidden && style_.hidden != HiddenLines::as_seen;
        float way = 0;
        for (std::size_t i = 0; i < stroke.points.size(); ++i) {
            const StrokePoint& p = stroke.points[i];
            if (i > 0) way += glm::distance(p.at, stroke.points[i - 1].at);
            float width = width_at(p) * (fine ? fine_hidden : 1);
            if (stroke.tapers_first) width *= end_share(way, taper);
            if (stroke.tapers_last) width *= end_share(length - way, taper);
            out.points.push_back({moved(stroke, i, way, length), width, color_at(p)});
        }
        return out;
    }

private:
    static std::vector<float> values(std::span<const Stroke> strokes, auto&& of)
    {
        std::vector<float> out;
        for (const Stroke& stroke : strokes)
            if (!stroke.hidden)
                for (const StrokePoint& p : stroke.points) out.push_back(of(p));
        return out;
    }
    static float end_share(float way, float taper)
    {
        return taper > 0 ? std::lerp(finest_end, 1.0f, std::min(1.0f, way / taper)) : 1;
    }
    float width_at(const StrokePoint& p) const
    {
        const auto fine = [&](float share) {
            return style_.width * std::lerp(1.0f, style_.finest, share);
        };
        switch (style_.width_by) {
        case LineWidth::by_slope: return fine(slopes_.share(p.slope));
        case LineWidth::by_depth: return fine(depths_.share(p.depth));
        case LineWidth::by_bend: return fine(bends_.share(std::abs(p.bend)));
        case LineWidth::even: break;
        }
        return style_.width;
    }
    glm::vec3 color_at(const StrokePoint& p) const
    {
        switch (style_.color_by) {
        case LineColor::hue_by_slope: return hue(slopes_.share(p.slope));
        case LineColor::hue_by_depth: return hue(depths_.share(p.depth));
        case LineColor::grey_by_slope:
            return glm::mix(glm::vec3(0.72f), style_.color, slopes_.share(p.slope));
        case LineColor::plain: break;
        }
        return style_.color;
    }
    // A loop comes back to where it began.
    glm::vec2 moved(const Stroke& stroke, std::size_t i, float way, float length) const
    {
        const StrokePoint& p = stroke.points[i];
        if (style_.wobble == 0) return p.at;
        const glm::vec2 along = stroke.points[std::min(i + 1, stroke.points.size() - 1)].at -
                                stroke.points[i > 0 ? i - 1 : 0].at;
        const float norm = glm::length(along);
        if (norm == 0) return p.at;
        const std::uint64_t seed = stroke.edge * 31 + static_cast<std::uint64_t>(style_.seed);
        float out = wobble_at(way, seed);
        if (stroke.is_loop()) {
            const float t = way / length;
            out = std::lerp(out, wobble_at(way - length, seed), t);
        }
        return p.at + style_.wobble * out * glm::vec2(-along.y, along.x) / norm;
    }

    const LineStyle& style_;
    ValueRange slopes_, depths_, bends_;
};

} // namespace

bool InkedLine::is_even() const
{
    return std::ranges::all_of(points,
                               [&](const Point& p) { return p.width == points.front().width; });
}

std::vector<InkedLine> inked(std::span<const Stroke> strokes, const LineStyle& style)
{
    const Inker ink(strokes, style);
    std::vector<InkedLine> out;
    for (const bool hidden : {true, false}) {
        if (hidden && style.hidden == HiddenLines::none) continue;
        for (std::size_t i = 0; i < strokes.size(); ++i)
            if (strokes[i].hidden == hidden) {
                out.push_back(ink(strokes[i]));
                out.back().stroke = i;
            }
    }
    return out;
}

} // namespace trivar
