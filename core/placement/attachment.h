// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/placement_input.h"

#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

namespace trivar {

// An object that a stroke was drawn on, and how it stood then: its own space has these axes and
// this origin in the space in which the stroke was drawn.
struct AttachedHost {
    int object = 0;
    glm::dvec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, origin{0};
    // Whether the strip lies on it. A host that it only passes counts while it stays where it was
    // relative to those under the strip.
    bool touched = true;
    glm::dmat4 stood() const;
    bool operator==(const AttachedHost&) const = default;
};
AttachedHost attached_host(int object, const glm::dmat4& stood, bool touched);

// An AttachedSample is the place where a sample of a stroke met its host.
struct AttachedSample {
    int host = -1;            // in the list of hosts; -1: the sample met nothing
    int mesh = 0, member = 0; // of the host, as in PartKey
    glm::dvec3 rest{0};       // on that mesh before a pose or a volume moves its vertices
    glm::dvec3 drawn{0};      // in the host's own space, where the stroke was drawn
    glm::dvec3 normal{0};     // of the face there, unit
    bool operator==(const AttachedSample&) const = default;
};

// An Attachment lists the hosts of a stroke, which carry it with its volume and its model.
struct Attachment {
    std::vector<AttachedHost> hosts;
    std::vector<AttachedSample> samples = {}; // one a sample of the stroke; none: all belong to the
                                              // first host, as it stands
    bool operator==(const Attachment&) const = default;
};

// The host of most samples, the first of equals; of none: the first that is touched.
std::size_t main_host(const Attachment& attachment);

// Whether any host under the strip still exists, and not only objects that the strip passes.
bool carries(const Attachment& attachment);

// The same with other numbers for the objects. Hosts without a number go, and their samples meet
// nothing. Nothing is left: nothing.
std::optional<Attachment> renumbered(const Attachment& attachment,
                                     const std::function<std::optional<int>(int)>& number);

// Throws Rejected, naming the field, for impossible values: no hosts, a host that is flat, a sample
// of no host, another number of samples than the stroke has.
void check(const Attachment& attachment, std::size_t samples);

// Returns the turn and shift that move the points `from` to `to` as closely as possible in least
// squares, never mirrored; no turn if the points do not determine one. As many points each, and
// some. Horn 1987.
glm::dmat4 best_motion(const std::vector<glm::dvec3>& from, const std::vector<glm::dvec3>& to);

// Transform a view, and the lengths of a placement, by a matrix that turns, scales evenly and
// shifts; the picture of the objects moved with them is the same.
Camera carried(Camera camera, const glm::dmat4& by);
PlacementParameters carried(PlacementParameters parameters, const glm::dmat4& by);

// Returns the factor of a matrix that turns, scales evenly and shifts, to about nine digits;
// nothing if it does something else or mirrors.
std::optional<double> even_scale(const glm::dmat4& matrix);

} // namespace trivar
