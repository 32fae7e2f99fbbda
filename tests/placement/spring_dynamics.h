// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/finish.h"
#include "core/placement/obstacle.h"
#include "core/rays/ray_scene.h"

namespace trivar {

// Moving springs: displacement and speed of every node.
struct SpringState {
    std::vector<double> s, v;
    double time_s = 0;
    bool operator==(const SpringState&) const = default;
};

struct SpringDynamics {
    double stiffness = 100; // k / M, 1/s^2
    double damping = -5;    // rho, 1/s, negative: acceleration = stiffness x force + rho v
};

// Near-critical damping for the slowest motion of a grid with n nodes along its longer side.
SpringDynamics settling_dynamics(double stiffness, int n);

// The longest step of semi-implicit Euler that stays bounded: (sqrt(rho^2 + 4 lambda) - |rho|) /
// lambda, where lambda bounds the eigenvalues of stiffness A (8 k / M for springs alone); and of
// explicit Euler: min(|rho| / lambda, 2 / |rho|).
double stable_step(const ObstacleProblem& problem, const SpringDynamics& dynamics);
double stable_step_explicit(const ObstacleProblem& problem, const SpringDynamics& dynamics);

// The state `dt_s` later, in as many equal steps of semi-implicit Euler as stability asks for. A
// node that meets a bound stops there. Pure.
SpringState stepped(const ObstacleProblem& problem, SpringState state,
                    const SpringDynamics& dynamics, double dt_s);

// A placement whose springs are let go on the scene and are watched until they rest.
struct SpringAnimation {
    Camera camera;
    PlacementParameters parameters;
    ModelFrame frame;
    StripLayout layout;
    ObstacleProblem problem;
    SpringDynamics dynamics;
    SpringState state;
};

// On the scene, at time 0. Throws as place() does.
SpringAnimation spring_animation(const Sketch& sketch, const PlacementParameters& parameters,
                                 const Box& model, const RayScene& scene, Timings& timings);
SpringAnimation stepped(SpringAnimation animation, double dt_s);
Placement placed(const SpringAnimation& animation, const RayScene& scene, Timings& timings);

} // namespace trivar
