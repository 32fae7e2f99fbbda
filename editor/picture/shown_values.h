// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluation/evaluate.h"
#include "core/unwrap/uv_stretch.h"
#include "editor/picture/picture_lines.h"
#include "editor/picture/tetrahedra_picture.h"

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

    // Returns the change of angles or areas by the UVs of a part, relative to the mean of the
    // object's parts. Null if it has none, and for tiles.
    Ref<std::vector<float>> uvs_of(const EvaluatedObject& object, std::size_t part,
                                   UvMeasure measure);
    PictureLines lines; // of objects that are drawn in lines, and of volume data
    TetrahedraLines tetrahedra_lines;

    // Returns so many materials, all with a checkered texture.
    Ref<std::vector<Material>> checkered(std::size_t count);

private:
    // The key beside the part; a tolerance of 0 means the stretch.
    using By = std::tuple<double, BoundMethod, RefinementRule>;
    Ref<std::vector<float>> kept(const Part& part, const By& by, auto&& work_out);
    struct KnownValues {
        std::weak_ptr<const Deformation> alive;
        Ref<std::vector<float>> values;
    };
    std::map<std::pair<const Deformation*, By>, KnownValues> known_;
    struct KnownUvs {
        std::weak_ptr<const Mesh> alive;
        Ref<std::vector<float>> values;
    };
    std::map<std::tuple<const Mesh*, UvMeasure, double>, KnownUvs> uvs_;
    struct KnownAreas {
        std::weak_ptr<const Mesh> alive;
        UvAreas areas;
    };
    std::map<const Mesh*, KnownAreas> areas_;
    std::map<std::size_t, Ref<std::vector<Material>>> checkered_; // by count
};

// The range of shown errors, relative to the tolerance, as log2: from an eighth to eight times.
inline constexpr glm::vec2 shown_errors(-3, 3);
// The range of shown changes of angles, as log2: none to twice.
inline constexpr glm::vec2 shown_uv_angles(0, 1);

// The tolerance of all visible objects that lie in a volume; empty where they differ. An object
// without a tolerance counts with that of a new refinement.
std::optional<double> shown_tolerance(const Document& document);

} // namespace trivar
