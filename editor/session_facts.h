// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene_file.h"

#include <string>
#include <vector>

namespace trivar {

// The topics of notices. What is told of one step takes the place of what was told of the one
// before; so with saving.
inline constexpr const char* of_a_step = "step";
inline constexpr const char* of_saving = "saving";

class Session;

// The box round an object, with what is in it if it is a group, or round everything for id 0.
Box bounds_of(const Session& session, Id id);
Box bounds_of(const Session& session, const std::vector<Id>& ids);
// All vertices of these objects, in world space; where there is none, of everything but what is
// left aside.
std::vector<glm::dvec3> points_of(const Session& session, const std::vector<Id>& ids);
// Whether it is that object or in that group, however deep; everything is in 0.
bool belongs_to(const Document& document, Id id, Id group);
// What the scene is called: its file's name, that of the file it is a copy of, or untitled; and
// the same as the beginning of a new file's name.
std::string title_of(const SceneFile& scene);
std::string stem_of(const SceneFile& scene);
// Whether the scene looks different from frame to frame.
bool moves_in_time(const Document& document);

// What travels, in the order of the outliner's rows.
std::vector<Id> travelling(const Document& document);
// The name in the outliner, or nothing for an id that is gone.
std::string name_of(const Document& document, Id id);

} // namespace trivar
