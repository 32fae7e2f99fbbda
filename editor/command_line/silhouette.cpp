// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/command_line/silhouette.h"

#include "core/base/box.h"
#include "core/base/rejected.h"
#include "core/files/file_bytes.h"
#include "core/silhouette/level_drawing.h"
#include "core/silhouette/voxel_field.h"
#include "core/voxels/read_volume.h"
#include "core/voxels/usual_level.h"
#include "editor/command_line/drawing.h"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>

namespace trivar {
namespace {

template <class Choice, std::size_t N>
Choice choice_of(const std::string& text, const std::array<std::string_view, N>& names,
                 const char* option)
{
    const auto found = std::ranges::find(names, text);
    if (found == names.end())
        throw WrongUsage(
            fmt::format("--{}: \"{}\" is none of {}", option, text, fmt::join(names, ", ")));
    return static_cast<Choice>(found - names.begin());
}

LineStyle style_of(const SilhouetteCommand& command)
{
    LineStyle out;
    out.width = static_cast<float>(command.width);
    out.width_by =
        choice_of<LineWidth, 4>(command.width_by, {"even", "slope", "depth", "bend"}, "width-by");
    out.color_by =
        choice_of<LineColor, 4>(command.color_by, {"plain", "slope", "depth", "grey"}, "color-by");
    out.hidden =
        choice_of<HiddenLines, 4>(command.hidden, {"none", "faint", "dashed", "seen"}, "hidden");
    out.wobble = static_cast<float>(command.wobble);
    out.seed = command.seed;
    if (command.paper == "black") out.color = glm::vec3(0.95f);
    return out;
}

std::optional<glm::vec3> paper_of(const SilhouetteCommand& command)
{
    if (command.paper == "none") return std::nullopt;
    if (command.paper == "white") return glm::vec3(1);
    if (command.paper == "black") return glm::vec3(0);
    throw WrongUsage(fmt::format("--paper: \"{}\" is none of white, black, none", command.paper));
}

glm::dvec3 direction_of(const std::vector<double>& numbers, const char* option)
{
    if (numbers.size() != 3)
        throw WrongUsage(fmt::format("--{}: a direction is three numbers, X,Y,Z", option));
    const glm::dvec3 out(numbers[0], numbers[1], numbers[2]);
    if (!(glm::length(out) > 0))
        throw WrongUsage(fmt::format("--{}: a direction cannot be 0,0,0", option));
    return glm::normalize(out);
}

// A camera that sees the whole grid.
Camera camera_of(const SilhouetteCommand& command, const VoxelGrid& grid)
{
    constexpr double margin = 1.05, steep = 0.95; // a sight so near to Z has Y upward
    const glm::dvec3 forward = direction_of(command.view, "view");
    const auto place = [&](const glm::dvec3& p) {
        return glm::dvec3(grid.to_metres * glm::dvec4(p, 1));
    };
    Camera out;
    out.size_px = picture_size(command.size);
    out.target = place(glm::dvec3(grid.size - 1) / 2.0);
    out.up = !command.up.empty()           ? direction_of(command.up, "up")
             : std::abs(forward.z) > steep ? glm::dvec3(0, 1, 0)
                                           : glm::dvec3(0, 0, 1);
    const glm::dvec3 right = glm::cross(forward, out.up);
    if (!(glm::length(right) > 1e-6)) throw WrongUsage("--up: it is the direction of sight");
    const glm::dvec3 across = glm::normalize(right), upward = glm::cross(across, forward);
    glm::dvec3 half(0); // of what is seen, across, upward and along
    for (const glm::dvec3& corner : Box{glm::dvec3(0), glm::dvec3(grid.size - 1)}.corners()) {
        const glm::dvec3 d = place(corner) - out.target;
        half = glm::max(half, glm::abs(glm::dvec3(glm::dot(d, across), glm::dot(d, upward),
                                                  glm::dot(d, forward))));
    }
    const double height =
        margin * std::max(half.y, half.x * out.size_px.y / out.size_px.x); // half of it
    out.perspective = command.fov_deg > 0;
    out.height_world = 2 * height;
    out.fov_y = glm::radians(command.fov_deg);
    const double distance =
        out.perspective ? half.z + height / std::tan(out.fov_y / 2) : 4 * glm::length(half);
    out.eye = out.target - distance * forward;
    return out;
}

LevelDrawing drawing_of(const SilhouetteCommand& command, const VoxelField& volume,
                        const std::vector<double>& values)
{
    const VoxelGrid& grid = volume.grid();
    std::vector<LevelMesh> meshes;
    for (const double value : values) meshes.push_back(volume.level(value));
    std::vector<DrawnLevel> levels;
    for (std::size_t i = 0; i < meshes.size(); ++i)
        levels.push_back({.name = fmt::format("level {:.6g}", values[i]),
                          .mesh = meshes[i],
                          .side = volume.side(command.below ? LevelSide::below : LevelSide::above),
                          .style = style_of(command)});
    return draw_levels(volume.field(), volume.hulls(), levels,
                       drawing_view(camera_of(command, grid), grid.to_metres, grid.size),
                       {.certified_depth = command.certified});
}

} // namespace

Status run_silhouette(const SilhouetteCommand& command, const Streams& streams)
{
    style_of(command); // says what is wrong of the options before anything is read
    direction_of(command.view, "view");
    const std::optional<glm::vec3> paper = paper_of(command);
    if (!command.out.ends_with(".svg")) throw WrongUsage("--out: a drawing is written as .svg");
    const Ref<VoxelGrid> grid = make_ref(read_volume(command.volume).grid);
    for (const std::string& notice : grid->notices)
        streams.talk << "trivar: " << command.volume << ": " << notice << "\n";
    std::vector<double> values = command.levels;
    if (values.empty()) values.push_back(usual_level(summary_of(*grid), *grid));
    const auto start = std::chrono::steady_clock::now();
    const FieldSpline spline = command.smooth ? FieldSpline::smoothing : FieldSpline::interpolating;
    const VoxelField volume(grid, {.spline = spline, .blur = command.blur});
    const LevelDrawing drawing = drawing_of(command, volume, values);
    const std::string text = svg_of(drawing.layers, picture_size(command.size), paper);
    write_bytes(command.out, text);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    std::size_t lines = 0;
    for (const DrawingLayer& layer : drawing.layers) lines += layer.lines.size();
    streams.talk << fmt::format("trivar: {}: {} line{} of {} level{}, {} bytes, {:.2f} s\n",
                                command.out, lines, lines == 1 ? "" : "s", values.size(),
                                values.size() == 1 ? "" : "s", text.size(), took.count());
    if (lines == 0)
        streams.talk << "trivar: no line is seen; the level may be beyond the volume's values\n";
    if (command.certified >= 0)
        streams.talk << fmt::format(
            "trivar: nothing larger than 1/{} voxel is missing but for what {} boxes of that size "
            "may hide\n",
            1 << command.certified, drawing.open);
    return Status::done;
}

} // namespace trivar
