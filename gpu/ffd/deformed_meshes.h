// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/ffd/device_deformer.h"
#include "gpu/ffd/device_poser.h"
#include "gpu/mirror.h"
#include "gpu/picture.h"

#include <optional>

namespace trivar::gpu {

// A DeformedMesh is an instance with a pose or stages, as it is drawn.
struct DeformedMesh {
    MirroredMesh mirrored;      // with the deformed vertices, or in one phase the undeformed ones
    MirroredEdges edges;        // where the picture draws them
    glm::dvec3 origin_world{0}; // the origin of its positions
    Box box;                    // before to_world
    // One phase: the volume that the vertex shader applies, and how the shader gets it.
    std::optional<Stage> stage;
    Box undeformed;
    std::vector<std::string> defines;
};

// DeformedMeshes are the instances of pictures that carry poses or volumes. They are deformed where
// Picture::deform_by says, and only when mesh, pose or volumes change: then matrices and control
// points are uploaded, and nothing else. An instance is known by its id and part from picture to
// picture, at any place among the others. The processor does what the device cannot, and a notice
// says why.
class DeformedMeshes {
public:
    void update(const Picture& picture, Mirror& mirror);
    // The number of vertices that update() would deform: those of what changed.
    std::size_t stale_vertices(const Picture& picture) const;
    // The mesh for the index of an instance of the last taken picture; null where the instance has
    // neither pose nor volumes, or no faces.
    const DeformedMesh* of(std::size_t instance) const;
    // Binds the volume of one phase, before a draw with `defines`.
    void bind(const DeformedMesh& mesh);
    const std::string& notice() const { return notice_; } // empty: everything was done as asked
    // Takes new texts of the programs that deform; all meshes are then deformed anew.
    void take(const Ref<ShaderTexts>& texts);
    std::string shader_trouble() const; // see Programs

private:
    struct OnProcessor { // the first stage of a stack
        Embedding embedding;
        std::array<Knots, 3> axes;
        Deformer deformer;
    };
    struct Entry {
        std::weak_ptr<const Mesh> alive;
        Ref<PosedMesh> posed;
        std::vector<Stage> stages;
        DeformBy by;
        bool wire;
        DeviceVertices vertices;
        std::unique_ptr<OnProcessor> on_processor;
        DeformedMesh drawn;
        std::string notice; // why the processor did it
    };
    // The key is id and part, and the number of instances before this one that have the same.
    using Key = std::tuple<int, PartKey, int>;
    // Returns the keys of the instances that deform, in their order.
    static std::vector<Key> keys_of(const Picture& picture);
    static bool current(const Entry& entry, const Instance& instance, const Picture& picture);
    DeviceDeformer& device();
    void deform(Entry& entry, const Instance& instance, Mirror& mirror);
    void deform_on_device(Entry& entry, const Instance& instance, Mirror& mirror);
    void deform_on_processor(Entry& entry, const Instance& instance);
    std::map<Key, Entry> entries_;
    std::vector<const Entry*> of_instance_; // null: does not deform
    std::unique_ptr<DeviceDeformer> device_;
    std::unique_ptr<DevicePoser> poser_;
    Ref<ShaderTexts> texts_;
    std::string notice_;
};

} // namespace trivar::gpu
