// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/model_actions.h"

#include "core/commands/placement/place.h"
#include "editor/actions/lent_tool.h"
#include "editor/editor.h"
#include "editor/words/file_words.h"

#include <algorithm>
#include <filesystem>

namespace trivar {
namespace {

void add_model(Editor& editor, const OwnModel& model)
{
    const auto then = [&editor, use = model.use](Id id) {
        const bool over_something = !possible_bases(editor.session.committed(), id).empty();
        if (!over_something || editor.tutorial.runs(editor.session)) return;
        if (use == ModelUse::laid) lend_place(editor, id);
        if (use == ModelUse::painted) editor.choose_tool("Tiles");
    };
    editor.files.import(file_of(editor.files, model), false, then, model.name);
}

} // namespace

const std::vector<OwnModel>& own_models()
{
    constexpr ModelUse below = ModelUse::stands, tile = ModelUse::painted;
    static const std::vector<OwnModel> all{
        {"Snake", "snake"},
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
        {"Thorn", "tile_thorn", tile},
        {"Flower", "tile_flower", tile},
        {"Scale tile", "tile_scale", tile},
        // Each of its two links reaches over the middle of the next.
        {"Chain link", "tile_chain", tile, {true, 0.112}},
        {"Mail ring", "tile_mail", tile},
        {"Hair", "tile_hair", tile},
        {"Hexagon", "tile_hex", tile},
        {"Feather", "tile_feather", tile},
        {"Leaf", "tile_leaf", tile},
        {"Grass", "tile_grass", tile},
        {"Cobble", "tile_cobble", tile},
        {"Shingle", "tile_shingle", tile},
        {"Stud", "tile_stud", tile},
        {"Rivet", "tile_rivet", tile},
        {"Rope", "tile_rope", tile, {true}},
        {"Braid", "tile_braid", tile, {true}},
        {"Lock of hair", "tile_lock", tile, {true}},
        {"Knit stitch", "tile_knit", tile, {true}},
        {"Small robot", "tile_robot", tile},
        {"Brick", "tile_brick_a", tile},
        {"Half bricks", "tile_brick_b", tile},
        {"Broken brick", "tile_brick_c", tile},
        {"Hollow brick", "tile_brick_hollow", tile},
        {"Statue", "tile_statue", tile}};
    return all;
}

const OwnModel* own_model_named_as(const Files& files, const std::string& path)
{
    const auto own = std::ranges::find_if(own_models(), [&](const OwnModel& each) {
        return file_name(file_of(files, each)) == file_name(path);
    });
    return own != own_models().end() ? &*own : nullptr;
}

std::string file_of(const Files& files, const OwnModel& model)
{
    return (std::filesystem::path(files.own_models_folder) / model.file).string() + ".glb";
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
