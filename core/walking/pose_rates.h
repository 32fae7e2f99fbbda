// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/walking/gait.h"

#include <optional>

namespace trivar {

// Rates bound the length of a vector, or the size of a number, and its derivatives by time.
struct Rates {
    double most = 0, first = 0, second = 0;
    void add(const Rates& other, double times);
};
// The rates of a vector's direction, where the vector is at least `least` long, with least above 0.
Rates direction_of(const Rates& vector, double least);

// NodeRates bound how fast a point x that hangs on a node moves, as M x + o, while the time of a
// clip goes from one moment to another with no key between them. Units of the model, seconds.
struct NodeRates {
    double size = 1, turn = 0, bend = 0; // of the matrix, and its derivatives
    double shift = 0, swing = 0;         // the origin's derivatives
    Rates of(const Rates& x) const;      // of M x, and the derivatives of M x + o
};

// LocalRates are the rates of a node in its parent.
struct LocalRates : NodeRates {
    double origin = 0;  // largest distance of its origin from the parent's
    bool rigid = false; // the matrix keeps all lengths, times a constant, except for a millionth
};
// The rates by node; empty where a rotation may vanish at some time (a cubic through 0). They come
// from the product rule over the tree: between two keys a rotation has a constant angular velocity,
// translations and scales have a constant velocity, or the derivatives of a cubic (normalised).
// O(#nodes + #channels log #keys).
std::optional<std::vector<LocalRates>> local_rates(const Model& model, const Clip& clip,
                                                   double from_s, double to_s);
// The rates by node, in the model; with `within`, those of that node and its subtree in its own
// space. O(#nodes).
std::vector<NodeRates> node_rates(const Model& model, const std::vector<LocalRates>& local,
                                  int within = -1);

// The rates of the weights of a node's morph targets, by target.
std::vector<Rates> weight_rates(const Model& model, const Clip& clip, int node, double from_s,
                                double to_s);

// Returns for each node the foot whose leg moves it, or -1 for none.
std::vector<int> legs_of_nodes(const Model& model, const Gait& gait);

// Returns the moments between the begin and the end of a clip at which the clip, or the addition to
// a foot, changes its course; ascending, with both ends. The gait may be null.
std::vector<double> breaks_of(const Clip& clip, const Gait* gait);

} // namespace trivar
