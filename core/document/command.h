// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"

#include <string_view>
#include <variant>
#include <vector>

// A command is a struct of values with one list of its fields; JSON both ways, the reference in
// docs/commands.md, the default panel and the fuzzer all come from that list. `fields` is called
// with field(name, value, "what it means, unit, range").

namespace trivar {

struct ImportModel {
    static constexpr std::string_view verb = "import", summary = "Add a model from a file.";
    std::string path, hash, name, up = "auto"; // up: auto, y, z
    double scale = 1;
    int subdivisions = 0;
    static void fields(auto& c, auto&& field)
    {
        field("path", c.path, "file, relative to the scene file's folder");
        field("hash", c.hash, "digest of the content that was meant; empty: any");
        field("name", c.name, "name in the outliner; empty: the file's");
        field("up", c.up, "axis that points up in the file: auto, y or z");
        field("scale", c.scale, "file units to metres, above 0");
        field("subdivisions", c.subdivisions, "Catmull-Clark levels, 0..6");
    }
};

// The other commands follow this pattern (verbs): add_plane, add_box, add_sphere, add_cylinder,
// add_torus, add_moebius, add_teapot, transform, set_material, clear_material, rename, hide, show,
// delete, duplicate, group, ungroup, place, edit_placement, unplace, save_camera, delete_camera,
// set_render.

} // namespace trivar
