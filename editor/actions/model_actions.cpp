// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/model_actions.h"

#include "core/commands/place.h"
#include "editor/actions/lent_tool.h"
#include "editor/editor.h"

#include <filesystem>

namespace trivar {
namespace {

void add_model(Editor& editor, const OwnModel& model)
{
    const std::filesystem::path folder = editor.files.own_models_folder;
    std::function<void(Id)> then;
    if (model.laid)
        then = [&editor](Id id) {
            const bool over_something = !possible_bases(editor.session.committed(), id).empty();
            if (over_something && !editor.tutorial.runs(editor.session)) lend_place(editor, id);
        };
    editor.files.import((folder / model.file).string() + ".glb", false, std::move(then));
}

} // namespace

const std::vector<OwnModel>& own_models()
{
    constexpr bool below = false;
    static const std::vector<OwnModel> all{{"Snake", "snake"},
                                           {"Crocodile", "crocodile"},
                                           {"Lizard", "reptile"},
                                           {"Ant", "ant"},
                                           {"Horse", "horse"},
                                           {"Camel", "camel"},
                                           {"Whale", "whale"},
                                           {"Robot", "robot"},
                                           {"Car", "car"},
                                           {"Bulldozer", "bulldozer"},
                                           {"Tree", "tree", below},
                                           {"Trunk", "trunk", below},
                                           {"Terrain", "terrain", below},
                                           {"Jar", "jar", below},
                                           {"Bottle", "bottle", below},
                                           {"Goblet", "goblet", below},
                                           {"Thorn", "tile_thorn", below},
                                           {"Flower", "tile_flower", below},
                                           {"Scale tile", "tile_scale", below},
                                           {"Chain link", "tile_chain", below},
                                           {"Mail ring", "tile_mail", below},
                                           {"Hair", "tile_hair", below},
                                           {"Hexagon", "tile_hex", below},
                                           {"Brick", "tile_brick_a", below},
                                           {"Statue", "tile_statue", below}};
    return all;
}

void add_model_actions(std::vector<Action>& actions)
{
    for (const OwnModel& each : own_models())
        actions.push_back({models_menu,
                           each.name,
                           {},
                           [model = each](Editor& e) { add_model(e, model); },
                           {[](const Editor& e) { return !e.files.own_models_folder.empty(); },
                            "the models that come with Trivar are missing"}});
}

} // namespace trivar
