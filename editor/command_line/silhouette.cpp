// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/command_line/silhouette.h"

#include "core/base/memory.h"
#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/document/fields/voxel_fields.h"
#include "core/drawing/drawing_file.h"
#include "core/drawing/hand_edits.h"
#include "core/drawing/line_list.h"
#include "core/files/file_bytes.h"
#include "core/files/sample_models.h"
#include "core/lines/slab_drawing.h"
#include "core/scene_lines/line_sheet.h"
#include "core/stages/voxel_shapes.h"
#include "core/voxels/read_volume.h"
#include "core/voxels/segments.h"
#include "core/voxels/usual_level.h"
#include "editor/command_line/drawing.h"
#include "editor/command_line/silhouette_view.h"

#include <algorithm>
#include <charconv>
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

// The styles that have a name: four of the thesis (chapter 7), and two hands. Their lines have no
// taper, so that those of one width are strokes in the file; but for ink, whose width varies
// anyway.
constexpr std::array<std::string_view, 7> style_names{"plain",  "gradient", "fans", "grey",
                                                      "chroma", "pencil",   "ink"};
LineStyle named_style(const std::string& name)
{
    switch (choice_of<std::size_t>(name, style_names, "style")) {
    case 1: return {.color_by = LineColor::hue_by_slope, .taper = 0};
    case 2: return {.width = 1.2f, .taper = 0, .fan_step = 24, .fan_length = 22};
    case 3:
        return {.width_by = LineWidth::by_slope, .color_by = LineColor::grey_by_slope, .taper = 0};
    case 4: return {.color_by = LineColor::hue_by_depth, .taper = 0};
    case 5: return {.width = 1.6f, .color = {0.17f, 0.17f, 0.19f}, .wobble = 0.6f, .pencil = 0.8f};
    case 6: return {.width = 2.6f, .finest = 0.2f, .width_by = LineWidth::by_bend, .taper = 28};
    default: return {.taper = 0};
    }
}

glm::vec3 color_of(const std::string& text, const char* option)
{
    unsigned value = 0;
    const bool six = text.size() == 6;
    const auto [end, trouble] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
    if (!six || trouble != std::errc() || end != text.data() + text.size())
        throw WrongUsage(
            fmt::format("--{}: \"{}\" is no colour; one is six digits, as ff8000", option, text));
    return glm::vec3(value >> 16, value >> 8 & 0xFF, value & 0xFF) / 255.0f;
}

// The style of a level by its number.
LineStyle style_of(const SilhouetteCommand& command, std::size_t level)
{
    LineStyle out = named_style(command.style);
    if (command.width) out.width = static_cast<float>(*command.width);
    if (command.taper) out.taper = static_cast<float>(*command.taper);
    if (command.width_by)
        out.width_by = choice_of<LineWidth>(*command.width_by, choice_names<LineWidth>, "width-by");
    if (command.color_by)
        out.color_by = choice_of<LineColor>(*command.color_by, choice_names<LineColor>, "color-by");
    out.hidden = choice_of<HiddenLines>(command.hidden, choice_names<HiddenLines>, "hidden");
    if (command.wobble) out.wobble = static_cast<float>(*command.wobble);
    if (command.pencil) out.pencil = static_cast<float>(*command.pencil);
    if (command.fans) out.fan_step = static_cast<float>(*command.fans);
    out.seed = command.seed;
    if (command.paper == "black") out.color = 1.0f - out.color;
    if (!command.colors.empty())
        out.color = color_of(command.colors[std::min(level, command.colors.size() - 1)], "color");
    return out;
}

std::optional<glm::vec3> paper_of(const SilhouetteCommand& command)
{
    if (command.paper == "none") return std::nullopt;
    if (command.paper == "white") return glm::vec3(1);
    if (command.paper == "black") return glm::vec3(0);
    return color_of(command.paper, "paper");
}

MoreLines more_lines_of(const SilhouetteCommand& command)
{
    MoreLines out{command.suggestive, command.ridges, command.valleys, command.parabolic,
                  command.isophotes};
    out.light = glm::vec3(direction_of(command.light, "light"));
    out.smoothing = static_cast<float>(command.smoothing);
    out.detail = static_cast<float>(command.detail);
    out.amount = static_cast<float>(command.amount);
    return out;
}

