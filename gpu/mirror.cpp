// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/mirror.h"

#include "core/base/mistake.h"
#include "core/mesh/adjacency.h"

#include <algorithm>
#include <bit>
#include <epoxy/gl.h>
#include <set>

namespace trivar::gpu {
namespace {

template <class T>
void add_attribute(MirroredMesh& out, unsigned location, const std::vector<T>& values)
{
    if (values.empty()) return;
    out.buffers.emplace_back().write(std::as_bytes(std::span(values)));
    out.vertices.attribute(location, out.buffers.back(), T::length(), sizeof(T));
    out.attributes.push_back({location, T::length(), out.buffers.size() - 1});
}

MirroredMesh uploaded(const Mesh& mesh, std::shared_ptr<const MirroredFaces> faces)
{
    MirroredMesh out;
    out.buffers.reserve(6);
    out.colored = !mesh.colors.empty();
    add_attribute(out, 0, mesh.positions);
    add_attribute(out, 1, mesh.normals.empty() ? smooth_normals(mesh) : mesh.normals);
    add_attribute(out, 2, mesh.tangents);
    add_attribute(out, 3, mesh.colors);
    // Two sets of texture coordinates, as every glTF viewer must; more are rare and fall back.
    for (unsigned set = 0; set < std::min<std::size_t>(mesh.uvs.size(), 2); ++set)
        add_attribute(out, 4 + set, mesh.uvs[set]);
    out.faces = std::move(faces);
    out.vertices.indices(out.faces->indices);
    return out;
}

template <class Entries> void erase_dead(Entries& entries)
{
    std::erase_if(entries, [](const auto& item) { return item.second.alive.expired(); });
}

} // namespace

const Buffer* MirroredMesh::attribute(unsigned location) const
{
    for (const Attribute& a : attributes)
        if (a.location == location) return &buffers[a.buffer];
    return nullptr;
}

Mirror::MeshEntry& Mirror::entry(const Ref<Mesh>& mesh)
{
    auto found = meshes_.find(mesh.get());
    // A dead mesh's address may have been taken by another one.
    if (found == meshes_.end() || found->second.alive.lock() != mesh) {
        // A mesh for which there is no room leaves no half of itself behind.
        MeshEntry made{mesh, uploaded(*mesh, faces_(*mesh)), {}, {}};
        made.mirrored.serial = ++uploads_;
        found = meshes_.insert_or_assign(mesh.get(), std::move(made)).first;
    }
    return found->second;
}

const MirroredMesh& Mirror::mesh(const Ref<Mesh>& mesh)
{
    return entry(mesh).mirrored;
}

std::shared_ptr<const EdgeIndices> Mirror::edge_indices(const Ref<Mesh>& faces)
{
    auto found = edges_.find(faces.get());
    if (found == edges_.end() || found->second.alive.lock() != faces) {
        auto indices = std::make_shared<EdgeIndices>();
        const Adjacency adjacency(*faces, Adjacency::Ends::vertices);
        indices->count = static_cast<int>(2 * adjacency.edge_count());
        indices->buffer.write(std::as_bytes(adjacency.edges()));
        found = edges_.insert_or_assign(faces.get(), EdgesEntry{faces, std::move(indices)}).first;
    }
    return found->second.indices;
}

const MirroredEdges& Mirror::edges(const Ref<Mesh>& mesh, const Ref<Mesh>& faces)
{
    MeshEntry& found = entry(mesh);
    if (!found.edges) {
        auto indices = edge_indices(faces);
        found.edges = std::make_unique<MirroredEdges>();
        MirroredEdges& out = *found.edges;
        out.indices = std::move(indices);
        out.vertices.attribute(0, found.mirrored.buffers.front(), 3, sizeof(glm::vec3));
        out.vertices.attribute(1, *found.mirrored.attribute(1), 3, sizeof(glm::vec3));
        out.vertices.indices(out.indices->buffer);
    }
    return *found.edges;
}

const MirroredCopies& Mirror::copies(const Ref<std::vector<Copy>>& copies, const CopiesAt& at)
{
    const auto [from, to] = copies_.equal_range(copies.get());
    for (auto i = from; i != to; ++i)
        if (CopiesEntry& found = i->second; found.alive.lock() == copies && found.at == at) {
            found.wanted = true;
            return found.copies;
        }
    CopiesEntry made{copies, at, uploaded(*copies, at)};
    made.copies.serial = ++uploads_;
    return copies_.emplace(copies.get(), std::move(made))->second.copies;
}

Box Mirror::box_world(const Ref<Mesh>& mesh, const glm::dmat4& to_world,
                      const Ref<std::vector<Copy>>& copies)
{
    auto& boxes = entry(mesh).boxes;
    const bool copied = copies != nullptr;
    for (const SeenBox& seen : boxes)
        if (seen.to_world == to_world && seen.copied == copied && seen.copies.lock() == copies)
            return seen.box;
    if (boxes.size() >= 16) boxes.clear();
    const Box box = copied ? bounding_box(*mesh, to_world, *copies) : bounding_box(*mesh, to_world);
    return boxes.emplace_back(SeenBox{to_world, copied, copies, box}).box;
}

const Buffer& Mirror::values(const Ref<std::vector<float>>& values)
{
    ValuesEntry& found = values_[values.get()];
    if (found.alive.lock() != values) {
        found.buffer.write(std::as_bytes(std::span(*values)));
        found.alive = values;
    }
    return found.buffer;
}

const Texture2D& Mirror::texture(const Ref<Image>& image, bool srgb)
{
    TextureEntry& found = textures_[{image.get(), srgb}];
    if (found.alive.lock() != image) {
        const glm::ivec2 size = image->size_px;
        ensure(size.x > 0 && size.y > 0, "an image has no pixels");
        const int levels = std::bit_width(static_cast<unsigned>(std::max(size.x, size.y)));
        found = {image, Texture2D(srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8, size, true, levels)};
        found.texture.write_rgba(image->rgba);
    }
    return found.texture;
}

std::size_t Mirror::bytes() const
{
    std::size_t sum = 0;
    std::set<const MirroredFaces*> faces; // shared ones count once
    for (const auto& [mesh, entry] : meshes_) {
        for (const Buffer& buffer : entry.mirrored.buffers) sum += buffer.bytes();
        faces.insert(entry.mirrored.faces.get());
    }
    for (const MirroredFaces* each : faces) sum += each->indices.bytes();
    for (const auto& [mesh, entry] : edges_) sum += entry.indices->buffer.bytes();
    for (const auto& [values, entry] : values_) sum += entry.buffer.bytes();
    for (const auto& [copies, entry] : copies_) sum += entry.copies.rows.bytes();
    for (const auto& [image, entry] : textures_) { // the smaller levels are a third more
        const glm::ivec2 size = entry.texture.size_px();
        sum += static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * 16 / 3;
    }
    return sum;
}

void Mirror::drop_dead()
{
    faces_.drop_dead(); // first: what a mesh that dies now had, the next one may have too
    erase_dead(meshes_);
    erase_dead(edges_);
    erase_dead(textures_);
    erase_dead(values_);
    std::erase_if(copies_, [](const auto& item) { return !item.second.wanted; });
    for (auto& [copies, entry] : copies_) entry.wanted = false;
}

} // namespace trivar::gpu
