// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the pictures of docs/manual anew: each is the editor, without a screen, in the state that
// the page speaks of. Without arguments all of them, else those that are named.

#include "core/commands/objects/animate.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/shape.h"
#include "core/commands/objects/view.h"
#include "core/commands/placement/place.h"
#include "core/commands/placement/travel.h"
#include "core/files/pictures/image.h"
#include "core/placement/placement.h"
#include "editor/actions/help_actions.h"
#include "editor/panels/help/welcome.h"
#include "editor/panels/inspector/profile_rows.h"
#include "editor/picture/volume_surface.h"
#include "tests/editor/rig.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace trivar {
namespace {

using namespace std::chrono_literals;

const std::string checkout = TRIVAR_SOURCE_DIR;

struct Window : testing::Rig {
    explicit Window(glm::ivec2 size = {1200, 750}, float scale = 1) : Rig(size, {.scale = scale})
    {
        editor.preferences.quality = "high";
        editor.preferences.hints = false;
        editor.preferences.show_timing = false; // the times of whatever machine draws them
        for (const auto& each : std::filesystem::directory_iterator(checkout + "/assets/scenes"))
            editor.files.samples.push_back(each.path());
        std::ranges::sort(editor.files.samples);
        editor.memory.of<SamplePictures>().folder = checkout + "/docs/gallery";
        add_tutorials(editor, {checkout + "/assets/tutorials/first_stroke.trivar"});
        frames();
    }
    void open(const std::string& scene)
    {
        bool opened = false;
        editor.files.open_copy(checkout + "/assets/scenes/" + scene + ".trivar",
                               [&] { opened = true; });
        for (int i = 0; i < 6000 && !opened; ++i) work();
        finish();
        editor.session.selected = 0;
    }
    void select(const std::string& name) { editor.session.selected = named(name); }
    Id named(const std::string& name) const
    {
        for (const auto& [id, each] : editor.session.document().objects)
            if (each->name == name) return id;
        throw std::runtime_error("no object is called " + name);
    }
    void run(const Command& command)
    {
        if (!editor.session.run(command)) throw std::runtime_error("a command was refused");
        finish();
    }
    void act(const std::string& name) { action(editor, name).run(editor); }
    // Until nothing is read, evaluated or drawn any more; how long it took is nobody's business.
    void finish()
    {
        for (int i = 0; i < 6000; ++i) {
            work();
            if (editor.session.up_to_date() && !editor.session.jobs().status() &&
                !editor.session.quiet_jobs().status() && !editor.stored_pictures.reading())
                break;
        }
        editor.adjustment = {};
        editor.session.notices.clear();
        screen.settle(body(), 600);
    }
    Image taken(const ui::Rect& part)
    {
        finish();
        const Image whole = screen.picture();
        const glm::ivec2 lo(part.lo), hi(part.hi);
        Image image{
            .name = "picture", .size_px = hi - lo, .rgba = {}, .source_bytes = {}, .mime = {}};
        for (int y = lo.y; y < hi.y; ++y) {
            const auto row = whole.rgba.begin() + 4 * (std::ptrdiff_t{y} * whole.size_px.x + lo.x);
            image.rgba.insert(image.rgba.end(), row, row + 4 * std::ptrdiff_t{image.size_px.x});
        }
        return image;
    }
    Image taken() { return taken({{0, 0}, glm::vec2(size_px)}); }

private:
    void work()
    {
        frames(1);
        std::this_thread::sleep_for(5ms);
    }
};

Image start()
{
    Window window({1440, 900});
    for (int i = 0; i < 40; ++i) { // the samples' pictures are read beside
        window.frames(2);
        std::this_thread::sleep_for(50ms);
    }
    return window.taken();
}

Image place()
{
    Window window;
    window.open("first_placement");
    window.select("Snake");
    const Id snake = window.editor.session.selected;
    EditPlacement edit{
        snake, object(window.editor.session.document(), snake).stroke->parameters, {}, {}};
    edit.parameters.offset = 0; // so that it folds nowhere
    edit.parameters.width_profile = {{0, 0.5}, {0.5, 1.3}, {1, 0.5}};
    window.run(edit);
    window.act("Place");
    window.editor.session.selected = snake;
    return window.taken();
}

// Only that of the selected object is shown.
void without_volumes(Window& window)
{
    RenderSettings settings = *window.editor.session.document().render;
    settings.volumes = false;
    window.run(SetRender{settings});
}

Image profiles()
{
    Window window({1440, 1000});
    window.open("variable_width");
    without_volumes(window);
    window.select("Bulldozer, between");
    const Id id = window.editor.session.selected;
    EditPlacement edit{id, object(window.editor.session.document(), id).stroke->parameters, {}, {}};
    edit.parameters.height_across = {{0, 0.8}, {0.5, 1.25}, {1, 0.8}};
    edit.parameters.rise_profile = {{0, 0}, {0.5, 0.38}, {1, 1}};
    window.run(edit);
    return window.taken();
}

// The tool of that name over the crocodile's volume, seen from the side.
void shape_crocodile(Window& window, const std::string& tool)
{
    window.open("crocodile_pressed");
    without_volumes(window);
    window.select("Crocodile");
    window.run(Unshape{window.editor.session.selected, {}});
    window.act(tool);
    window.finish();
}

// Where a point of the selected volume is seen.
glm::vec2 on_volume(const Window& window, const glm::dvec3& uvw)
{
    const auto& objects = window.editor.session.evaluated().objects;
    const Placement& placement = *objects.at(window.editor.session.selected)->placement;
    return window.seen_at(evaluate(placement.volume, uvw).value);
}

Image press()
{
    Window window;
    shape_crocodile(window, "Press");
    window.editor.active_tool().resize(window.editor.session, 0.6);
    const glm::vec2 at = on_volume(window, {0.4, 0.5, 1});
    window.draw({at, at + glm::vec2(0, 34)});
    window.finish();
    window.move(on_volume(window, {0.4, 0.5, 1}));
    return window.taken();
}

Image lattice()
{
    Window window;
    window.open("lattice_bend");
    without_volumes(window);
    window.select("Lattice");
    window.act("Lattice");
    const glm::vec2 at = on_volume(window, {0, 0.5, 0.8});
    window.draw({at - glm::vec2(60, 60), at + glm::vec2(60, 60)});
    window.finish();
    return window.taken();
}

Image heights()
{
    Window window({1440, 1000});
    window.open("cube_refined");
    window.select("By curvature");
    const Id id = window.editor.session.selected;
    EditPlacement edit{id, object(window.editor.session.document(), id).stroke->parameters, {}, {}};
    edit.parameters.height_map = {
        {0.7, 0.7, 0.7}, {0.7, 1.6, 0.7}, {0.7, 2.2, 0.7}, {0.7, 1.6, 0.7}, {0.7, 0.7, 0.7}};
    window.run(edit);
    window.editor.memory.of<ChosenPoints>().map = 7;
    return window.taken();
}

Image history()
{
    Window window;
    window.open("stacked");
    window.editor.tab = Editor::Tab::history;
    return window.taken();
}

Image stretch()
{
    Window window;
    window.open("crocodile_on_horse");
    RenderSettings settings = *window.editor.session.document().render;
    settings.color_by = ColorBy::stretch;
    window.run(SetRender{settings});
    window.act("Frame all");
    return window.taken();
}

Image timeline()
{
    Window window;
    window.editor.preferences.timeline_open = true;
    window.open("ants");
    const double fast = 0.25;
    window.run(SetTravel{{2}, {.speed = fast, .ends = Ends::loop}});
    window.run(SetTravel{{3}, {.speed = fast, .ends = Ends::loop, .start_frame = 25}});
    window.run(SetTravel{{4}, {.speed = fast, .ends = Ends::loop, .duration = 5}});
    window.run(
        SetTravel{{5}, {.speed = fast, .ends = Ends::loop, .start_frame = 73, .duration = 4}});
    window.select("Ant 3");
    window.editor.session.show_frame(96);
    return window.taken();
}

// A pot that hops, and what its curve has of handles.
Image curves()
{
    Window window;
    window.editor.preferences.timeline_open = true;
    window.editor.preferences.timeline = 296;
    AddPlane table;
    table.name = "Table";
    table.shape.size = {5, 5};
    window.run(table);
    AddTeapot pot;
    pot.name = "Pot";
    pot.shape.height = 0.8;
    pot.material = Surfacing{};
    pot.material->base_color = {0.6f, 0.2f, 0.12f, 1};
    window.run(pot);
    window.run(SetTime{{1, 120, 24}});
    const TrackName rise{2, "transform.translation.z"};
    window.run(
        Animate{{{2,
                  {{rise.parameter, {{1, 0}, {25, 1}, {49, 0}, {73, 0.7}, {97, 0}}, Repeat::once},
                   {"transform.rotation_deg.z", {{1, 0}, {97, 180}}}}}}});
    window.select("Pot");
    window.editor.session.show_frame(36);
    window.finish();
    window.act("Frame all");
    KeysView& view = window.editor.timeline.keys;
    view.curves = true;
    view.tracks = {rise};
    view.chosen = {{rise, 49}};
    return window.taken();
}

Image outliner()
{
    Window window({2048, 1400}, 2);
    window.open("snake_bridge");
    const auto group = [&](const std::string& name, const std::vector<Id>& ids) {
        window.run(Group{.objects = ids, .name = name});
    };
    group("Over the gap", {window.named("Jar A"), window.named("Dodecahedron A"),
                           window.named("Snake, with springs")});
    group("Into the gap", {window.named("Jar B"), window.named("Dodecahedron B"),
                           window.named("Snake, without springs")});
    window.run(Lock{{window.named("Floor")}});
    window.run(Hide{{window.named("Dodecahedron B")}});
    window.select("Snake, with springs");
    window.editor.preferences.outliner = 288;
    return window.taken(window.layout().outliner);
}

Image preferences()
{
    Window window;
    window.open("snake_bridge");
    window.editor.preferences_dialog.open = true;
    return window.taken();
}

Image palette()
{
    Window window;
    window.open("snake_bridge");
    window.editor.palette.show();
    window.frames(8);
    window.type("tra");
    return window.taken();
}

Image move()
{
    Window window;
    window.open("snake_bridge");
    window.editor.choose_tool(1);
    window.select("Jar B");
    return window.taken();
}

struct Picture {
    const char* name;
    Image (*drawn)();
};
constexpr Picture pictures[] = {{"start", start},       {"place", place},
                                {"profiles", profiles}, {"history", history},
                                {"stretch", stretch},   {"timeline", timeline},
                                {"outliner", outliner}, {"preferences", preferences},
                                {"palette", palette},   {"move-rotate-scale", move},
                                {"press", press},       {"lattice", lattice},
                                {"heights", heights},   {"curves", curves}};

} // namespace
} // namespace trivar

int main(int count, char** arguments)
{
    const std::vector<std::string> asked(arguments + 1, arguments + count);
    for (const auto& [name, drawn] : trivar::pictures) {
        if (!asked.empty() && std::ranges::find(asked, name) == asked.end()) continue;
        const std::string path = trivar::checkout + "/docs/manual/" + name + ".png";
        trivar::write_image(drawn(), path);
        std::printf("%s\n", path.c_str());
        std::fflush(stdout);
    }
    return 0;
}
