// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"

#include <glm/glm.hpp>
#include <vector>

namespace trivar {

struct SectionBody {
    const Mesh* mesh = nullptr;
    glm::dmat4 to_world{1};
};

// The plane that cuts a body. Metres, in the world.
struct SectionPlane {
    glm::dvec3 p{0}, normal{0, 0, 1}; // unit
    glm::dvec3 first{1, 0, 0};        // the way begins where the body is seen in this direction
};

// A Section is a closed way round a body where a plane cuts it, and the body's surface to both
// sides of it: the cuts of parallel planes, each drawn taut, so that hollows are bridged.
// Deterministic for any number of threads.
class Section {
public:
    // A line of the surface across the way, from right to left: the places, and how far each is
    // from the way along the line.
    struct Column {
        std::vector<glm::dvec3> places;
        std::vector<double> across;
    };

    // Throws Rejected where the plane does not cut the bodies, which must outlive this.
    // O(#corners + n log n) for n edges that are cut.
    Section(const std::vector<SectionBody>& bodies, const SectionPlane& plane);
    double length() const { return lengths_.back(); } // of the way, once round
    // Cuts it to both sides too, up to planes at that distance, metres. The same cost.
    void widen(double reach);
    // Returns the column at a share, 0..1, of the length, counter-clockwise about the normal.
    Column column(double share) const;

private:
    struct Cut { // by one plane: convex, counter-clockwise about the normal
        std::vector<glm::dvec2> hull;
        glm::dvec2 middle{0};
        double height = 0; // over the plane
        double radius(double angle) const;
    };
    std::vector<Cut> cuts_at(const std::vector<double>& heights) const;
    glm::dvec3 place(const Cut& cut, double angle) const;

    std::vector<SectionBody> bodies_;
    glm::dvec3 p_, right_, up_, normal_; // right and up span the plane
    std::vector<Cut> cuts_;              // ascending, with the one of the plane itself
    std::size_t own_ = 0;                // which
    std::vector<double> lengths_;        // from angle 0, at equal angles
};

// The place of a column so far across; throws Rejected where it ends before.
glm::dvec3 place_at(const Section::Column& column, double across);

} // namespace trivar
