// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/deform.h"
#include "core/ffd/part.h"

#include <array>
#include <vector>

namespace trivar {

// The part in a volume; its mesh is deformed when somebody asks for it.
Part in_volume(Part part, const Embedding& embedding, const Ref<Lattice>& volume,
               const Lazy<Deformer>& deformer, const Ref<Part>& inner = nullptr);
// The sorted vertices of a part, for a volume of those axes.
Lazy<Deformer> sorted_into(const Lattice& volume, const Part& part, const Embedding& embedding);

// Bending deforms the same parts again and again while the volume changes its control points, and
// sorts their vertices into its cells only once.
class Bending {
public:
    // Parts that are deformed between begin() and end() are remembered for the next time.
    void begin() { used_.clear(); }
    // `inner` has the meaning of Deformation::inner.
    Part operator()(const Part& part, const Embedding& embedding, const Ref<Lattice>& volume,
                    const Ref<Part>& inner = nullptr);
    void end() { sorted_ = std::move(used_); }

private:
    struct SortedPart {
        Part part;
        Embedding embedding;
        std::array<Knots, 3> axes;
        Lazy<Deformer> deformer;
    };
    std::vector<SortedPart> sorted_, used_;
};

} // namespace trivar
