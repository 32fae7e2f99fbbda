// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/gltf/glb_content.h"

#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/files/gltf/glb_chunks.h"

#include <cstring>
#include <nlohmann/json.hpp>

namespace trivar {
namespace {

using GlbJson = nlohmann::json;

class GlbParts {
public:
    explicit GlbParts(const std::string& bytes)
        : GlbParts(glb_chunks(bytes), 16 * bytes.size() + (std::size_t{1} << 20))
    {
    }

    // Reads an accessor whose elements have the size of `Value`. A limit on all copied bytes keeps
    // a file from using one accessor many times.
    template <class Value> std::vector<Value> values(const GlbJson& accessor_index)
    {
        const GlbJson& accessor = json.at("accessors").at(accessor_index.get<std::size_t>());
        const GlbJson& view =
            json.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>());
        const auto count = accessor.at("count").get<std::size_t>(),
                   begin = view.at("byteOffset").get<std::size_t>(),
                   size = view.at("byteLength").get<std::size_t>();
        if (begin > binary.size() || size > binary.size() - begin || count > size / sizeof(Value))
            fail("an accessor reaches beyond the data");
        const std::size_t taken = 64 + count * sizeof(Value);
        if (taken > left_) fail("its nodes name the same data over and over");
        left_ -= taken;
        std::vector<Value> out(count);
        if (count > 0) std::memcpy(out.data(), binary.data() + begin, count * sizeof(Value));
        return out;
    }

    [[noreturn]] static void fail(const std::string& what) { throw Rejected(what); }

    GlbJson json;
    std::string binary;

private:
    GlbParts(GlbChunks chunks, std::size_t left)
        : json(GlbJson::parse(chunks.json)),
          binary(std::move(chunks.binary)),
          left_(left)
    {
    }

    std::size_t left_; // bytes that may still be copied
};

glm::dmat4 matrix_of(const GlbJson& node)
{
    glm::dmat4 out(1);
    for (const char* other : {"translation", "rotation", "scale"})
        if (node.contains(other))
            GlbParts::fail("a node is moved by something other than a matrix");
    if (!node.contains("matrix")) return out;
    for (int i = 0; i < 16; ++i)
        out[i / 4][i % 4] = node.at("matrix").at(static_cast<std::size_t>(i)).get<double>();
    return out;
}

GlbContent::Node content_of(GlbParts& parts, const GlbJson& node)
{
    GlbContent::Node out;
    out.name = node.value("name", "");
    out.to_file = matrix_of(node);
    if (!node.contains("mesh")) return out;
    const GlbJson& mesh = parts.json.at("meshes").at(node.at("mesh").get<std::size_t>());
    GlbJson shared;
    for (const GlbJson& primitive : mesh.at("primitives")) {
        constexpr int triangle_list = 4;
        if (primitive.value("mode", triangle_list) != triangle_list) continue; // lines
        const GlbJson& positions = primitive.at("attributes").at("POSITION");
        if (shared.is_null())
            out.positions = parts.values<glm::vec3>(positions);
        else if (positions != shared)
            GlbParts::fail("the primitives of a mesh stand on different vertices");
        shared = positions;
        const std::vector<std::uint32_t> corners =
            parts.values<std::uint32_t>(primitive.at("indices"));
        out.corners.insert(out.corners.end(), corners.begin(), corners.end());
    }
    for (const std::uint32_t corner : out.corners)
        if (corner >= out.positions.size()) GlbParts::fail("an index names no vertex");
    return out;
}

} // namespace

std::string glb_extras(const std::string& bytes, const std::string& name)
{
    try {
        const GlbJson json = GlbJson::parse(glb_chunks(bytes).json);
        return json.is_object() && json.contains("extras") ? json.at("extras").dump() : "";
    } catch (const Rejected& error) {
        throw Rejected(name + ": " + error.what());
    } catch (const GlbJson::exception&) {
        throw Rejected(name + ": this is not a GLB file as Trivar writes them");
    }
}

GlbContent glb_content_of(const std::string& bytes, const std::string& name)
{
    try {
        GlbParts parts(bytes);
        GlbContent out;
        if (parts.json.contains("extras")) out.extras = parts.json.at("extras").dump();
        const GlbJson nodes = parts.json.value("nodes", GlbJson::array());
        for (const GlbJson& node : nodes) out.nodes.push_back(content_of(parts, node));
        // Parents come before their children, as Trivar writes them.
        for (std::size_t n = 0; n < nodes.size(); ++n)
            for (const GlbJson& child : nodes[n].value("children", GlbJson::array())) {
                const auto c = child.get<std::size_t>();
                if (c <= n || c >= nodes.size()) GlbParts::fail("a node comes before its parent");
                out.nodes[c].to_file = out.nodes[n].to_file * out.nodes[c].to_file;
            }
        return out;
    } catch (const Rejected& error) {
        throw Rejected(name + ": " + error.what());
    } catch (const GlbJson::exception&) {
        throw Rejected(name + ": this is not a GLB file as Trivar writes them");
    }
}

} // namespace trivar
