// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/action.h"
#include "editor/hands/model_tool.h"

#include <string>
#include <vector>

namespace trivar {

class Files;

enum class ModelUse {
    laid,    // along a stroke on something else
    stands,  // others are laid on it
    painted, // copies of it as tiles
};

// A model that comes with the program: what it is called, its file in the folder of models, and
// what it is there for.
struct OwnModel {
    const char *name, *file;
    ModelUse use = ModelUse::laid;
    TileFit fit = {}; // of one that is painted
};
const std::vector<OwnModel>& own_models();
// The file of the model, with its folder.
std::string file_of(const Files& files, const OwnModel& model);
// The model whose file has that name, in whatever folder; null: none.
const OwnModel* own_model_named_as(const Files& files, const std::string& path);

inline constexpr const char* models_menu = "Models"; // a menu of the menu Add

// Their pictures lie in a folder of this name beside those of the samples.
inline constexpr const char* model_pictures = "models";

// One for each of them: adds it to the scene as an import does. Where there is something that it
// can be laid on, the next stroke lays it; Escape leaves it where it stands. Where there is
// something to paint on, a tile brings the tool that paints with it.
void add_model_actions(std::vector<Action>& actions);

} // namespace trivar
