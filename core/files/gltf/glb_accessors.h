// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/clip.h"
#include "core/mesh/curves.h"

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace trivar {

using GlbEntries = nlohmann::ordered_json;

// The double whose shortest text is that of the float: 0.1, not 0.10000000149011612. Throws
// Rejected where it is not finite.
double plain(float value);

// GlbAccessors is a GLB file while it is written: its JSON, and its numbers with the accessors that
// name them.
struct GlbAccessors {
    enum : int {
        array_buffer = 34962,
        element_array_buffer = 34963,
        float32 = 5126,
        uint32 = 5125,
        uint16 = 5123
    };
    GlbEntries json;
    std::string binary;

    // Appends bytes at a multiple of four; returns the index of their view.
    int add_view(const void* data, std::size_t size, int target);
    template <class T>
    int add(const std::vector<T>& values, const char* type, int target = array_buffer,
            int component = float32)
    {
        GlbEntries accessor{
            {"bufferView", add_view(values.data(), values.size() * sizeof(T), target)},
            {"componentType", component},
            {"count", values.size()},
            {"type", type}};
        json["accessors"].push_back(std::move(accessor));
        return static_cast<int>(json["accessors"].size()) - 1;
    }
    // Adds the differences of a morph target, sparsely if that is shorter.
    int add_differences(const std::vector<glm::vec3>& values);
    // Sets the least and the greatest value of the accessor that was added last.
    void set_range(const std::vector<glm::vec3>& values);
    // The attributes of all vertices except joints, weights and targets.
    GlbEntries attributes(const Mesh& mesh);
};

// The primitives of curves: one per line, but one for several consecutive lines of two points.
GlbEntries curve_primitives(GlbAccessors& to, const Curves& curves, std::size_t materials);

// Instances as EXT_mesh_gpu_instancing has them: for each a translation, a rotation and a scale in
// single precision, relative to the middle of all.
struct WrittenInstances {
    glm::dvec3 middle{0}; // metres, in the space of their node's parent
    GlbEntries attributes;
};
WrittenInstances add_instances(GlbAccessors& to, const std::vector<NodeTransform>& instances);

} // namespace trivar
