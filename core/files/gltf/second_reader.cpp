// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/gltf/second_reader.h"

#include "core/base/rejected.h"
#include "core/files/gltf/glb_chunks.h"

#include <cstring>
#include <limits>
#include <tiny_gltf.h>

namespace trivar {
namespace {

// Reads the bytes with an independent reader, so that a wrongly written file does not pass because
// it is read wrongly in the same way.
tinygltf::Model read_by_tinygltf(const std::string& bytes)
{
    if (bytes.size() > std::numeric_limits<unsigned>::max())
        throw Rejected("a GLB file has at most 4 GB");
    glb_views(bytes); // throws for bad chunks and for JSON too deep for a parser
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader([](tinygltf::Image*, int, std::string*, std::string*, int, int,
                             const unsigned char*, int, void*) { return true; },
                          nullptr);
    // It must not open other files.
    loader.SetFsCallbacks(
        {[](const std::string&, void*) { return false; },
         [](const std::string& path, void*) { return path; },
         [](std::vector<unsigned char>*, std::string*, const std::string&, void*) { return false; },
         nullptr, nullptr});
    tinygltf::Model model;
    std::string error, warning;
    if (!loader.LoadBinaryFromMemory(&model, &error, &warning,
                                     reinterpret_cast<const unsigned char*>(bytes.data()),
                                     static_cast<unsigned>(bytes.size())))
        throw Rejected("it is refused by tinygltf");
    return model;
}

class TinyParts {
public:
    explicit TinyParts(const std::string& bytes)
        : model(read_by_tinygltf(bytes)),
          left_(16 * bytes.size() + (std::size_t{1} << 20))
    {
    }

    [[noreturn]] static void fail(const std::string& what) { throw Rejected(what); }

    template <class T> static const T& at(const std::vector<T>& list, int index)
    {
        if (index < 0 || static_cast<std::size_t>(index) >= list.size())
            fail("it names an entry that is not there");
        return list[static_cast<std::size_t>(index)];
    }

    // Reads an accessor whose elements have the size of `Value`. A limit on all copied bytes keeps
    // a file from using one accessor many times.
    template <class Value> std::vector<Value> values(int index)
    {
        const tinygltf::Accessor& accessor = at(model.accessors, index);
        const tinygltf::BufferView& view = at(model.bufferViews, accessor.bufferView);
        const std::vector<unsigned char>& data = at(model.buffers, view.buffer).data;
        if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset ||
            accessor.byteOffset != 0 || accessor.count > view.byteLength / sizeof(Value))
            fail("an accessor reaches beyond the data");
        const std::size_t taken = 64 + accessor.count * sizeof(Value);
        if (taken > left_) fail("its nodes name the same data over and over");
        left_ -= taken;
        std::vector<Value> out(accessor.count);
        if (!out.empty())
            std::memcpy(out.data(), data.data() + view.byteOffset, out.size() * sizeof(Value));
        return out;
    }

    tinygltf::Model model;

private:
    std::size_t left_; // bytes that may still be copied
};

glm::dmat4 tiny_matrix_of(const tinygltf::Node& node)
{
    if (!node.translation.empty() || !node.rotation.empty() || !node.scale.empty())
        TinyParts::fail("a node is moved by something other than a matrix");
    glm::dmat4 out(1);
    if (node.matrix.empty()) return out;
    if (node.matrix.size() != 16) TinyParts::fail("a node's matrix has not 16 numbers");
    for (int i = 0; i < 16; ++i) out[i / 4][i % 4] = node.matrix[static_cast<std::size_t>(i)];
    return out;
}

GlbContent::Node tiny_content_of(TinyParts& parts, const tinygltf::Node& node)
{
    GlbContent::Node out;
    out.name = node.name;
    out.to_file = tiny_matrix_of(node);
    if (node.mesh < 0) return out;
    int shared = -1;
    for (const tinygltf::Primitive& primitive :
         TinyParts::at(parts.model.meshes, node.mesh).primitives) {
        if (primitive.mode != TINYGLTF_MODE_TRIANGLES) continue; // lines
        const auto position = primitive.attributes.find("POSITION");
        if (position == primitive.attributes.end()) TinyParts::fail("a primitive has no positions");
        if (shared < 0)
            out.positions = parts.values<glm::vec3>(position->second);
        else if (position->second != shared)
            TinyParts::fail("the primitives of a mesh stand on different vertices");
        shared = position->second;
        const std::vector<std::uint32_t> corners = parts.values<std::uint32_t>(primitive.indices);
        out.corners.insert(out.corners.end(), corners.begin(), corners.end());
    }
    for (const std::uint32_t corner : out.corners)
        if (corner >= out.positions.size()) TinyParts::fail("an index names no vertex");
    return out;
}

} // namespace

std::vector<GlbContent::Node> nodes_by_tinygltf(const std::string& bytes)
try {
    TinyParts parts(bytes);
    std::vector<GlbContent::Node> out;
    const std::vector<tinygltf::Node>& nodes = parts.model.nodes;
    for (const tinygltf::Node& node : nodes) out.push_back(tiny_content_of(parts, node));
    // Parents come before their children, as Trivar writes them.
    for (std::size_t n = 0; n < nodes.size(); ++n)
        for (const int child : nodes[n].children) {
            const auto c = static_cast<std::size_t>(child);
            if (child < 0 || c <= n || c >= nodes.size())
                TinyParts::fail("a node comes before its parent");
            out[c].to_file = out[n].to_file * out[c].to_file;
        }
    return out;
} catch (const Rejected&) {
    throw;
} catch (const std::exception&) { // a value has an unexpected type
    throw Rejected("it is refused by tinygltf");
}

} // namespace trivar
