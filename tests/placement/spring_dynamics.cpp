// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/placement/spring_dynamics.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

// Gershgorin's bound of the largest eigenvalue.
double largest_eigenvalue(const ObstacleProblem& problem)
{
    double largest = 0;
    for (std::size_t i = 0; i < problem.size(); ++i) {
        double sum = problem.diagonal[i];
        for (int e = problem.row_begin[i]; e < problem.row_begin[i + 1]; ++e)
            sum += std::abs(problem.value[static_cast<std::size_t>(e)]);
        if (problem.free[i]) largest = std::max(largest, sum);
    }
    return largest;
}

constexpr double safety = 0.8; // of the stable step

} // namespace

SpringDynamics settling_dynamics(double stiffness, int n)
{
    return {stiffness, -3 * std::acos(-1.0) / n * std::sqrt(stiffness)};
}

double stable_step(const ObstacleProblem& problem, const SpringDynamics& dynamics)
{
    const double lambda = dynamics.stiffness * largest_eigenvalue(problem);
    const double rho = std::abs(dynamics.damping);
    if (!(lambda > 0)) return rho > 0 ? 2 / rho : 1e300;
    return (std::sqrt(rho * rho + 4 * lambda) - rho) / lambda;
}

double stable_step_explicit(const ObstacleProblem& problem, const SpringDynamics& dynamics)
{
    const double lambda = dynamics.stiffness * largest_eigenvalue(problem);
    const double rho = std::abs(dynamics.damping);
    return std::min(rho / lambda, 2 / rho);
}

SpringState stepped(const ObstacleProblem& problem, SpringState state,
                    const SpringDynamics& dynamics, double dt_s)
{
    constexpr double most_steps = 1000; // a pause of the program is no reason to work it all off
    const double limit = safety * stable_step(problem, dynamics);
    const int steps = static_cast<int>(std::clamp(std::ceil(dt_s / limit), 1.0, most_steps));
    const double dt = std::min(dt_s / steps, limit);
    std::vector<double> force(state.s.size(), 0);
    for (int step = 0; step < steps; ++step) {
        for (std::size_t i = 0; i < force.size(); ++i)
            if (problem.free[i]) force[i] = problem.force(state.s, i);
        for (std::size_t i = 0; i < force.size(); ++i) {
            if (!problem.free[i]) continue;
            double& v = state.v[i];
            v += dt * (dynamics.stiffness * force[i] + dynamics.damping * v);
            const double wanted = state.s[i] + dt * v;
            state.s[i] = std::clamp(wanted, problem.lo[i], problem.hi[i]);
            if (state.s[i] != wanted) v = 0;
        }
        state.time_s += dt;
    }
    return state;
}

SpringAnimation spring_animation(const Sketch& sketch, const PlacementParameters& parameters,
                                 const Box& model, const RayScene& scene, Timings& timings)
{
    const ModelFrame frame = model_frame(parameters, model);
    StripLayout layout = lay_out(sketch, parameters, frame, scene, timings);
    ObstacleProblem problem = spring_problem(layout.sheet);
    problem.free = layout.loose;
    const SpringDynamics dynamics =
        settling_dynamics(100, std::max(layout.grid.rows, layout.grid.columns));
    SpringState state{std::vector<double>(layout.s.size(), 0),
                      std::vector<double>(layout.s.size(), 0)};
    return {sketch.camera,      parameters, frame,           std::move(layout),
            std::move(problem), dynamics,   std::move(state)};
}

SpringAnimation stepped(SpringAnimation animation, double dt_s)
{
    animation.state =
        stepped(animation.problem, std::move(animation.state), animation.dynamics, dt_s);
    return animation;
}

Placement placed(const SpringAnimation& animation, const RayScene& scene, Timings& timings)
{
    return finished(animation.layout, animation.state.s, animation.camera, animation.parameters,
                    animation.frame, scene, timings);
}

} // namespace trivar
