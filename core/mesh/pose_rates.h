// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/gait.h"

#include <optional>

namespace trivar {

// How long a vector is at most, or how large a number, and its derivatives by time.
struct Rates {
    double most = 0, first = 0, second = 0;
    void add(const Rates& other, double times);
};
// Of a vector's direction, where it is no shorter than `least`, more than 0.
Rates direction_of(const Rates& vector, double least);

// How fast what hangs on a node moves, at most, while the time of a clip goes from one moment to
// another with no key between: M x + o of a point x. Units of the model, by seconds.
struct NodeRates {
    double size = 1, turn = 0, bend = 0; // of the matrix, and its derivatives
    double shift = 0, swing = 0;         // the origin's derivatives
    Rates of(const Rates& x) const;      // of M x, and the derivatives of M x + o
};

// Of a node in its parent.
struct LocalRates : NodeRates {
    double origin = 0;  // how far its origin is from the parent's, at most
    bool rigid = false; // it keeps all lengths, times a constant, but for a millionth
};
// By node; nothing where a rotation may be none there, a cubic through 0.
// From the product rule over the tree: a rotation between two keys has a constant angular velocity,
// translations and scales a constant velocity, or the derivatives of a cubic (normalised). O(#nodes
// + #channels log #keys).
std::optional<std::vector<LocalRates>> local_rates(const Model& model, const Clip& clip,
                                                   double from_s, double to_s);
// By node, in the model; or, of a node and what hangs on it, in that node's own space. O(#nodes).
std::vector<NodeRates> node_rates(const Model& model, const std::vector<LocalRates>& local,
                                  int within = -1);

// Of the weights of a node's morph targets, by target.
std::vector<Rates> weight_rates(const Model& model, const Clip& clip, int node, double from_s,
                                double to_s);

// Which foot's leg moves a node, -1: none; by node.
std::vector<int> legs_of_nodes(const Model& model, const Gait& gait);

// The moments between its begin and its end at which the clip, or what is added to a foot, goes on
// otherwise than before; ascending, with both ends. The gait may be null.
std::vector<double> breaks_of(const Clip& clip, const Gait* gait);

} // namespace trivar
