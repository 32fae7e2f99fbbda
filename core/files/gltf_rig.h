// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/gltf_accessor.h"
#include "core/mesh/model.h"

#include <map>

namespace tinygltf {
struct Primitive;
}

namespace trivar {

// What lets a glTF file move: influences, morph targets, skins, clips. Everything throws Rejected,
// with the file's name; what can be left out is left out with a notice.
class GltfRig {
public:
    GltfRig(const tinygltf::Model& gltf, GltfAccessors& accessors, std::string name)
        : gltf_(gltf),
          accessors_(accessors),
          name_(std::move(name))
    {
    }
    // Those of a primitive whose `count` vertices were added to the mesh last.
    void add_influences(Mesh& mesh, const tinygltf::Primitive& primitive, std::size_t count);
    void add_targets(Mesh& mesh, const tinygltf::Primitive& primitive, std::size_t count);
    // To a model that has its nodes; `node_of`: where each of the file's is in it, or -1.
    void add_skins(Model& model, const std::vector<int>& node_of);
    void add_clips(Model& model, const std::vector<int>& node_of);
    void add_notices(Model& model) const;

private:
    Skin skin(int index, const std::vector<int>& node_of, bool& whole);
    void add_channel(Clip& clip, const Model& model, int animation, int channel,
                     const std::vector<int>& node_of);
    [[noreturn]] void fail(const std::string& what) const;

    const tinygltf::Model& gltf_;
    GltfAccessors& accessors_;
    std::string name_;
    std::size_t loose_ = 0, crowded_ = 0, channels_left_out_ = 0, skins_left_out_ = 0, short_ = 0,
                untimely_ = 0, uneven_ = 0, unsummed_ = 0, negative_ = 0, renamed_ = 0,
                turnless_ = 0, halves_ = 0, whole_times_ = 0, unknown_ways_ = 0, empty_clips_ = 0;
};

} // namespace trivar
