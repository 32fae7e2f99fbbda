// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/stages/evaluated.h"

namespace trivar {

// PatternColors gives evaluations in which the patterns that fill objects are colours of vertices
// (core/mesh/filling_colors.h), as files show them. What has no pattern keeps its pointers; what
// was the same object or mesh in two evaluations is so in their results. Tiles with a pattern
// become one mesh. Keeps what it was given while it lives.
class PatternColors {
public:
    Evaluation operator()(Evaluation evaluated);

private:
    Ref<EvaluatedObject> colored(const EvaluatedObject& object);
    void color(Part& part, const Ref<std::vector<Material>>& materials);

    struct Shown { // what a colored mesh was made of
        Ref<Mesh> mesh, at_rest;
        Ref<std::vector<Material>> materials;
        auto operator<=>(const Shown&) const = default;
    };
    // All for lookup only.
    std::map<Ref<EvaluatedObject>, Ref<EvaluatedObject>> objects_;
    std::map<Ref<std::vector<Material>>, Ref<std::vector<Material>>> materials_;
    std::map<Shown, Ref<Mesh>> meshes_;
    std::map<std::pair<Ref<PosedMesh>, Ref<Mesh>>, Ref<PosedMesh>> posed_; // by the colored rest
    std::map<std::pair<Ref<Deformation>, Ref<Mesh>>, Ref<Deformation>> bent_;
};

} // namespace trivar
