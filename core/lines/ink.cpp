// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lines/ink.h"

#include "core/field/value_range.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr float faint = 0.3f;           // opacity
constexpr float fine_hidden = 0.6f;     // share of the width of a hidden line
constexpr float finest_end = 0.2f;      // share of the width at a loose end
constexpr float wobble_wave = 24;       // pixels
constexpr float grain_wave = 5;         // pixels, of a pencil
constexpr int pencil_passes = 3;        // over a line
constexpr float pencil_sway = 0.8f;     // pixels that a pass goes aside, at most
constexpr float finest_strength = 0.3f; // share of the width of a line that is hardly there

glm::vec3 hue(float share) // from red over yellow, green and cyan to blue
{
    const float h = 4 * share;
    return glm::clamp(glm::vec3(std::abs(h - 3) - 1, 2 - std::abs(h - 2), 2 - std::abs(h - 4)),
                      0.0f, 1.0f);
}

// A number from -1 to 1 that belongs to a place of a lattice and a seed [Steele, Lea, Flood 2014].
float noise_at(const glm::ivec3& at, std::uint64_t seed)
{
    const auto u = [](int i) { return static_cast<std::uint64_t>(i); };
    std::uint64_t h = u(at.x) * 0x9E3779B97F4A7C15u ^ u(at.y) * 0xC2B2AE3D27D4EB4Fu ^
                      u(at.z) * 0x165667B19E3779F9u ^ seed * 0xD6E8FEB86659FD93u;
    h ^= h >> 29;
    h *= 0xBF58476D1CE4E5B9u;
    h ^= h >> 32;
    return static_cast<float>(h & 0xFFFF) / 32767.5f - 1;
}

// Smooth noise in space, with waves of 2^octave voxels.
float octave_noise(const glm::vec3& p, int octave, std::uint64_t seed)
{
    const glm::vec3 x = p * std::ldexp(1.0f, -octave), whole = glm::floor(x), t = x - whole;
    const glm::vec3 s = t * t * (3.0f - 2.0f * t);
    const glm::ivec3 at(whole);
    const std::uint64_t own = seed * 31 + static_cast<std::uint64_t>(octave + 64);
    float out = 0;
    for (int k = 0; k < 8; ++k) {
        const glm::ivec3 c(k & 1, k >> 1 & 1, k >> 2);
        const glm::vec3 share = glm::mix(1.0f - s, s, glm::vec3(c));
        out += share.x * share.y * share.z * noise_at(at + c, own);
    }
    return out;
}

// The same with waves of any length: a mixture of the two next octaves, so that it does not jump
// when a view comes nearer.
float space_noise(const glm::vec3& p, float octave, std::uint64_t seed)
{
    const float whole = std::floor(octave);
    const int first = static_cast<int>(whole);
    return std::lerp(octave_noise(p, first, seed), octave_noise(p, first + 1, seed),
                     octave - whole);
}

// Inker knows the ranges of all strokes of a drawing.
class Inker {
public:
    Inker(std::span<const Stroke> strokes, const LineStyle& style)
        : style_(style),
          slopes_(values(strokes, [](const StrokePoint& p) { return p.slope; })),
          depths_(values(strokes, [](const StrokePoint& p) { return p.depth; })),
          bends_(values(strokes, [](const StrokePoint& p) { return std::abs(p.bend); })),
          scale_(scale_of(strokes))
    {
    }
    void operator()(const Stroke& stroke, std::vector<InkedLine>& out) const
    {
        const int passes = style_.pencil > 0 ? pencil_passes : 1;
        for (int pass = 0; pass < passes; ++pass) out.push_back(line_of(stroke, pass));
    }

private:
    static float scale_of(std::span<const Stroke> strokes)
    {
        double pixels = 0, voxels = 0;
        for (const Stroke& stroke : strokes)
            for (std::size_t i = 1; i < stroke.points.size(); ++i) {
                pixels += double{glm::distance(stroke.points[i].at, stroke.points[i - 1].at)};
                voxels += double{glm::distance(stroke.points[i].p, stroke.points[i - 1].p)};
            }
        return pixels > 0 && voxels > 0 ? static_cast<float>(pixels / voxels) : 1;
    }
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
    InkedLine line_of(const Stroke& stroke, int pass) const
    {
        InkedLine out;
        out.hidden = stroke.hidden;
        out.id = stroke.id;
        out.strays = style_.wobble > 0 || style_.pencil > 0;
        if (stroke.hidden && style_.hidden == HiddenLines::faint) out.opacity = faint;
        out.dashed = stroke.hidden && style_.hidden == HiddenLines::dashed;
        const std::uint64_t seed = static_cast<std::uint64_t>(style_.seed) * pencil_passes +
                                   static_cast<std::uint64_t>(pass);
        const float sway = style_.wobble + pencil_sway * style_.pencil;
        if (style_.pencil > 0) out.opacity *= std::lerp(1.0f, 0.5f, style_.pencil);
        const auto length = static_cast<float>(stroke.length());
        const float taper = std::min(style_.taper, 0.35f * length);
        const bool fine = stroke.hidden && style_.hidden != HiddenLines::as_seen;
        float way = 0;
        for (std::size_t i = 0; i < stroke.points.size(); ++i) {
            const StrokePoint& p = stroke.points[i];
            if (i > 0) way += glm::distance(p.at, stroke.points[i - 1].at);
            float width = width_at(p) * (fine ? fine_hidden : 1) *
                          std::lerp(finest_strength, 1.0f, p.strength);
            if (stroke.tapers_first) width *= end_share(way, taper);
            if (stroke.tapers_last) width *= end_share(length - way, taper);
            if (style_.pencil > 0) width *= grain_at(p, seed);
            out.points.push_back({moved(stroke, i, sway, seed), width, color_at(p), p.p});
        }
        return out;
    }
    // Returns the share of the width that a pencil leaves at a point.
    float grain_at(const StrokePoint& p, std::uint64_t seed) const
    {
        const float grain = space_noise(p.p, octave(grain_wave), seed + 77);
        return std::max(0.08f, 1 - style_.pencil * (0.45f - 0.5f * grain));
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
    glm::vec2 moved(const Stroke& stroke, std::size_t i, float sway, std::uint64_t seed) const
    {
        const StrokePoint& p = stroke.points[i];
        if (sway == 0) return p.at;
        const std::size_t n = stroke.points.size();
        const bool loop = stroke.is_loop(); // which comes back to where it began
        const std::size_t before = i > 0  ? i - 1
                                   : loop ? n - 2
                                          : 0,
                          after = i + 1 < n ? i + 1
                                  : loop    ? 1
                                            : n - 1;
        const glm::vec2 along = stroke.points[after].at - stroke.points[before].at;
        const float norm = glm::length(along);
        if (norm == 0) return p.at;
        return p.at + sway * space_noise(p.p, octave(wobble_wave), seed) *
                          glm::vec2(-along.y, along.x) / norm;
    }
    // log2 of so many pixels in voxels.
    float octave(float pixels) const
    {
        return std::clamp(std::log2(pixels / scale_), -8.0f, 16.0f);
    }

    const LineStyle& style_;
    ValueRange slopes_, depths_, bends_;
    float scale_; // pixels per voxel, on average
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
                const std::size_t first = out.size();
                ink(strokes[i], out);
                for (std::size_t k = first; k < out.size(); ++k) out[k].stroke = i;
            }
    }
    return out;
}

} // namespace trivar
