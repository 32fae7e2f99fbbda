// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/filling_colors.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace kernel {
using namespace glm;

// A FillingKernel is the formulas of core/kernel as C++; the shaders include the same text.
struct FillingKernel {
    float spacing;    // of the vertices, in half diagonals of the box
    int turned_about; // see turning_axis()

    float drawn(float cycles) const { return 1.0f - smoothstep(0.25f, 0.7f, cycles * spacing); }

#include "core/kernel/filling.glsl"

    Stuff stuff_at(vec3 p, Filling filling)
    {
        return filling == Filling::wood    ? wood_at(p)
               : filling == Filling::flesh ? flesh_at(p)
                                           : metal_at(p, turned_about);
    }
};

} // namespace kernel

namespace {

constexpr std::size_t vertices_at_once = 4096;
constexpr float full_tint = 0.8f; // the base colour with which a pattern has its own colours

// A VertexFilling is the material shown at a vertex: that of a face with a pattern that has the
// vertex as a corner, unless a face without one has it too; and the edges at it.
struct VertexFilling {
    const Material* material = nullptr;
    bool plain = false;
    float edges = 0, length = 0;
};

std::vector<VertexFilling> fillings_of(const Mesh& mesh, const Mesh& at_rest,
                                       std::span<const Material> materials)
{
    std::vector<VertexFilling> out(mesh.vertex_count());
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const std::size_t number = mesh.face_material.empty() ? 0 : mesh.face_material[f];
        const bool filled = number < materials.size() && materials[number].filling != Filling::none;
        const std::uint32_t first = mesh.face_begin[f], end = mesh.face_begin[f + 1];
        for (std::uint32_t c = first; c < end; ++c) {
            const std::uint32_t v = mesh.corners[c];
            const std::uint32_t w = mesh.corners[c + 1 < end ? c + 1 : first];
            if (filled)
                out[v].material = &materials[number];
            else
                out[v].plain = true;
            const float length = glm::distance(at_rest.positions[v], at_rest.positions[w]);
            for (const std::uint32_t each : {v, w}) {
                out[each].edges += 1;
                out[each].length += length;
            }
        }
    }
    return out;
}

bool shows_pattern(const VertexFilling& vertex)
{
    return vertex.material && !vertex.plain;
}

} // namespace

std::vector<glm::vec4> filling_colors(const Mesh& mesh, const Mesh& at_rest, const Box& box,
                                      std::span<const Material> materials)
{
    if (std::ranges::none_of(materials,
                             [](const Material& m) { return m.filling != Filling::none; }))
        return {};
    const std::vector<VertexFilling> vertices = fillings_of(mesh, at_rest, materials);
    if (std::ranges::none_of(vertices, shows_pattern)) return {};
    const double radius = glm::length(box.size()) / 2;
    const float scale = radius > 0 ? static_cast<float>(1 / radius) : 1.0f;
    const glm::vec3 middle(box.center());
    const int axis = turning_axis(box);
    std::vector<glm::vec4> out = mesh.colors;
    out.resize(mesh.vertex_count(), glm::vec4(1));
    parallel_blocks(out.size(), vertices_at_once, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
            const VertexFilling& vertex = vertices[v];
            if (!shows_pattern(vertex)) continue;
            kernel::FillingKernel kernel{vertex.length / vertex.edges * scale, axis};
            const glm::vec3 p = (at_rest.positions[v] - middle) * scale;
            const glm::vec3 color = kernel.stuff_at(p, vertex.material->filling).color;
            const glm::vec3 tint = glm::vec3(vertex.material->base_color) / full_tint;
            out[v] = {glm::clamp(color * tint * glm::vec3(out[v]), 0.0f, 1.0f), out[v].w};
        }
    });
    return out;
}

int turning_axis(const Box& box)
{
    constexpr double doubt = 0.02;
    const glm::dvec3 size = box.size();
    const auto unlike = [&](int axis) {
        const double a = size[(axis + 1) % 3], b = size[(axis + 2) % 3];
        return std::abs(a - b) / std::max({a, b, 1e-300});
    };
    int best = 2;
    for (const int axis : {1, 0})
        if (unlike(axis) < unlike(best) - doubt) best = axis;
    return best;
}

Material without_filling(const Material& material)
{
    if (material.filling == Filling::none) return material;
    Material out;
    out.name = material.name;
    out.base_color = {1, 1, 1, material.base_color.a};
    out.emissive = material.emissive;
    out.alpha = material.alpha;
    out.alpha_cutoff = material.alpha_cutoff;
    out.double_sided = material.double_sided;
    out.metallic = material.filling == Filling::metal ? 0.6f : 0.0f;
    out.roughness = material.filling == Filling::wood    ? 0.58f
                    : material.filling == Filling::flesh ? 0.4f
                                                         : 0.37f;
    return out;
}

} // namespace trivar
