// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scenes/commands.h"

#include "core/base/rejected.h"
#include "core/commands/bind.h"
#include "core/commands/cutting/cut.h"
#include "core/commands/cutting/peel.h"
#include "core/commands/cutting/split.h"
#include "core/commands/every_command.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/group.h"
#include "core/commands/objects/import.h"
#include "core/commands/objects/keep_shape.h"
#include "core/commands/objects/line_drawing.h"
#include "core/commands/objects/play.h"
#include "core/commands/objects/refine.h"
#include "core/commands/objects/shade.h"
#include "core/commands/objects/shape.h"
#include "core/commands/objects/simplify.h"
#include "core/commands/objects/text.h"
#include "core/commands/objects/unwrap.h"
#include "core/commands/objects/view.h"
#include "core/commands/objects/voxels.h"
#include "core/commands/placement/apply_shape.h"
#include "core/commands/placement/place.h"
#include "core/commands/placement/travel.h"
#include "core/commands/tiles/heights.h"
#include "core/commands/tiles/mask_tiles.h"
#include "core/commands/tiles/mix_tiles.h"
#include "core/commands/tiles/tiles.h"
#include "core/commands/volumes/convert_lattice.h"
#include "core/commands/volumes/lattice.h"
#include "core/commands/volumes/tetrahedra.h"
#include "core/commands/volumes/warp.h"

#include <limits>

