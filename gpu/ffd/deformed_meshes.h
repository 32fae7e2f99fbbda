// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/ffd/device_deformer.h"
#include "gpu/ffd/device_poser.h"
#include "gpu/mirror.h"
#include "gpu/picture.h"

#include <optional>

namespace trivar::gpu {

// An instance with a pose or stages as it is drawn.
struct DeformedMesh {
    MirroredMesh mirrored;      // with the deformed vertices, or in one phase the undeformed ones
    MirroredEdges edges;        // where the picture draws them
    glm::dvec3 origin_world{0}; // what its positions are relative to
    Box box;                    // before to_world
    // One phase: the volume that is left to the vertex shader, and how it is told of it.
    std::optional<Stage> stage;
    Box undeformed;
    std::vector<std::string> defines;
};

// The instances of pictures that carry poses or volumes, deformed where Picture::deform_by says and
// only when mesh, pose or volumes change: then matrices and control points are uploaded, and
// nothing else. An instance is known by its id and part from picture to picture, wherever it stands
// among the others. What the device cannot do the processor does, and a notice says why.
class DeformedMeshes {
public:
    void update(const Picture& picture, Mirror& mirror);
    // How many vertices update() would deform: those of what changed.
    std::size_t stale_vertices(const Picture& picture) const;
    // By the index of an instance of the picture that was taken last; null where it has neither
    // pose nor volumes, or no faces.
    const DeformedMesh* of(std::size_t instance) const;
    // For one phase, before a draw with `defines`.
    void bind(const DeformedMesh& mesh);
    const std::string& notice() const { return notice_; } // empty: all went as it was asked
    void take(const Ref<ShaderTexts>& texts); // for the programs that deform; all is deformed anew
    std::string shader_trouble() const;       // see Programs

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
    // Id and part, and the number of instances before it that have the same.
    using Key = std::tuple<int, PartKey, int>;
    static std::vector<Key> keys_of(const Picture& picture); // of those that deform, in their order
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
