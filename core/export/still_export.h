// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/certificate/certificate.h"
#include "core/export/rigid_tiles.h"

namespace trivar {

// The scene with everything in a volume refined to a tolerance; other settings of refined objects
// stay, except for those that certify nothing.
Document refined_to(Document document, double tolerance);

// An ExportedScene says which scene is exported: its log, and how much of the log.
struct ExportedScene {
    Document document;
    double tolerance = 0; // to which everything is refined; 0: each object's own
    double frame = 1;
    std::string log; // the scene's file; empty: the scene has no name
    int lines = 0;   // of the log, as in Certificate
    // The tolerance, in metres, within which a tile counts as a copy of its unit cell; copies are
    // then nodes with the same mesh, for GlbOptions::instances. None: tiles are one mesh per layer.
    std::optional<double> instances = {};
};
// An Export is the exported model with its claims, which are in the model's extras, too. There are
// claims if something is refined, or a tolerance was asked for.
struct Export {
    Model model;
    std::optional<Certificate> certificate;
    std::vector<RigidCount> tiles; // of layers, if instances were asked for
};
// `evaluated` must come from the document, or from refined_to() of it where there is a tolerance.
Export export_of(const Evaluation& evaluated, const ExportedScene& scene);

} // namespace trivar