namespace trivar::testing {
namespace {

template <class T> T pick(std::mt19937& random, std::initializer_list<T> values)
{
    return values.begin()[random() % values.size()];
}

double random_number(std::mt19937& random, const Rule& rule)
{
    constexpr double inf = std::numeric_limits<double>::infinity();
    if (random() % 12 == 0)
        return pick(random, {std::nan(""), inf, -inf, 1e308, -1e308, 5e-324, -0.0, 0.0, rule.lo,
                             rule.hi, 2.43e-17, -3e-5, 12345678.9});
    const double lo = std::max(rule.lo, -10.0), hi = std::min(rule.hi, 10.0);
    return lo + (hi - lo) * static_cast<double>(random()) / 4294967295.0;
}

// Not inlined, because g++ would take the values of empty options for uninitialized ones.
template <class T>
[[gnu::noinline]] void randomize(std::mt19937& random, T& value, const Rule& rule)
{
    if constexpr (Nested<T>)
        each_field(value, [&](std::string_view, auto& v, std::string_view, Rule inner = {}) {
            if (random() % 2 == 0) randomize(random, v, inner);
        });
    else if constexpr (std::is_same_v<T, bool>)
        value = random() % 2 == 0;
    else if constexpr (std::is_same_v<T, int>)
        value = random() % 12 == 0 ? pick(random, {std::numeric_limits<int>::min(), -1, 0,
                                                   std::numeric_limits<int>::max()})
                                   : static_cast<int>(random() % 8);
    else if constexpr (std::is_floating_point_v<T>)
        value = static_cast<T>(random_number(random, rule));
    else if constexpr (std::is_enum_v<T>)
        value = static_cast<T>(random() % choice_names<T>.size());
    else if constexpr (std::is_same_v<T, std::string>)
        value = pick<std::string>(random, {"", "front", "a \"quoted\"\\\n name",
                                           "Schnecke \xC3\xA4", "\xFF\xFE", "studio",
                                           std::string(5000, 'x'), std::string("a\0b", 3)});
    else if constexpr (std::is_same_v<T, StrokeSample>) {
        value.p_px = {random_number(random, {}) * 100, random_number(random, {}) * 100};
        value.time_s = random_number(random, {});
        value.pressure = random_number(random, in_range(0, 1));
    } else if constexpr (is_optional<T>) {
        value.reset();
        if (random() % 2 == 0) randomize(random, value.emplace(), rule);
    } else if constexpr (is_list<T>) {
        value.resize(random() % 6);
        for (auto& entry : value) randomize(random, entry, rule);
    } else
        for (int i = 0; i < T::length(); ++i) randomize(random, value[i], rule);
}

ImportModel import_of(const std::string& path)
{
    ImportModel import;
    import.file.path = path;
    return import;
}

} // namespace

Sketch small_sketch()
{
    Sketch sketch;
    sketch.camera.eye = {0, -4, 4};
    for (int i = 0; i < 9; ++i)
        sketch.samples.push_back({{440 + 50 * i, 360 + 5 * (i % 3)}, 0.1 * i, 1});
    return sketch;
}

Document small_document()
{
    Document document;
    for (const Command& command : std::initializer_list<Command>{
             AddBox{.name = "Table", .shape = {.size = {4, 4, 0.5}}, .transform = {}},
             AddSphere{.name = "Ball", .shape = {.radius = 0.4}, .transform = {}},
             AddTeapot{.name = "Pot", .shape = {.height = 0.2, .resolution = 4}, .transform = {}},
             Group{.objects = {1}, .name = "Furniture"},
             Place{.object = 3, .sketch = small_sketch(), .parameters = {}, .onto = {}},
             KeepView{.name = "front", .camera = {}}})
        document = after(document, command);
    return document;
}

TileStroke a_tile_stroke()
{
    TileStroke stroke;
    for (int i = 0; i < 5; ++i) {
        const double angle = 0.2 * i;
        const glm::dvec3 n{std::cos(angle), std::sin(angle), 0};
        stroke.samples.push_back({{0.4 * n, n}, 0.1 * i, 1});
    }
    return stroke;
}

NamedIncision an_incision()
{
    NamedIncision out;
    for (int i = 0; i < 9; ++i) {
        const double angle = 0.1 * i - 0.4;
        const glm::dvec3 n{std::cos(angle), 0, std::sin(angle)};
        out.cut.stroke.push_back({0.4 * n, n});
    }
    out.cut.depth = 0.06;
    out.cut.width = 0.05;
    out.cut.floor = Incision::Floor::through;
    out.cut.piece = Incision::Piece::left_out;
    out.cut.lean_deg = 10;
    out.cut.bevel = 0.004;
    out.cut.roundness = 1;
    return out;
}

NamedIncision a_crossing_incision() // over the first one
{
    NamedIncision out;
    for (int i = 0; i < 9; ++i) {
        const double angle = 0.1 * i - 0.4;
        const glm::dvec3 n{std::cos(angle), std::sin(angle), 0};
        out.cut.stroke.push_back({0.4 * n, n});
    }
    out.cut.depth = 0.04;
    out.cut.width = 0.05;
    out.blade = 2;
    return out;
}

PeeledFlap a_flap()
{
    return {.first = 1,
            .second = 2,
            .side_of_first = IncisionSide::right,
            .side_of_second = IncisionSide::left,
            .lift = 0.03};
}

NamedIncision a_wider_incision() // along the same stroke
{
    NamedIncision out = an_incision();
    out.cut.stroke.clear();
    out.cut.width = 0.1;
    out.opening.share = 0.5;
    return out;
}

Document fitting_document()
{
    const Document document = after(after(small_document(), import_of("snail.obj")), AddText{});
    const Document bent = after(after(document, AddLattice{.objects = {6}}),
                                WarpVolume{.object = 7, .warp = {.taper = 0.5}});
    const Document painted = after(after(bent, AddCylinder{.shape = {.radius = 0.1}}),
                                   PaintTiles{.object = 8, .base = 2, .stroke = a_tile_stroke()});
    const Document heights = after(painted, AddHeights{.shape = {.image = "hills.png"}});
    const Document cut =
        after(heights, CutThrough{.objects = {5}, .cutting = {.cuts = {{.gap = 0.1}}}});
    const Document incised = after(cut, Incise{.object = 5, .incision = an_incision()});
    const Document peeled =
        after(after(incised, Incise{.object = 5, .incision = a_crossing_incision()}),
              PeelFlap{.object = 5, .flap = a_flap()});
    const Document volume =
        after(peeled, AddVoxels{.shape = {.path = "head.nrrd", .levels = {{.value = 3}}}});
    return after(
        after(volume, AddTetrahedra{.objects = {9}, .shape = {.edits = {{.warp = Warp{}}}}}),
        AddSimplexSheet{});
}

std::vector<Command> fitting_commands()
{
    PlacementParameters flat;
    flat.offset = 1;
    return {import_of("snail.obj"),
            EditImport{.object = 5, .file = import_of("shell.obj").file},
            Relink{.objects = {5},
                   .files = {import_of("house.obj").file},
                   .pictures = {{9, 0, "valley.png", {}}},
                   .volumes = {{10, "skull.nrrd", {}}}},
            AddPlane{},
            AddBox{},
            AddSphere{},
            AddCylinder{},
            AddTorus{},
            AddMoebius{},
            AddTeapot{},
            AddText{},
            SetText{.object = 6, .shape = {.text = "Ab"}},
            SetTransform{.object = 2, .transform = {.translation = {0.1, 1.0 / 3, -2e-7}}},
            Arrange{.objects = {2, 1},
                    .transforms = {{.rotation_deg = {0, 30, 0}}, {.scale = {2, 1, 1}}}},
            SetMaterial{.objects = {1, 2}, .surfacing = {.base_color = {0.1f, 0.2f, 0.3f, 1}}},
            ClearMaterial{.objects = {1}},
            Rename{.object = 1, .name = "Desk"},
            Hide{.objects = {1, 2}},
            Show{.objects = {2}},
            Lock{.objects = {1, 2}},
            Unlock{.objects = {2}},
            Delete{.objects = {2}},
            Duplicate{.objects = {3, 4}, .offset = {1, 0, 0}},
            Group{.objects = {2, 3}, .name = "Both"},
            Ungroup{.object = 4},
            Reorder{.objects = {3, 1}, .parent = 0, .before = 2},
            Place{.object = 2, .sketch = small_sketch(), .parameters = {}, .onto = {1}},
            PlaceRound{.object = 3, .around = 2, .level = 0.1, .parameters = {.fill = 0.2}},
            EditPlacement{.object = 3, .parameters = flat, .sketch = {}, .onto = {}},
            Unplace{.object = 3},
            SetTravel{.objects = {3}, .travel = {.speed = 0.5, .ends = Ends::loop}},
            PlayClip{.objects = {5}, .playing = {.clip = "walk", .speed = 0.5}},
            Animate{{{.object = 3,
                      .tracks = {{"transform.scale.x", {{1, 1}, {24, 2, Tween::linear}}},
                                 {"placement.width", {{5, 0.2}}, Repeat::loop}}}}},
            Refine{.objects = {3}, .refining = {.tolerance = 0.01, .split = SplitPoint::midpoint}},
            ClearRefine{.objects = {3}},
            PressVolume{.object = 3, .press = {.samples = {{0.5, 0.5, 1, 0.02}}, .mirror = true}},
            MovePoints{.object = 3, .shift = {.points = {{1, 2, 3}}, .by = {0, 0.01, -0.02}}},
            InsertKnots{.object = 3, .insertion = {.up = {0.25, 0.75}}},
            CoarsenVolume{.object = 3, .coarsening = {.count = 8}},
            MendVolume{.object = 3},
            AllowFolds{.object = 3, .allowance = {{{{0.25, 0, 0}, {0.5, 1, 1}}}}},
            Unshape{.object = 3, .steps = {}},
            copied(fitting_document(), {4, 3, 5}, "/models"),
            KeepView{.name = "side", .camera = {}},
            ForgetView{.name = "front"},
            SetRender{.settings = {.look = "clay"}},
            SetTime{.time = {.first_frame = 0, .last_frame = 99, .frames_per_second = 29.97}},
            AddLattice{.objects = {2}, .shape = {.size = {2, 2, 2}}},
            SetLattice{.object = 7, .shape = {.grid = {4, 4, 6}}},
            ConvertLattice{.object = 7, .pieces = 1},
            AddTetrahedra{.objects = {9}, .shape = {.degree = 3}},
            SetTetrahedra{.object = 11, .shape = {.boxes = {3, 2, 2}, .edits = {{.warp = Warp{}}}}},
            EditTetrahedra{.object = 11, .edit = {.pull = TetrahedraPull{.by = {0.1, 0, 0}}}},
            RemoveTetrahedraEdit{.object = 11, .number = 1},
            AddSimplexSheet{.shape = {.lifts = {SheetLift{}}}},
            SetSimplexSheet{.object = 12, .shape = {.degree = 3}},
            WarpVolume{.object = 7, .warp = {.twist_deg = 30}},
            KeepShape{.object = 7, .members = {6}, .files = {import_of("shell.obj").file}},
            Simplify{{1}, {.keep = 0.25}},
            ClearSimplify{{1}},
            SetWarp{.object = 7, .step = 1, .warp = {.twist_deg = 60}},
            Attach{.object = 3, .attach = Attachment{{attached_host(1, glm::dmat4(1), true)}}},
            SetParent{.objects = {2}, .parent = 1},
            ApplyShape{.object = 3, .file = import_of("pot.glb").file, .tolerance = 0.002},
            PaintTiles{.object = 8, .base = 2, .stroke = a_tile_stroke()},
            EditTileStroke{.object = 8, .number = 1, .stroke = a_tile_stroke()},
            RemoveTileStrokes{.object = 8, .numbers = {1}},
            SetTiles{.objects = {8}, .look = {.height = 2}},
            ClearTiles{.objects = {8}},
            MixTiles{.object = 8, .weight = 2, .others = {{2, 1}}},
            MorphTiles{.object = 8, .into = 2},
            CoverWithTiles{
                .object = 8, .base = 2, .cover = {.pattern = TilePattern::brick, .size = 0.2}},
            MaskTiles{.object = 8, .mask = {.drives = MaskDrives::scale, .low = 0.5}},
            RemoveTileMasks{.object = 8},
            AddHeights{.shape = {.image = "hills.png"}},
            SetHeights{.object = 9, .shape = {.image = "dunes.png"}},
            Displace{.base = 2, .shape = {.image = "hills.png"}},
            AddVoxels{.shape = {.path = "head.nrrd"}},
            SetVoxels{.object = 10, .shape = {.path = "head.nrrd", .blur = 2}},
            Unwrap{.objects = {1}, .unwrapping = {.method = UnwrapMethod::rigid}},
            ClearUnwrap{.objects = {1}},
            Shade{.objects = {1}, .shading = {ShadingWay::by_angle, 20}},
            Split{.objects = {1}, .splitting = {.obstacles = {{2}}}},
            ClearSplit{.objects = {1}},
            CutThrough{.objects = {1}, .cutting = {.cuts = {{.point = {0, 0, 0.2}, .gap = 0.1}}}},
            RemoveCut{.object = 5, .number = 1},
            ClearCuts{.objects = {1}},
            Incise{.object = 2, .incision = an_incision(), .layers = {{.name = "Fat"}}},
            EditIncision{.object = 5, .number = 1, .incision = a_wider_incision()},
            LayerIncisions{.objects = {5}, .incising = {.cuts = {}, .layers = {{.name = "Fat"}}}},
            RemoveIncision{.object = 5, .number = 1},
            ClearIncisions{.objects = {5}},
            SwapIncisions{.object = 5, .first = 1, .second = 2},
            PeelFlap{.object = 5, .flap = {.side_of_first = IncisionSide::right, .lift = 0.0425}},
            LayFlap{.object = 5, .number = 1},
            SetLineDrawing{{1}, {.paper = true, .more = {.suggestive = true}}},
            ClearLineDrawing{{1}},
            Bind{.objects = {8}, .from = {2}, .to = 1}};
}

Command random_command(std::mt19937& random)
{
    const std::vector<Command> all = every_command();
    Command command = all[random() % all.size()];
    try {
        change(command, [&](auto& c) {
            each_field(c, [&](std::string_view, auto& value, std::string_view, Rule rule = {}) {
                if (random() % 4 != 0) randomize(random, value, rule);
            });
        });
    } catch (const Rejected&) { // a copy with two shapes cannot even be written down
    }
    return command;
}

} // namespace trivar::testing
