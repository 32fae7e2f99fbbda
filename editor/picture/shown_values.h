// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluation/evaluate.h"

#include <map>
#include <optional>
#include <tuple>

namespace trivar {

// ShownValues gives the numbers that colours show at the vertices of deformed parts. They are
// computed once per part and kept as long as the part. Null for a part that is not deformed.
class ShownValues {
public:
    // The change of volume, relative to its median in that mesh.
    Ref<std::vector<float>> stretch_of(const Part& part);
    // The greatest certified bound of the triangles at a vertex, divided by the tolerance. Where
    // the object is not refined its triangles are bounded now, in some 3 us each. Null also where
    // the tolerance is finer than any certificate can be.
    Ref<std::vector<float>> error_of(const EvaluatedObject& object, std::size_t part,
                                     const Refining& refining);

private:
    // The key beside the part; a tolerance of 0 means the stretch.
    using By = std::tuple<double, BoundMethod, RefinementRule>;
    Ref<std::vector<float>> kept(const Part& part, const By& by, auto&& work_out);
    struct KnownValues {
        std::weak_ptr<const Deformation> alive;
        Ref<std::vector<float>> values;
    };
    std::map<std::pair<const Deformation*, By>, KnownValues> known_;
};

// The range of shown errors, relative to the tolerance, as log2: from an eighth to eight times.
inline constexpr glm::vec2 shown_errors(-3, 3);

// The tolerance of all visible objects that lie in a volume; empty where they differ. An object
// without a tolerance counts with that of a new refinement.
std::optional<double> shown_tolerance(const Document& document);

} // namespace trivar
