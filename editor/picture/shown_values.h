// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluation/evaluate.h"

#include <map>
#include <optional>
#include <tuple>

namespace trivar {

// The numbers that colours show at the vertices of what was placed, by parts of objects; worked out
// once for each part and kept as long as that. Null for a part that was not deformed.
class ShownValues {
public:
    // How much the volume changed beside what is usual in that mesh, the median.
    Ref<std::vector<float>> stretch_of(const Part& part);
    // The greatest certified bound of the triangles at a vertex, over the tolerance. Where the
    // object is not refined its triangles are bounded for this call, some 3 us each. Null, too,
    // where the tolerance is finer than anything can be certified to.
    Ref<std::vector<float>> error_of(const EvaluatedObject& object, std::size_t part,
                                     const Refining& refining);

private:
    // What the numbers depend on beside the part; a tolerance of 0 is for the stretch.
    using By = std::tuple<double, BoundMethod, RefinementRule>;
    Ref<std::vector<float>> kept(const Part& part, const By& by, auto&& work_out);
    struct KnownValues {
        std::weak_ptr<const Deformation> alive;
        Ref<std::vector<float>> values;
    };
    std::map<std::pair<const Deformation*, By>, KnownValues> known_;
};

// What colours tell apart, the error over the tolerance by log2: from an eighth to eight times.
inline constexpr glm::vec2 shown_errors(-3, 3);

// The tolerance of all visible objects that lie in a volume; none where they differ. Objects
// without one are measured by that which a refinement has first.
std::optional<double> shown_tolerance(const Document& document);

} // namespace trivar
