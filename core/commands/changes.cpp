// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/changes.h"

#include <cctype>
#include <cmath>
#include <fmt/format.h>

namespace trivar {
namespace {

// Gathers what differs; `say` makes the value's text only then.
class Compared {
public:
    template <class T, class Say>
    void operator()(const std::string& name, const T& before, const T& after, Say&& say)
    {
        if (!(before == after)) changes_.push_back({name, say(after)});
    }
    Changes take() { return std::move(changes_); }

private:
    Changes changes_;
};

std::string size(double metres)
{
    return metres == 0 ? "automatic" : in_metres(metres);
}
auto either(std::string yes, std::string no)
{
    return [yes = std::move(yes), no = std::move(no)](bool value) { return value ? yes : no; };
}
std::string triple(const glm::ivec3& n)
{
    return fmt::format("{} × {} × {}", n.x, n.y, n.z);
}
std::string plain(double value)
{
    return brief_number(value);
}

std::string with_small_letter(std::string text)
{
    text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
    return text;
}

// As designers write colours: sRGB, #RRGGBB.
std::string color_text(const glm::vec4& linear)
{
    const auto byte = [](float c) {
        const double s = c <= 0.0031308f ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
        return static_cast<int>(std::lround(std::min(std::max(s, 0.0), 1.0) * 255));
    };
    return fmt::format("#{:02X}{:02X}{:02X}", byte(linear.x), byte(linear.y), byte(linear.z));
}

} // namespace

std::string brief_number(double value)
{
    if (value == 0) return "0";
    const double size = std::abs(value);
    if (!std::isfinite(value) || size < 1e-3 || size >= 1e6) return fmt::format("{:.3g}", value);
    const int digits = std::max(0, 2 - static_cast<int>(std::floor(std::log10(size))));
    std::string text = fmt::format("{:.{}f}", value, digits);
    if (digits == 0) return text;
    while (text.ends_with('0')) text.pop_back();
    if (text.ends_with('.')) text.pop_back();
    return text;
}

std::string in_metres(double value)
{
    return brief_number(value) + " m";
}

std::string in_degrees(double value)
{
    return brief_number(value) + "°";
}

std::string in_seconds(double value)
{
    return brief_number(value) + " s";
}

Changes changes(const PlacementParameters& before, const PlacementParameters& after)
{
    const PlacementParameters &a = before, &b = after;
    const auto misses = [](Misses m) -> std::string {
        switch (m) {
        case Misses::membrane: return "membrane";
        case Misses::ground: return "drop to the ground";
        case Misses::nearest: return "nearest point";
        case Misses::shrink: return "shrink";
        }
        return {};
    };
    Compared compare;
    compare("Width", a.width, b.width, size);
    compare("Height", a.height, b.height, size);
    const auto points = [](const std::vector<glm::dvec2>& profile) {
        return profile.empty() ? "even" : fmt::format("{} points", profile.size());
    };
    compare("Width profile", a.width_profile, b.width_profile, points);
    compare("Height profile", a.height_profile, b.height_profile, points);
    compare("Height across", a.height_across, b.height_across, points);
    compare("Height map", a.height_map, b.height_map,
            [](const std::vector<std::vector<double>>& grid) {
                return grid.empty() ? "even"
                                    : fmt::format("{} × {} points", grid.size(), grid[0].size());
            });
    compare("Rise", a.rise_profile, b.rise_profile, points);
    compare("Contact level", a.contact_level, b.contact_level, plain);
    compare("Offset", a.offset, b.offset, plain);
    compare("Density", a.grid, b.grid, triple);
    compare("Order", a.orders, b.orders, triple);
    compare("Gaps", a.springs, b.springs, either("bridged", "not bridged"));
    compare("Stiffness", a.stiffness, b.stiffness, plain);
    compare("Bending", a.bending, b.bending, plain);
    compare("Reach", a.neighborhood, b.neighborhood, plain);
    compare("Roughness", a.roughness_deg, b.roughness_deg, in_degrees);
    compare("Ends", a.free_ends, b.free_ends, either("free", "fixed"));
    compare("Misses", a.misses, b.misses, misses);
    compare("Back faces", a.skip_back_faces, b.skip_back_faces, either("let through", "hit"));
    compare("Edges", a.sharp, b.sharp, either("sharp", "rounded"));
    compare("Start", a.start, b.start, plain);
    compare("Fill", a.fill, b.fill, plain);
    compare("Sinking", a.lift_tolerance, b.lift_tolerance, plain);
    compare("Clearance", a.clearance, b.clearance, in_metres);
    compare("Axis along", a.along, b.along,
            [](LengthAxis axis) { return std::string(1, "xyz"[static_cast<int>(axis)]); });
    compare("Direction", a.reverse, b.reverse, either("toward the start", "toward the end"));
    compare("Roll", a.roll_deg, b.roll_deg, in_degrees);
    return compare.take();
}

Changes changes(const Surfacing& before, const Surfacing& after)
{
    Compared compare;
    compare("Colour", glm::vec3(before.base_color), glm::vec3(after.base_color),
            [](const glm::vec3& c) {
                return color_text({c, 1});
            });
    compare("Opacity", before.base_color.w, after.base_color.w, plain);
    compare("Metallic", before.metallic, after.metallic, plain);
    compare("Roughness", before.roughness, after.roughness, plain);
    compare("Filling", before.solid, after.solid, [](Solid solid) {
        return std::string(choice_names<Solid>[static_cast<std::size_t>(solid)]);
    });
    return compare.take();
}

Changes changes(const RenderSettings& before, const RenderSettings& after)
{
    constexpr double degrees = 57.29577951308232;
    const auto angle = [](double radians) { return in_degrees(radians * degrees); };
    Compared compare;
    compare("Look", before.look, after.look, [](const std::string& look) { return look; });
    compare("Exposure", before.exposure, after.exposure, [](double stops) {
        return brief_number(stops) + (std::abs(stops) == 1 ? " stop" : " stops");
    });
    compare("Sun round", before.sun_azimuth, after.sun_azimuth, angle);
    compare("Sun height", before.sun_elevation, after.sun_elevation, angle);
    compare("Shadows", before.shadows, after.shadows, either("on", "off"));
    compare("Dark corners", before.ambient_occlusion, after.ambient_occlusion, either("on", "off"));
    compare("Edges", before.wire, after.wire, either("on", "off"));
    compare("Colour by", before.color_by, after.color_by, [](ColorBy by) {
        return std::string(choice_names<ColorBy>[static_cast<std::size_t>(by)]);
    });
    compare("Volumes", before.volumes, after.volumes, either("shown", "not shown"));
    compare("Captions", before.captions, after.captions, either("shown", "not shown"));
    compare("Ground", before.ground, after.ground, either("on", "off"));
    return compare.take();
}

Changes changes(const Playing& before, const Playing& after)
{
    const auto repeat = [](Repeat r) -> std::string {
        return r == Repeat::once ? "once" : r == Repeat::loop ? "loop" : "back and forth";
    };
    Compared compare;
    compare("Clip", before.clip, after.clip, [](const std::string& clip) { return clip; });
    compare("Speed", before.speed, after.speed, [](double v) { return brief_number(v) + " x"; });
    compare("Repeat", before.repeat, after.repeat, repeat);
    compare("Offset", before.offset, after.offset, in_seconds);
    compare("Start", before.start_frame, after.start_frame,
            [](int frame) { return fmt::format("at frame {}", frame); });
    compare("Foot lock", before.foot_lock, after.foot_lock,
            [](bool on) { return std::string(on ? "on" : "off"); });
    return compare.take();
}

Changes changes(const Travel& before, const Travel& after)
{
    const auto ends = [](Ends e) -> std::string {
        switch (e) {
        case Ends::stay: return "stay";
        case Ends::hide: return "hide";
        case Ends::run_on: return "run on";
        case Ends::loop: return "loop";
        case Ends::back_and_forth: return "back and forth";
        }
        return {};
    };
    Compared compare;
    compare("Speed", before.speed, after.speed, [](double v) { return brief_number(v) + " m/s"; });
    compare("Ends", before.ends, after.ends, ends);
    compare("Ease in", before.ease_in, after.ease_in, in_seconds);
    compare("Ease out", before.ease_out, after.ease_out, in_seconds);
    compare("Start", before.start_frame, after.start_frame,
            [](int frame) { return fmt::format("at frame {}", frame); });
    compare("Duration", before.duration, after.duration,
            [](double s) { return s == 0 ? std::string("unlimited") : in_seconds(s); });
    compare("Followers", before.followers, after.followers,
            [](int count) { return std::to_string(count); });
    compare("Gap", before.gap, after.gap,
            [](double gap) { return gap == 0 ? std::string("by itself") : in_metres(gap); });
    compare("Phase", before.phase, after.phase, brief_number);
    return compare.take();
}

Changes changes(const Time& before, const Time& after)
{
    const auto frame = [](int number) { return std::to_string(number); };
    Compared compare;
    compare("First frame", before.first_frame, after.first_frame, frame);
    compare("Last frame", before.last_frame, after.last_frame, frame);
    compare("Rate", before.frames_per_second, after.frames_per_second,
            [](double fps) { return brief_number(fps) + " fps"; });
    return compare.take();
}

StepTitle title_of_changes(const Changes& changes, const std::string& whole,
                           const std::string& object)
{
    const std::string of = object.empty() ? "" : " of " + object;
    if (changes.empty()) return {whole + of, "as before"};
    if (changes.size() == 1) return {changes[0].name + of, changes[0].value};
    if (changes.size() == 2)
        return {changes[0].name + " and " + with_small_letter(changes[1].name) + of, {}};
    return {whole + of, fmt::format("{} values", changes.size())};
}

} // namespace trivar