// The corners of the box that is drawn, as shares of the grid.
std::optional<std::pair<glm::vec3, glm::vec3>> crop_of(const SilhouetteCommand& command)
{
    if (command.crop.empty()) return {};
    const std::vector<double>& c = command.crop;
    const bool six = c.size() == 6;
    const glm::vec3 low = six ? glm::vec3(c[0], c[1], c[2]) : glm::vec3(0),
                    high = six ? glm::vec3(c[3], c[4], c[5]) : glm::vec3(0);
    if (!glm::all(glm::lessThan(low, high)) ||
        !glm::all(glm::greaterThanEqual(low, glm::vec3(0))) ||
        !glm::all(glm::lessThanEqual(high, glm::vec3(1))))
        throw WrongUsage(
            "--crop takes six shares of the grid, 0 to 1, the first three below the last "
            "three, such as 0.5,0,0,1,1,1");
    return std::pair(low, high);
}

FieldSpline spline_of(const SilhouetteCommand& command)
{
    return command.smooth ? FieldSpline::smoothing : FieldSpline::interpolating;
}

// The names of the layers of levels, of which no two have one id in a file.
std::vector<std::string> layer_names(const SilhouetteCommand& command, std::size_t levels)
{
    std::vector<std::string> out = command.names;
    out.resize(std::min(out.size(), levels));
    while (out.size() < levels) out.push_back(fmt::format("level {}", out.size() + 1));
    return names_apart(std::move(out));
}

// The bodies of these levels that hold the others, of samples.
SampleBody outermost(const SilhouetteCommand& command, const VoxelGrid& grid,
                     const std::vector<double>& values)
{
    const double value = command.below ? std::ranges::max(values) : std::ranges::min(values);
    return {grid.sample(value), command.below != (grid.slope > 0)};
}

SilhouetteAim aim_of(const SilhouetteCommand& command)
{
    return {command.view, command.up, command.fov_deg, picture_size(command.size),
            command.whole_grid};
}

std::size_t per_slice(const glm::ivec3& size)
{
    return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
}

LineOptions options_of(const SilhouetteCommand& command, EditedLineIds& ids)
{
    LineOptions out;
    out.ids = [&](const std::string&, const std::string& layer) -> LineIds& { return ids(layer); };
    out.levels_hide_each_other = command.hide_each_other;
    out.certified_depth = command.certified;
    out.dash_rows = command.dashes;
    return out;
}

std::uint64_t memory_of(const SilhouetteCommand& command)
{
    constexpr std::uint64_t megabyte = std::uint64_t{1} << 20;
    if (command.memory_mb > 0) return static_cast<std::uint64_t>(command.memory_mb) * megabyte;
    const std::uint64_t all = physical_bytes();
    return all > 0 ? all / 2 : 1024 * megabyte;
}

// A Drawn is the lines of a volume, with the values of its levels.
struct Drawn {
    std::vector<DrawingLayer> layers;
    ProofGaps gaps;
    glm::dmat4 to_metres;
    std::vector<double> values;
};

glm::dvec3 spacing_of(const SilhouetteCommand& command)
{
    const std::vector<double>& mm = command.spacing;
    if (mm.empty()) return glm::dvec3(1);
    if (mm.size() != 3 || !(std::ranges::min(mm) > 0))
        throw WrongUsage("--spacing takes three distances above 0 in mm, such as 0.5,0.5,2");
    return {mm[0], mm[1], mm[2]};
}

// Reads volume data and draws them: as a whole, a box of them, or slab by slab.
class Drawer {
public:
    Drawer(const SilhouetteCommand& command, const Streams& streams, const HandEdits& edits)
        : command_(command),
          streams_(streams),
          edits_(edits)
    {
        field_.spline = spline_of(command);
        field_.blur = command.blur;
        constexpr std::size_t widest_sample = sizeof(float);
        reading_.memory_bytes = memory_of(command);
        reading_.bytes_beside = field_bytes(widest_sample, field_) - widest_sample;
        reading_.coarsen = command.coarsen;
        reading_.spacing = spacing_of(command);
        reading_.if_too_large = TooLarge::head;
    }

