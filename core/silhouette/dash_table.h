// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field/field_hulls.h"
#include "core/silhouette/silhouettes.h"

namespace trivar {

// A DashTable finds silhouettes as the thesis does (chapter 7), to compare with. A table is made
// for a level: each cell that the level may cross has a cone that holds the gradients in it, and
// stands in the rows of all directions that the cone comes near. A view takes the rows that are
// perpendicular to it, and each of their cells gives a dash of about its length where Newton's
// method comes to a place of the silhouette in it. The dashes are not connected, and a cell with
// two pieces of silhouette gives one.
class DashTable {
public:
    static constexpr int usual_rows = 256;

    // `rows` directions are spread over the sphere; more rows are longer to make and faster to
    // look up. 2 us per cell. Throws Rejected for a field that is not cubic.
    DashTable(const ScalarField<float>& field, const FieldHulls& hulls, float level,
              int rows = usual_rows);

    // The dashes of a view, each a curve of two points. Throws Rejected for a view from an eye.
    Silhouettes operator()(const ScalarField<float>& field, const ViewPoint& view) const;

    std::size_t cells() const { return cones_.size(); }
    std::size_t entries() const { return cells_.size(); } // of all rows together
    std::size_t candidates(const ViewPoint& view) const;  // cells that a view looks at
    std::size_t bytes() const;

private:
    struct Cone {
        glm::ivec3 cell;
        glm::vec3 axis;
        float half_angle; // pi: all directions
    };
    std::vector<std::uint32_t> candidate_cells(const glm::dvec3& sight) const; // ascending

    float level_;
    float covering_; // the greatest angle between a direction and the nearest row
    std::vector<Cone> cones_;
    std::vector<glm::vec3> rows_;
    std::vector<std::uint32_t> first_, cells_; // by row: the cells that stand in it
};

} // namespace trivar
