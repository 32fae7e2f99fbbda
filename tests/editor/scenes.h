// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/objects/arrange.h"
#include "core/commands/objects/group.h"
#include "core/commands/objects/import.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/objects/refine.h"
#include "core/commands/objects/view.h"
#include "core/commands/placement/place.h"
#include "core/commands/placement/travel.h"
#include "core/scene/log.h"
#include "core/scene/scene_file.h"

#include <string>

namespace trivar::testing {

// Scenes that panels must bear, each made by commands.
struct NamedScene {
    std::string name;
    SceneFile (*make)();
};

inline SceneFile empty_scene()
{
    return {};
}

// A stroke over what lies in the middle.
inline Place placed(Id object, Id onto)
{
    Place place;
    place.object = object;
    place.sketch.camera.eye = {0.5, -6, 4};
    for (int i = 0; i < 20; ++i)
        place.sketch.samples.push_back({{500 + 15 * i, 360 + 3 * (i % 5)}, 0.02 * i, 1});
    place.parameters.fill = 0.4;
    place.onto = {onto};
    return place;
}

// A teapot laid over a table, as the text of a scene.
inline std::string scene_text()
{
    AddBox table;
    table.shape.size = {4, 4, 0.5};
    AddTeapot pot;
    pot.shape = {.height = 0.3, .resolution = 4};
    Sketch sketch;
    sketch.camera.eye = {0, -4, 4};
    for (int i = 0; i < 9; ++i) sketch.samples.push_back({{440 + 50 * i, 360}, 0.1 * i, 1});
    return log_header() + command_line(table) + command_line(pot) +
           command_line(Place{2, sketch, {}, {1}});
}

// A table with a box that travels on it, a group, a hidden and a locked object.
inline SceneFile typical_scene()
{
    SceneFile scene;
    AddPlane plane;
    plane.shape.size = {6, 6};
    scene.run(plane);
    AddBox box;
    box.shape.size = {1.2, 0.3, 0.3};
    scene.run(box);
    scene.run(AddSphere{});
    scene.run(AddTorus{});
    scene.run(Group{.objects = {3, 4}, .name = "Round things"});
    scene.run(Hide{{4}});
    scene.run(Lock{{1}});
    scene.run(placed(2, 1));
    scene.run(SetTravel{{2}, {.speed = 0.2, .ends = Ends::loop}});
    return scene;
}

// Files that are gone, and a stroke that misses what it was laid on.
inline SceneFile broken_scene()
{
    SceneFile scene = typical_scene();
    for (const char* path : {"gone.obj", "elsewhere/also gone.glb"}) {
        ImportModel import;
        import.file.path = path;
        import.name = path;
        scene.run(import);
    }
    scene.run(SetTransform{1, {.translation = {500, 500, 0}}});
    return scene;
}

inline SceneFile scene_of_1000_objects()
{
    SceneFile scene;
    for (int i = 0; i < 1000; ++i) {
        AddBox box;
        box.name = "Box number " + std::to_string(i);
        box.shape = {{0.3, 0.3, 0.3}, {1, 1, 1}};
        box.transform.translation = {i % 40 - 20, i / 40 - 12, 0};
        scene.run(box);
    }
    return scene;
}

inline SceneFile scene_of_10000_steps()
{
    SceneFile scene;
    scene.run(AddBox{});
    for (int i = 1; i < 10000; ++i) scene.run(SetTransform{1, {.translation = {0.001 * i, 0, 0}}});
    return scene;
}

inline SceneFile scene_of_long_names()
{
    std::string words;
    while (words.size() < 300) words += "a name that goes on and on ";
    words.resize(300);
    SceneFile scene;
    AddPlane plane;
    plane.name = words;
    scene.run(plane);
    AddBox box;
    box.name = std::string(300, 'W');
    scene.run(box);
    scene.run(Group{.objects = {1}, .name = std::string(300, 'g')});
    scene.run(Rename{2, std::string(300, 'M')});
    scene.run(SetTransform{2, {.translation = {1, 2, 3}}});
    scene.run(placed(2, 1));
    scene.run(SetTravel{{2}, {.speed = 123.456, .ease_in = 0.125}});
    scene.run(Refine{{2}, {.tolerance = 1e-4, .budget = 12}});
    ImportModel import;
    import.file.path = words + ".obj";
    import.name = words;
    scene.run(import);
    KeepView camera;
    camera.name = words;
    scene.run(camera);
    return scene;
}

} // namespace trivar::testing
