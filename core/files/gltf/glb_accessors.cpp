// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/gltf/glb_accessors.h"

#include "core/base/box.h"
#include "core/base/rejected.h"
#include "core/base/text.h"

#include <algorithm>
#include <limits>

namespace trivar {

double plain(float value)
{
    if (const auto number = parse_number(shortest(value))) return *number;
    throw Rejected("a number of the model is not finite, so it cannot be written as glTF");
}

int GlbAccessors::add_view(const void* data, std::size_t size, int target)
{
    binary.resize((binary.size() + 3) / 4 * 4, '\0');
    GlbEntries view{{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", size}};
    if (target != 0) view["target"] = target;
    binary.append(static_cast<const char*>(data), size);
    json["bufferViews"].push_back(std::move(view));
    return static_cast<int>(json["bufferViews"].size()) - 1;
}

void GlbAccessors::set_range(const std::vector<glm::vec3>& values)
{
    glm::vec3 lo(std::numeric_limits<float>::max()), hi = -lo;
    for (const glm::vec3& p : values) lo = glm::min(lo, p), hi = glm::max(hi, p);
    json["accessors"].back()["min"] = {plain(lo.x), plain(lo.y), plain(lo.z)};
    json["accessors"].back()["max"] = {plain(hi.x), plain(hi.y), plain(hi.z)};
}

int GlbAccessors::add_differences(const std::vector<glm::vec3>& values)
{
    std::vector<std::uint32_t> where;
    std::vector<glm::vec3> what;
    for (std::size_t v = 0; v < values.size(); ++v)
        // One is written even of zeros: some programs read no accessor without a buffer.
        if (values[v] != glm::vec3(0) || (where.empty() && v + 1 == values.size())) {
            where.push_back(static_cast<std::uint32_t>(v));
            what.push_back(values[v]);
        }
    constexpr std::size_t sparse_bytes = 16, dense_bytes = 12; // bytes per difference
    if (sparse_bytes * where.size() >= dense_bytes * values.size()) {
        add(values, "VEC3");
    } else {
        const int indices = add_view(where.data(), where.size() * 4, 0);
        json["accessors"].push_back(
            {{"componentType", float32},
             {"count", values.size()},
             {"type", "VEC3"},
             {"sparse",
              {{"count", where.size()},
               {"indices", {{"bufferView", indices}, {"componentType", uint32}}},
               {"values", {{"bufferView", add_view(what.data(), what.size() * 12, 0)}}}}}});
    }
    set_range(values);
    return static_cast<int>(json["accessors"].size()) - 1;
}

GlbEntries GlbAccessors::attributes(const Mesh& mesh)
{
    GlbEntries result;
    result["POSITION"] = add(mesh.positions, "VEC3");
    set_range(mesh.positions);
    if (!mesh.normals.empty()) result["NORMAL"] = add(mesh.normals, "VEC3");
    if (!mesh.tangents.empty()) result["TANGENT"] = add(mesh.tangents, "VEC4");
    if (!mesh.colors.empty()) {
        std::vector<glm::vec4> colors = mesh.colors;
        for (glm::vec4& color : colors) color = glm::clamp(color, 0.0f, 1.0f);
        result["COLOR_0"] = add(colors, "VEC4");
    }
    for (std::size_t set = 0; set < mesh.uvs.size(); ++set) {
        std::vector<glm::vec2> uvs = mesh.uvs[set];
        for (glm::vec2& uv : uvs) uv.y = 1 - uv.y; // v of glTF points down
        result["TEXCOORD_" + std::to_string(set)] = add(uvs, "VEC2");
    }
    return result;
}

namespace {

// Makes a primitive of separate lines of two points each, or of one line through all points.
GlbEntries line_primitive(GlbAccessors& to, const Mesh& points, std::size_t first, std::size_t end,
                          bool pairs)
{
    const auto part = [&](const auto& values) {
        return std::vector(values.begin() + static_cast<std::ptrdiff_t>(first),
                           values.begin() + static_cast<std::ptrdiff_t>(end));
    };
    Mesh own;
    own.positions = part(points.positions);
    if (!points.colors.empty()) own.colors = part(points.colors);
    enum : int { lines = 1, line_strip = 3 };
    return {{"attributes", to.attributes(own)}, {"mode", pairs ? lines : line_strip}};
}

} // namespace

GlbEntries curve_primitives(GlbAccessors& to, const Curves& curves, std::size_t materials)
{
    GlbEntries out = GlbEntries::array();
    const auto is_pair = [&](std::size_t line) {
        return line < curves.line_count() && curves.begin[line + 1] - curves.begin[line] == 2;
    };
    for (std::size_t line = 0, next = 0; line < curves.line_count(); line = next) {
        const std::uint32_t material = curves.material_of(line);
        const bool pairs = is_pair(line) && is_pair(line + 1);
        for (next = line + 1; pairs && is_pair(next) && curves.material_of(next) == material;)
            ++next;
        out.push_back(
            line_primitive(to, *curves.points, curves.begin[line], curves.begin[next], pairs));
        if (material < materials) out.back()["material"] = material;
    }
    return out;
}

WrittenInstances add_instances(GlbAccessors& to, const std::vector<NodeTransform>& instances)
{
    Box box;
    for (const NodeTransform& each : instances) box.add(each.translation);
    WrittenInstances out{box.center(), {}};
    std::vector<glm::vec3> translations, scales;
    std::vector<glm::vec4> rotations; // x y z w
    for (const NodeTransform& each : instances) {
        translations.emplace_back(each.translation - out.middle);
        const glm::dquat& q = each.rotation;
        rotations.emplace_back(q.x, q.y, q.z, q.w);
        scales.emplace_back(each.scale);
    }
    const int no_target = 0;
    out.attributes["TRANSLATION"] = to.add(translations, "VEC3", no_target);
    const auto is_not = [](const auto& neutral) {
        return [neutral](const auto& value) { return value != neutral; };
    };
    if (std::ranges::any_of(rotations, is_not(glm::vec4(0, 0, 0, 1))))
        out.attributes["ROTATION"] = to.add(rotations, "VEC4", no_target);
    if (std::ranges::any_of(scales, is_not(glm::vec3(1))))
        out.attributes["SCALE"] = to.add(scales, "VEC3", no_target);
    return out;
}

} // namespace trivar
