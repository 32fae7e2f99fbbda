// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/ffd/blind_draw.h"
#include "gpu/pass_clock.h"

#include <algorithm>

namespace trivar::gpu {

enum class Way { processor, one_phase, two_phases };

// The least time of several runs, in milliseconds; the first run is not counted, because it
// compiles.
template <class Run> double least_ms(Run&& run, double enough_ms)
{
    constexpr int most_runs = 12;
    run();
    double least = run(), sum = least;
    for (int i = 1; i < most_runs && sum < enough_ms; ++i) {
        const double time_ms = run();
        least = std::min(least, time_ms);
        sum += time_ms;
    }
    return least;
}

// DeformErrors hold the largest errors; infinite where a result is not a number.
struct DeformErrors {
    double position = 0; // a distance, as a share of the box's diagonal
    double normal_deg = 0, tangent_deg = 0;
    double diagonal = 0; // scene units
};
// The errors of `found`, with the result of the processor's evaluator taken as exact.
DeformErrors errors_of(const DeformedArrays& found, const DeformedArrays& exact);
DeformErrors worst(const DeformErrors& a, const DeformErrors& b);

// A DeformTimer deforms one mesh again and again by a volume, at least three times and until
// `enough_ms` are spent: by timer queries, or fences on software GL. Throws Rejected where the
// device lacks something that it needs.
class DeformTimer {
public:
    explicit DeformTimer(double enough_ms) : enough_ms_(enough_ms) {}
    void take(const Ref<Mesh>& mesh); // the mesh that is deformed from now on; uploads it
    void take_shaders(const Ref<ShaderTexts>& texts); // see Programs
    // The time to deform and to draw in `passes` passes: the first one with normals where the
    // method has them, the others, like a shadow's and picking, without. One phase deforms in every
    // pass, of which it has at least one; the processor is timed without drawing.
    double time_ms(const Stage& stage, Way way, const Method& method, int passes = 0);
    // The errors of the way's results, near an origin as pictures have it, so that the place in the
    // world costs neither side digits. Reads the vertices back.
    DeformErrors errors(const Stage& stage, Way way, const Method& method);
    void drop_dead(); // of the lattices on the device

    template <class Body> double timed_ms(Body&& body)
    {
        clock_.start_picture();
        clock_.pass("deform", body);
        return clock_.timings().stages.front().time_ms;
    }

private:
    double processor_ms(const Stage& stage, const Method& method) const;
    double one_phase_ms(const Stage& stage, const Method& method, int passes);
    double two_phases_ms(const Stage& stage, const Method& method, int passes);
    Ref<Mesh> mesh(const Method& method) const;
    DeviceDeformer& device();
    std::vector<std::string> bound(const Stage& stage, const glm::dvec3& origin_world);
    void draw(const std::vector<std::string>& volume, const Method& method, int passes);
    double enough_ms_;
    PassClock clock_;
    std::unique_ptr<DeviceDeformer> device_;
    BlindDraw draw_;
    Ref<ShaderTexts> texts_;
    Ref<Mesh> mesh_;
    DeviceVertices from_, to_;
};

} // namespace trivar::gpu