    Drawn operator()()
    {
        const auto crop = crop_of(command_);
        ReadVolume read = this->read(reading_);
        const bool fits = read.grid.bytes() > 0;
        std::optional<SampleBox> box;
        if (crop) box = sample_box(read.grid.size, crop->first, crop->second);
        if (!fits && !box) return by_slabs(read);
        if (!fits) read = box_read(read.part, *box);
        say_notices(read.grid);
        const std::vector<double> values = values_of(read.grid);
        return draw(make_ref(std::move(read.grid)), box, values);
    }

private:
    // Draws the levels of data, or of a box of them, as those of a scene.
    Drawn draw(const Ref<VoxelGrid>& grid, const std::optional<SampleBox>& box,
               const std::vector<double>& values) const
    {
        VoxelShape shape{.spline = field_.spline, .blur = field_.blur};
        shape.body = command_.below ? LevelSide::below : LevelSide::above;
        if (box) {
            const glm::vec3 cells(grid->size - 1);
            shape.crop_low = glm::vec3(box->first) / cells;
            shape.crop_high = glm::vec3(box->last) / cells;
        }
        const std::vector<std::string> names = layer_names(command_, values.size());
        for (std::size_t i = 0; i < values.size(); ++i)
            shape.levels.push_back({.name = names[i],
                                    .value = values[i],
                                    .surface = false,
                                    .ink = style_of(command_, i),
                                    .more = more_lines_of(command_)});
        AssetStore::LoadedVolume read;
        read.grid = grid;
        read.summary = make_ref(summary_of(*grid));
        Timings timings;
        EvaluatedObject volume;
        volume.shape = make_ref(VoxelShapes()(shape, read, timings));
        const VoxelGrid& drawn = volume.shape->volume->field->grid();
        SilhouetteView view(aim_of(command_), drawn.to_metres, drawn.size);
        for (int z = 0; z < drawn.size.z; ++z)
            view.see(drawn.samples, static_cast<std::size_t>(z) * per_slice(drawn.size), z,
                     outermost(command_, drawn, values));
        const glm::dmat4 to_metres = drawn.to_metres;
        const LineScene scene{
            {{.effects = make_ref(std::move(volume)), .volume_to_world = glm::dmat4(1)}},
            view.camera()};
        EditedLineIds ids(edits_);
        const SceneLines lines = LineDrawer()(scene, options_of(command_, ids));
        return {drawing_layers(lines, false), lines.gaps, to_metres, values};
    }
    void say_notices(const VoxelGrid& grid)
    {
        for (const std::string& notice : grid.notices)
            streams_.talk << "trivar: " << command_.volume << ": " << notice << "\n";
    }

    // The levels that are asked for, else the usual one of samples.
    std::vector<double> values_of(const VoxelGrid& grid) const
    {
        if (!command_.levels.empty()) return command_.levels;
        const double usual = usual_level(summary_of(grid), grid);
        streams_.talk << fmt::format("trivar: {}: level {} was taken, which parts the values best; "
                                     "--level takes others\n",
                                     command_.volume,
                                     number_text(usual, {.digits = 6, .commas = false}));
        return {usual};
    }

    // Reads a box of samples of the grid, with the samples round it on which its function depends;
    // `box` becomes the box within these.
    ReadVolume box_read(const GridPart& whole, SampleBox& box) const
    {
        const int halo = slab_halo(field_);
        const glm::ivec3 first = glm::max(box.first - halo, glm::ivec3(0)),
                         last = glm::min(box.last + halo, whole.size() - 1), step = whole.step();
        ReadVolumeOptions reading = reading_;
        reading.box = SampleBox{first * step, last * step + step - 1};
        reading.if_too_large = TooLarge::refuse;
        box = {box.first - first, box.last - first};
        return read(reading);
    }
    ReadVolume read(const ReadVolumeOptions& reading) const
    {
        return read_volume(command_.volume, reading, {}, command_.time);
    }

    Drawn by_slabs(const ReadVolume& head)
    {
        const VoxelGrid& grid = head.grid;
        say_notices(grid);
        if (more_lines_of(command_).any() || command_.certified >= 0 || command_.dashes > 0)
            throw Rejected("data that are larger than the memory that may be used (--memory) are "
                           "drawn slab by slab, without further lines, proof or dashes; coarser "
                           "data or a box of them (--coarsen, --crop) may fit");
        const SlabPlan plan =
            slab_plan(grid.size, head.part.bytes_per_sample, field_, reading_.memory_bytes);
        streams_.talk << fmt::format("trivar: {}: drawn in slabs of {} of {} slices, {} MB\n",
                                     command_.volume, plan.slices, grid.size.z, plan.bytes >> 20);
        std::vector<double> values = command_.levels;
        if (values.empty()) {
            ReadVolumeOptions coarse = reading_;
            coarse.if_too_large = TooLarge::coarsen;
            values = values_of(read(coarse).grid);
        }
        const bool above = command_.below != (grid.slope > 0);
        const std::vector<std::string> names = layer_names(command_, values.size());
        std::vector<SlabLevel> levels;
        for (std::size_t i = 0; i < values.size(); ++i) {
            levels.push_back({.name = names[i],
                              .level = static_cast<float>(grid.sample(values[i])),
                              .side = above ? LevelSide::above : LevelSide::below,
                              .style = style_of(command_, i),
                              .amount = static_cast<float>(command_.amount)});
            if (levels.back().style.fan_step > 0)
                throw Rejected("data that are larger than the memory that may be used (--memory) "
                               "are drawn without fans");
        }
        const SliceReader slices = [&](const auto& each) {
            ReadVolumeOptions reading = reading_;
            reading.each_slice = each;
            reading.if_too_large = TooLarge::refuse;
            reading.bytes_beside = 0;
            read(reading);
        };
        SilhouetteView view(aim_of(command_), grid.to_metres, grid.size);
        if (!command_.whole_grid) {
            const SampleBody body = outermost(command_, grid, values);
            slices(
                [&](int z, const VoxelGrid::Samples& samples) { view.see(samples, 0, z, body); });
        }
        EditedLineIds ids(edits_);
        LevelDrawing drawing = draw_levels_by_slabs(
            plan, field_, slices, levels, drawing_view(view.camera(), grid.to_metres, grid.size),
            {.hide_each_other = command_.hide_each_other, .ids = std::ref(ids)});
        return {std::move(drawing.layers), drawing.gaps, grid.to_metres, values};
    }

