// SPDX-License-Identifier: GPL-3.0-or-later
// What the tool of incisions shows: lines, handles, numbers at the mouse, its settings and hints.
#include "core/base/rounded.h"
#include "editor/hands/helpers.h"
#include "editor/hands/viewport_input.h"
#include "editor/tools/incise/incise.h"
#include "editor/tools/incise/incision_picture.h"
#include "ui/icons.h"
#include "ui/option_bar.h"
#include "ui/widgets.h"

#include <algorithm>
#include <imgui.h>

namespace trivar {
namespace {

std::vector<glm::vec2> seen_path(const std::vector<glm::dvec3>& points, const Camera& camera,
                                 const ViewportInput& input)
{
    std::vector<glm::vec2> out;
    for (const glm::dvec3& p : points)
        if (const PicturePoint at = project(camera, p); at.depth_world > 0)
            out.push_back(input.rect.lo + glm::vec2(at.p_px));
    return out;
}

void paint_haloed(const ui::Theme& theme, const std::vector<glm::vec2>& path, ui::Color color,
                  float width)
{
    if (path.size() < 2) return;
    ui::paint_path(path, theme.color.halo, theme.line(width + 2));
    ui::paint_path(path, color, theme.line(width));
}

} // namespace

Helpers InciseTool::helpers(const Session& session, const ui::Theme& theme) const
{
    Helpers out;
    const auto add = [&](std::vector<gpu::Line> lines) {
        std::ranges::move(lines, std::back_inserter(out.lines));
    };
    const SeenIncision* one = gesture_ ? nullptr : seen_chosen(session);
    if (one) add(cage_of(*one, theme));
    for (const auto& each : cuts_)
        if (each) add(dashes_of(*each, session.view.camera, theme, &*each == one));
    return out;
}

void InciseTool::paint_stroke(const Session& session, const ui::Theme& theme,
                              const ViewportInput& input) const
{
    const IncisionStroke& stroke = gesture_->stroke;
    if (stroke.is_click()) return;
    paint_haloed(theme, seen_path(stroke.way_world(), session.view.camera, input),
                 theme.color.incision, 2);
    if (stroke.end())
        for (const glm::vec2& p : seen_path({stroke.end()->p_world}, session.view.camera, input))
            ui::paint_dot(p, theme.px(6), theme.color.selected, theme.color.halo, theme.px(1.5f));
    const glm::vec2 mouse = input.rect.lo + glm::vec2(input.mouse);
    ui::paint_chip(theme, mouse + glm::vec2(theme.px(18), -theme.px(30)),
                   {typed_words(ui::short_number(rounded(stroke.length(), 3)) + " m" +
                                (stroke.end()        ? ", joined"
                                 : stroke.lacks_uv() ? ", drawn freely: no UVs here"
                                                     : ""))});
}

void InciseTool::overlay(const Session& session, const ui::Theme& theme,
                         const ViewportInput& input) const
{
    if (gesture_) return paint_stroke(session, theme, input);
    const Camera& camera = session.view.camera;
    const bool free = !handles_.hovers() && !handles_.busy();
    if (free && hovered_cut_ != 0 && hovered_cut_ != session.incision.number &&
        static_cast<std::size_t>(hovered_cut_) <= cuts_.size() &&
        cuts_[static_cast<std::size_t>(hovered_cut_) - 1]) {
        std::vector<glm::dvec3> line;
        for (const SurfaceHit& each : cuts_[static_cast<std::size_t>(hovered_cut_) - 1]->line)
            line.push_back(each.p_world);
        paint_haloed(theme, seen_path(line, camera, input), theme.color.hovered, 2);
    }
    if (hovered_snap_ && !handles_.busy())
        for (const glm::vec2& p : seen_path({hovered_snap_->p_world}, camera, input))
            ui::paint_dot(p, theme.px(hovered_snap_->along ? 4 : 7), 0, theme.color.selected,
                          theme.px(2));
    handles_.paint(theme, input, handles(session, input.scale));
}

std::string InciseTool::typed_words(const std::string& said) const
{
    return gesture_->redrawn || !typed_.open() ? said : "Width " + typed_.words(0, " m", said);
}

void InciseTool::options(Session&, const ui::Theme& theme, float width)
{
    std::vector<ui::Option> options;
    const auto length = [&](const char* words, double& value, const char* help) {
        options.push_back({words, 76,
                           [&theme, words, &value](float field) {
                               ui::number_field(theme, words, value,
                                                {.lo = 0, .hi = 1000, .unit = "m", .zero = "auto"},
                                                field);
                           },
                           help});
    };
    length("Width", width_world_, "How wide the next incision gapes when it is quite open.");
    length("Depth", depth_world_, "How deep the next incision goes, as far as there is body.");
    options.push_back(ui::enum_option(
        ui::segments, theme, "Floor", 160, "floor", settings_.cut.floor,
        {"Sharp", "Flat", "Through"},
        "Sharp: its walls meet at the bottom. Flat: a floor joins them. Through: it "
        "goes through the body."));
    options.push_back(
        ui::enum_option(ui::segments, theme, "Stroke", 120, "stroke", way_, {"Free", "Line", "UV"},
                        "As the hand goes, straight as it is seen, or along a line of the model's "
                        "texture coordinates."));
    options.push_back({"Open", 100,
                       [&](float) { ui::check_box(theme, "open", opens_, "as it cuts"); },
                       "It opens while it is drawn; else it is shut, to be opened later."});
    options.push_back({"Snap", 62, [&](float) { ui::check_box(theme, "snap", snaps_, "joins"); },
                       "Strokes begin and end at other incisions that are near, and go through "
                       "their crossings."});
    ui::option_bar(theme, options, width);
}

std::vector<Hint> InciseTool::hints(const Session& session) const
{
    if (gesture_)
        return {{{"left"}, "Let go to cut"},
                {{"Shift"}, "Straight"},
                {{"wheel"}, "Width"},
                {{"0", "...", "9"}, "Type the width"},
                {{"Esc", "/", "right"}, "Cancel"}};
    if (handles_.busy() || handles_.hovers()) return handles_.hints();
    std::vector<Hint> out;
    if (hovered_cut_ != 0 && hovered_cut_ == session.incision.number)
        out.push_back({{"Ctrl", "left"}, "Drag to redraw from here"});
    else if (hovered_cut_ != 0)
        out.push_back({{"left"}, "Click to select this incision"});
    if (over_ != 0)
        out.push_back({{"left"}, "Drag to cut"});
    else
        out.push_back({{}, "Draw on a surface"});
    out.push_back({{"Shift"}, "Straight"});
    if (chosen(session)) {
        out.push_back({{"F"}, "Opening"});
        out.push_back({{"Shift", "F"}, "Depth"});
        out.push_back({{"Del"}, "Heal"});
    } else {
        out.push_back({{"middle"}, "Orbit"});
    }
    out.push_back({{"Esc"}, "Select"});
    return out;
}

} // namespace trivar
