// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/model_actions.h"

#include "editor/editor.h"

#include <filesystem>

namespace trivar {

const std::vector<OwnModel>& own_models()
{
    static const std::vector<OwnModel> all{{"Snake", "snake"},     {"Crocodile", "crocodile"},
                                           {"Lizard", "reptile"},  {"Ant", "ant"},
                                           {"Horse", "horse"},     {"Camel", "camel"},
                                           {"Whale", "whale"},     {"Robot", "robot"},
                                           {"Car", "car"},         {"Bulldozer", "bulldozer"},
                                           {"Tree", "tree"},       {"Trunk", "trunk"},
                                           {"Terrain", "terrain"}, {"Jar", "jar"},
                                           {"Bottle", "bottle"},   {"Goblet", "goblet"}};
    return all;
}

void add_model_actions(std::vector<Action>& actions)
{
    for (const OwnModel& each : own_models())
        actions.push_back(
            {models_menu,
             each.name,
             {},
             [file = std::string(each.file)](Editor& e) {
                 e.files.import(
                     (std::filesystem::path(e.files.own_models_folder) / (file + ".glb")).string());
             },
             {[](const Editor& e) { return !e.files.own_models_folder.empty(); },
              "the models that come with Trivar are missing"}});
}

} // namespace trivar
