// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/file_lines.h"
#include "core/files/gltf/gltf_accessor.h"
#include "core/files/gltf/gltf_uv_transform.h"

#include <map>

namespace trivar {

// GltfMeshes reads the meshes of a glTF file: faces, attributes, influences, morph targets, and
// lines. Throws Rejected; parts that can be left out become notices.
class GltfMeshes {
public:
    GltfMeshes(GltfAccessors& accessors, CountedNotices& notices);
    struct Shapes {
        Mesh mesh;
        Curves curves;
    };
    Shapes read(const GltfEntry& mesh);
    // Whether a face got the material that follows the file's last one, because it names no
    // material.
    bool uses_plain_material() const { return plain_used_; }
    // Whether points were all that the meshes have.
    bool only_points() const { return points_left_out_ && !others_; }

private:
    // A VertexRange is the vertices of a primitive, which are the last ones of the mesh while it is
    // read.
    struct VertexRange {
        std::size_t first, count;
        std::size_t end() const { return first + count; }
    };
    std::size_t position_count(const GltfEntry& attributes); // all of which are finite
    VertexRange add_vertices(Mesh& mesh, const GltfEntry& primitive);
    void add_uvs(Mesh& mesh, const GltfEntry& attributes, VertexRange added,
                 const UvTransforms& transforms);
    const UvTransforms& transforms_of(const GltfEntry& primitive); // of its material's textures
    bool moves_uvs(const GltfEntry& primitive);
    void add_influences(Mesh& mesh, const GltfEntry& attributes, VertexRange added);
    void add_targets(Mesh& mesh, const GltfEntry& primitive, VertexRange added);
    VertexRange add_line_points(Mesh& points, const GltfEntry& primitive);
    void add_lines(FileLines& lines, const GltfEntry& primitive, std::size_t mode,
                   VertexRange points);
    std::vector<std::uint32_t> order_of(const GltfEntry& primitive, VertexRange vertices);
    void add_faces(Mesh& mesh, const GltfEntry& primitive, std::size_t mode, VertexRange vertices);
    std::uint32_t material_of(const GltfEntry& primitive);
    template <class T>
    void append(std::vector<T>& values, const GltfEntry& owner, const char* name, VertexRange added,
                T neutral, std::size_t least_components = T::length());
    GltfAccessors::Table table(const GltfEntry& owner, const char* name, std::size_t count,
                               std::size_t least, std::size_t most);

    GltfAccessors& accessors_;
    CountedNotices& notices_;
    std::uint32_t material_count_;
    std::map<int, UvTransforms> transforms_;                             // by material
    bool plain_used_ = false, points_left_out_ = false, others_ = false; // of primitives
    std::size_t line_points_ = 0;                                        // of the meshes so far
};

} // namespace trivar
