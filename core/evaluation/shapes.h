// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/timing.h"
#include "core/document/asset_store.h"
#include "core/mesh/extent.h"
#include "core/placement/round.h"
#include "core/text/installed_fonts.h"

namespace trivar {

// What a source gives, subdivided, ready to be drawn or laid.
struct Shape {
    struct Hung {
        Ref<Mesh> rest;
        glm::dmat4 to_model{1};
        Ref<Posed> posed = nullptr; // where a skin or morph targets move the vertices
        int node = 0;               // of the model
        int slot = 0;               // which of its shape's it is, whichever stand in a pose
        Ref<Extent> extent = nullptr;
        Box bounds = {}; // before to_model, as it stands, or larger ones
        const Ref<Mesh>& mesh() const { return posed ? *posed->mesh : rest; }
    };
    std::vector<Hung> meshes; // those that hang on a node
    Ref<Model> model;         // never null
    Ref<std::vector<Material>> materials;
    std::vector<std::string> notices;
    // Why something of it is missing, of those notices: a file that cannot be read, numbers that
    // are too large.
    std::vector<std::string> lacks;
};

// The font of a text, whose file's name may be as from the scene's folder. Throws Rejected where
// there is no font at all.
FoundFont font_of(const TextShape& text, const AssetStore& assets);

// Puts its meshes where the nodes of its model stand; those that would be out of reach go.
void stand(Shape& shape, const Stance& stance);
// The same where a clip of its model has them at that time, or as the model came.
void stand(Shape& shape, const Clip* clip, double time_s);

// Shapes by what they come from: two objects with equal sources share one.
class Shapes {
public:
    explicit Shapes(Ref<AssetStore> assets) : assets_(std::move(assets)) {}

    // Never null; trouble is in the notices, and tried again next time if the file was missing.
    // Throws Cancelled. Stages: import, subdivide, letters.
    Ref<Shape> operator()(const Source& source, Timings& timings, const Progress& progress);
    void forget_unused(); // those that nobody else holds

private:
    Ref<AssetStore> assets_;
    std::vector<std::pair<Source, Ref<Shape>>> known_;
};

} // namespace trivar
