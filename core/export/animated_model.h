// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/certificate/animated_export.h"

namespace trivar {

inline constexpr double default_tolerance = 1e-3; // metres; also of instances

// An AnimatedScene says which scene is exported, and how.
struct AnimatedScene {
    Document document;
    FrameRange frames;
    // metres; 0: the default one, or where things move too fast for that the least of 2 mm, 5 mm,
    // 1 cm and so on that can be certified between the moments
    double tolerance = 0;
    std::string log;        // the scene's file; empty: the scene has no name
    bool whole = false;     // a scene that lacks something throws IncompleteScene
    bool instances = false; // of tiles and copies, in a .usda
};

// The scene as one model that moves by itself, within a tolerance at every time:
//
//   what rests                      a node
//   what moves as it is             a node with keys of its translation, rotation and scale
//   a model's nodes, in no volume   the same nodes, skins and channels below such a node
//   what a volume deforms           morph targets, each the place of all vertices at a key
//   curves in no volume             a node with keys; nothing is claimed of them
//
// Curves that bend in time are left out. What comes and goes hangs on a node whose scale is 1 or 0.
// The same bits for any number of threads. Throws Rejected and Cancelled. See docs/export.md.
AnimatedExport animated_export(const AnimatedScene& scene, const Ref<AssetStore>& assets,
                               const Progress& progress = {});

} // namespace trivar
