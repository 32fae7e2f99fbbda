// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"
#include "core/simplex/simplex_basis.h"

#include <memory>
#include <span>

namespace trivar {

// DisplacedPoints are the images of the points bound to a volume.
struct DisplacedPoints {
    std::vector<glm::vec3> positions;
    std::vector<glm::mat3> jacobians; // empty unless the rows have gradients
};

// SimplexRows binds points to a basis: the values of all functions at each of them, and where
// `gradients` the gradients, kept so that moving control points costs one sparse product,
//
//   F(x) = x + sum_b N_b(x) d_b,    J(x) = I + sum_b d_b grad N_b(x)^T
//
// with displacements d_b. Eight points that are near each other share one list of control points:
// about 5 bytes per function and point, or 17 with gradients. Points outside of the domain where
// no function reaches stay where they are, to the bit. Equal points get equal bits.
class SimplexRows {
public:
    SimplexRows() = default; // of no points
    // Binds points to one or more layers. Functions of further layers are added to those of the
    // first one; their control points count on.
    //   layers     at least one
    //   points     in the domain's space
    //   gradients  whether displaced() gives Jacobians
    // About 4 us per point for degree 2. The same bits for any number of threads.
    SimplexRows(std::span<const Ref<SimplexBasis<3>>> layers, std::span<const glm::vec3> points,
                bool gradients);

    std::size_t point_count() const { return points_.size(); }
    std::size_t bytes() const;
    // Number of bound points at which the functions of the first layer do not sum to 1 (to 1e-6).
    std::size_t outside() const;

    // `displacements` has one per control point. At most the reading of the rows: 250 bytes per
    // point for degree 2.
    DisplacedPoints displaced(std::span<const glm::dvec3> displacements,
                              DisplacedPoints reuse = {}) const;

private:
    struct Block {                  // of 8 points
        std::uint32_t begin, count; // in functions; weights has 8 or 32 numbers for each
    };
    struct Chunk { // of up to 4096 points
        std::vector<Block> blocks;
        std::vector<std::uint32_t> functions;
        std::vector<float> weights;
        std::size_t outside = 0;
    };
    static Chunk bound(std::span<const Ref<SimplexBasis<3>>> layers,
                       std::span<const glm::vec3> points, std::span<const std::uint32_t> order,
                       bool gradients);

    std::vector<glm::vec3> points_;
    std::vector<std::uint32_t> order_; // of points, by place
    std::vector<Chunk> chunks_;
    bool gradients_ = false;
};

} // namespace trivar