    const SilhouetteCommand& command_;
    const Streams& streams_;
    const HandEdits& edits_;
    VoxelFieldOptions field_;
    ReadVolumeOptions reading_;
};

HandEdits edits_in(const std::string& path)
{
    try {
        return read_hand_edits(read_bytes(path, most_edited_bytes));
    } catch (const Rejected& rejected) {
        throw Rejected(path + ": " + rejected.what());
    }
}

// Gives a label map with named segments, and without levels, a smooth level for each segment.
SilhouetteCommand with_segments(SilhouetteCommand command, const Streams& streams)
{
    const std::vector<VolumeSegment> segments = segments_of(command.volume);
    if (segments.empty() || !command.levels.empty()) return command;
    for (const VolumeSegment& each : segments) {
        command.levels.push_back(each.level);
        if (command.names.size() < command.levels.size()) command.names.push_back(each.name);
    }
    command.smooth = true;
    streams.talk << "trivar: " << command.volume
                 << ": its segments are drawn as levels, each with those of higher labels in it: "
                 << fmt::format("{}", fmt::join(command.names, ", ")) << "\n";
    return command;
}

void say_proof(const SilhouetteCommand& command, const ProofGaps& gaps, const Streams& streams)
{
    streams.talk << fmt::format(
        "trivar: {}nothing larger than 1/{} voxel is missing but for what {} boxes of that size "
        "may hide; {} loose end{}\n",
        command.amount < 1 ? "before a share of the lines was taken, " : "", 1 << command.certified,
        with_commas(gaps.open), gaps.loose_ends, gaps.loose_ends == 1 ? "" : "s");
}

} // namespace

Status run_silhouette(const SilhouetteCommand& typed, const Streams& streams)
{
    const SilhouetteCommand command = with_segments(typed, streams);
    // Reports faults of the options before anything is read.
    for (std::size_t i = 0; i <= command.colors.size(); ++i) style_of(command, i);
    direction_of(command.view, "view");
    direction_of(command.light, "light");
    const std::optional<glm::vec3> paper = paper_of(command);
    crop_of(command);
    spacing_of(command);
    const DrawingFormat format = drawing_format(command.out);
    if (command.certified >= 0 && command.dashes > 0)
        throw WrongUsage("--certified: lines in dashes (--dashes) have no proof; leave one out");
    HandEdits edits;
    if (!command.edited.empty()) edits = edits_in(command.edited);
    make_sample_model(command.volume);
    const auto start = std::chrono::steady_clock::now();
    Drawn drawn = Drawer(command, streams, edits)();
    DrawingSheet drawing{std::move(drawn.layers), picture_size(command.size), paper,
                         drawn.to_metres};
    const AppliedEdits edited = apply(edits, drawing);
    const std::string text = drawing_bytes(drawing, format);
    write_bytes(command.out, text);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    std::size_t lines = 0;
    for (const DrawingLayer& layer : drawing.layers) lines += layer.lines.size();
    streams.talk << fmt::format("trivar: {}: {} line{} of {} level{}, {} bytes, {:.2f} s\n",
                                command.out, with_commas(lines), lines == 1 ? "" : "s",
                                drawn.values.size(), drawn.values.size() == 1 ? "" : "s",
                                with_commas(text.size()), took.count());
    if (lines == 0)
        streams.talk << "trivar: no line is seen; the level may be beyond the volume's values\n";
    if (!command.edited.empty())
        streams.talk << "trivar: " << command.edited << ": " << words_of(edited) << "\n";
    if (command.certified >= 0) say_proof(command, drawn.gaps, streams);
    return Status::done;
}

} // namespace trivar
