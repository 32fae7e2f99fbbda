// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"
#include "core/mesh/model.h"
#include "gpu/mirrored_copies.h"
#include "gpu/mirrored_faces.h"
#include "gpu/texture.h"
#include "gpu/vertex_array.h"

#include <map>
#include <memory>

namespace trivar::gpu {

// A MirroredMesh is a mesh on the GPU.
struct MirroredMesh {
    using Part = MirroredFaces::Part;
    struct Attribute {
        unsigned location;
        int components;
        std::size_t buffer;
    };
    VertexArray vertices;
    std::vector<Buffer> buffers; // of the attributes
    std::vector<Attribute> attributes;
    std::shared_ptr<const MirroredFaces> faces;
    const std::vector<Part>& parts() const { return faces->parts; }
    // The buffer of an attribute, or null.
    const Buffer* attribute(unsigned location) const;
    bool colored = false;     // has vertex colours
    std::uint64_t serial = 0; // unique for each upload
};

// EdgeIndices are the edges between a mesh's faces, each once, as lines; diagonals of polygons are
// not among them.
struct EdgeIndices {
    Buffer buffer;
    int count = 0;
};
struct MirroredEdges {
    VertexArray vertices;
    std::shared_ptr<const EdgeIndices> indices;
};

// A Mirror uploads immutable values, by Ref identity. It owns none of the values: drop_dead() frees
// those that nobody else holds any more.
class Mirror {
public:
    const MirroredMesh& mesh(const Ref<Mesh>& mesh);
    // `faces` has the same faces, and so the same edges: a mesh and its deformed results share
    // them. O(#C log valence) at the first call.
    const MirroredEdges& edges(const Ref<Mesh>& mesh, const Ref<Mesh>& faces);
    std::shared_ptr<const EdgeIndices> edge_indices(const Ref<Mesh>& faces);
    // The copies on the GPU; they are kept while the next picture wants them too, and uploaded anew
    // where they have moved.
    const MirroredCopies& copies(const Ref<std::vector<Copy>>& copies, const CopiesAt& at);
    // The bounding_box() of the mesh, or of all its copies, remembered for the last few matrices
    // and copies.
    Box box_world(const Ref<Mesh>& mesh, const glm::dmat4& to_world,
                  const Ref<std::vector<Copy>>& copies = {});
    const Buffer& values(const Ref<std::vector<float>>& values);
    const Texture2D& texture(const Ref<Image>& image, bool srgb);
    void drop_dead();
    std::uint64_t next_serial() { return ++uploads_; } // for uploads of others

    std::size_t bytes() const; // memory of all uploads
    std::size_t mesh_count() const { return meshes_.size(); }
    std::size_t texture_count() const { return textures_.size(); }

private:
    struct SeenBox {
        glm::dmat4 to_world;
        bool copied;
        std::weak_ptr<const std::vector<Copy>> copies;
        Box box;
    };
    struct MeshEntry {
        std::weak_ptr<const Mesh> alive;
        MirroredMesh mirrored;
        std::vector<SeenBox> boxes;
        std::unique_ptr<MirroredEdges> edges;
    };
    struct EdgesEntry {
        std::weak_ptr<const Mesh> alive;
        std::shared_ptr<const EdgeIndices> indices;
    };
    struct TextureEntry {
        std::weak_ptr<const Image> alive;
        Texture2D texture;
    };
    struct ValuesEntry {
        std::weak_ptr<const std::vector<float>> alive;
        Buffer buffer;
    };
    struct CopiesEntry {
        std::weak_ptr<const std::vector<Copy>> alive;
        CopiesAt at;
        MirroredCopies copies;
        bool wanted = true; // since the last drop_dead()
    };
    MeshEntry& entry(const Ref<Mesh>& mesh);
    FacesMirror faces_;
    std::map<const Mesh*, MeshEntry> meshes_;
    std::map<const Mesh*, EdgesEntry> edges_;
    std::map<std::pair<const Image*, bool>, TextureEntry> textures_;
    std::map<const std::vector<float>*, ValuesEntry> values_;
    std::multimap<const std::vector<Copy>*, CopiesEntry> copies_;
    std::uint64_t uploads_ = 0;
};

} // namespace trivar::gpu
