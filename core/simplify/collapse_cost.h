// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simplify/decimation_values.h"
#include "core/simplify/planes.h"

#include <optional>

namespace trivar {

struct Collapse;
class FanHalfEdges;

// A CollapseCost computes the cost of removing a node; see decimated().
class CollapseCost {
public:
    CollapseCost(const Mesh& mesh, const Fans& fans, const FanHalfEdges& surface,
                 const NodePlaces& places, std::vector<double> tolerance);

    // The cost; empty where the collapse is forbidden or costs at least `best`. O(valence, poses).
    std::optional<double> operator()(const Collapse& c, double best) const;
    void after(const Collapse& c); // the goal now stands for the removed node too

private:
    bool joins_rails(const Collapse& c) const;
    bool ends_a_seam(const Collapse& c) const;
    bool meets_itself(const Collapse& c) const;
    bool touches_twin(int node, int other) const;
    bool keeps_its_sides(const Collapse& c) const;
    bool turns_over(const std::vector<glm::dvec3>& places, const glm::uvec3& nodes, int corner,
                    std::size_t goal) const;
    bool turns_over(const std::vector<glm::vec2>& uv, const glm::uvec3& vertices, int corner,
                    std::uint32_t goal) const;
    void take_planes(std::size_t pose);
    double color_difference(const Collapse& c) const;

    const Mesh& mesh_;
    const Fans& fans_;
    const FanHalfEdges& surface_;
    const NodePlaces& places_;
    std::vector<double> tolerance_;
    bool any_shared_;
    std::vector<std::vector<Planes>> faces_, rails_; // by pose, by node
    double color_metres_ = 0; // the movement as which black in place of white counts
};

} // namespace trivar
