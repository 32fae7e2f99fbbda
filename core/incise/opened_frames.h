// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/box.h"
#include "core/base/ref_pool.h"
#include "core/incise/flaps.h"

namespace trivar {

// OpenedFrames gives a mesh at one opening after the other, as opened() does, and uses again the
// arrays of meshes that it gave before and that nobody holds any more: those differ only in what
// moves. Then a frame costs O(#terms + #walls), whatever the size of the mesh. Its meshes may
// outlive it.
class OpenedFrames {
public:
    explicit OpenedFrames(Ref<IncisedMesh> incised, Ref<IncisedFlaps> flaps = {}); // O(#V)

    struct Frame {
        Ref<Mesh> mesh; // the original itself while all incisions are shut
        Box box;        // round the mesh's vertices
    };
    // `lifts`: of the flaps, units of the mesh.
    Frame operator()(std::span<const IncisionOpening> openings,
                     std::span<const double> lifts = {}) const;

private:
    Ref<IncisedMesh> incised_;
    Ref<IncisedFlaps> flaps_; // null: none
    Box shut_, still_;        // of the original, and of the vertices that nothing moves
    std::shared_ptr<RefPool<Mesh>> meshes_ = std::make_shared<RefPool<Mesh>>();
};

} // namespace trivar
