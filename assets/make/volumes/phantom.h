// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assets/make/volumes/shapes.h"

#include <span>

namespace make {

// A Tissue is the parts of one substance, such as the bones of a foot. Each part is made of solids
// that are joined and cut with soft edges, in order; parts lie side by side and do not blend.
class Tissue {
public:
    Tissue& part(); // what comes next is another part
    Tissue& join(const Solid& solid, float blend = 0);
    Tissue& cut(const Solid& solid, float blend = 0);

private:
    friend class NearTissue;
    struct Step {
        Solid solid;
        float blend;
        bool cuts;
    };
    std::vector<std::vector<Step>> parts_;
};

// A phantom is an object of tomography that was computed: what a scanner would measure at the
// points of a grid, from the distances to its tissues.
struct Phantom {
    std::string name;
    glm::ivec3 size;
    vec3 lo;    // of the first sample, mm
    float step; // between samples, mm
    std::vector<Tissue> tissues;
    // The value at a point, from the distance to each tissue: exact to about `reach`, beyond it
    // just large.
    std::function<float(vec3 p, std::span<const float> distances)> value;
    float warp = 0; // greatest displacement by slow noise, mm: nothing grown is quite even
};
inline constexpr float phantom_reach_mm = 3.5f;

// Returns 0 outside to 1 inside, rising over the width, as the samples of a scanner average over
// their cells.
float inside(float distance, float width);

// Blurred by (1 2 1)/4 along each axis; 0.1 to 1 us a sample, the same bits for any number of
// threads.
std::vector<float> sampled(const Phantom& phantom);

std::vector<float> blurred(const std::vector<float>& samples, glm::ivec3 size);

} // namespace make
