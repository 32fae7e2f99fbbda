// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/passes/tools.h"

#include <array>
#include <epoxy/gl.h>
#include <fmt/format.h>

namespace trivar::gpu {
namespace {

constexpr unsigned first_material_unit = 8; // surface.glsl
constexpr unsigned frame_binding = 0;       // frame.glsl

struct Slot {
    const Texture* texture;
    bool srgb;
};
std::array<Slot, 5> slots_of(const Material& m)
{
    return {{{&m.base_color_texture, true},
             {&m.metallic_roughness_texture, false},
             {&m.normal_texture, false},
             {&m.occlusion_texture, false},
             {&m.emissive_texture, true}}};
}

bool usable(const Texture& texture)
{
    if (!texture.image) return false;
    const glm::ivec2 size = texture.image->size_px;
    const int largest = largest_texture_px();
    return size.x > 0 && size.y > 0 && size.x <= largest && size.y <= largest &&
           texture.image->rgba.size() == static_cast<std::size_t>(size.x) * size.y * 4;
}

// A bit for each texture that the material has, in the order of slots_of().
int textures_of(const Material& material)
{
    int bits = 0, slot = 0;
    for (const Slot& s : slots_of(material)) bits |= (usable(*s.texture) ? 1 : 0) << slot++;
    return bits;
}

} // namespace

void set_state(const DrawState& state)
{
    const bool test = state.depth != DepthTest::off;
    (test ? glEnable : glDisable)(GL_DEPTH_TEST);
    glDepthFunc(state.depth == DepthTest::less_equal ? GL_LEQUAL
                : state.depth == DepthTest::equal    ? GL_EQUAL
                : state.depth == DepthTest::greater  ? GL_GREATER
                                                     : GL_LESS);
    glDepthMask(state.write_depth);
    const GLboolean color = state.write_color;
    glColorMask(color, color, color, color);
    (state.blend ? glEnable : glDisable)(GL_BLEND);
    // The picture stays opaque whatever is blended into it.
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glDisable(GL_CULL_FACE);
    glDisable(GL_SCISSOR_TEST);
    glEnable(GL_FRAMEBUFFER_SRGB);
}

bool opaque(const SceneItem& item, const MirroredMesh::Part& part)
{
    return !item.see_through(part);
}

ProgramName full_screen_program(std::string fragment, std::vector<std::string> defines)
{
    return {"full", std::move(fragment), std::move(defines)};
}

void add_placing(std::vector<std::string>& defines, const SceneItem& item)
{
    if (!item.copies) return;
    defines.emplace_back("COPIES");
    if (!item.copies->patches) return;
    defines.emplace_back("TILES");
    if (item.copies->footprints) defines.emplace_back("FOOTPRINTS");
    item.copies->patches->bind();
}

Tools::Tools()
{
    using Edge = Sampler::Edge;
    for (const Edge u : {Edge::clamp, Edge::repeat})
        for (const Edge v : {Edge::clamp, Edge::repeat}) samplers_.emplace_back(u, v, true);
}

bool Tools::take(const Ref<ShaderTexts>& texts)
{
    if (texts == texts_) return false;
    texts_ = texts;
    programs_.take(texts);
    deformed_.take(texts);
    return true;
}

std::string Tools::shader_trouble() const
{
    const std::string trouble = programs_.trouble();
    return trouble.empty() ? deformed_.shader_trouble() : trouble;
}

void Tools::set_frame(const Frame& frame)
{
    frame_.write(std::as_bytes(std::span(&frame, 1)));
    glBindBufferBase(GL_UNIFORM_BUFFER, frame_binding, frame_.name());
}

void Tools::full_screen() const
{
    nothing_.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

int Tools::bind_textures(const Material& material)
{
    int second_uv = 0;
    unsigned slot = 0;
    for (const auto& [texture, srgb] : slots_of(material)) {
        if (usable(*texture)) {
            mirror_.texture(texture->image, srgb).bind(first_material_unit + slot);
            samplers_[2 * texture->repeat_u + texture->repeat_v].bind(first_material_unit + slot);
            if (texture->uv_set == 1) second_uv |= 1 << slot;
        }
        ++slot;
    }
    return second_uv;
}

void Tools::set_material(const Program& program, const Material& material,
                         const std::optional<glm::vec3>& flat_color)
{
    const bool mask = material.alpha == Material::Alpha::mask;
    const bool opaque = material.alpha == Material::Alpha::opaque;
    glm::vec4 base = material.base_color;
    if (opaque) base.a = 1;
    program.set("base_color", base);
    program.set("emissive_color",
                glm::vec4(flat_color.value_or(material.emissive), material.normal_scale));
    program.set("roughness_metallic",
                glm::vec4(flat_color ? -1 : material.roughness, material.metallic,
                          material.double_sided ? 1 : 0, mask ? material.alpha_cutoff : -1));
    program.set("second_uv", bind_textures(material));
}

void Tools::draw(const SceneItem& item, const MirroredMesh::Part& part, const MeshPass& pass)
{
    const Material& material = item.material(part.material);
    const bool mask = material.alpha == Material::Alpha::mask;
    const bool reads = pass.reads_material || mask;
    ProgramName name{"mesh", pass.fragment, pass.defines};
    const bool values = item.shows_values() && pass.value_variant;
    const bool fills =
        !values && item.rest && pass.reads_material && material.filling != Filling::none;
    if (values)
        name.defines.emplace_back("VALUES");
    else if (fills)
        name.defines.push_back(fmt::format("SOLID {}", static_cast<int>(material.filling)));
    else if (reads && textures_of(material))
        name.defines.push_back(fmt::format("TEXTURES {}", textures_of(material)));
    else if (pass.plain_variant && !mask && !item.mesh->colored)
        name.defines.emplace_back("PLAIN");
    if (mask && !values && !fills) name.defines.emplace_back("MASKED");
    add_placing(name.defines, item);
    if (item.deformed_as_drawn) {
        const std::vector<std::string>& more = item.deformed_as_drawn->defines;
        name.defines.insert(name.defines.end(), more.begin(), more.end());
        deformed_.bind(*item.deformed_as_drawn);
    }
    const Program& program = programs_.use(name);
    program.set("to_scene", item.to_scene);
    program.set("normal_to_scene", item.normal_to_scene);
    program.set("scene_to_clip", pass.scene_to_clip);
    if (reads) set_material(program, material, item.flat_color);
    if (pass.prepare) pass.prepare(program, item);
    if (item.values && values) item.mesh->vertices.attribute(7, *item.values, 1, sizeof(float));
    if (fills) {
        item.mesh->vertices.attribute(6, *item.rest, 3, sizeof(glm::vec3));
        program.set("rest_middle", item.rest_middle);
        program.set("turned_about", item.turned_about);
    }
    if (item.copies)
        item.copies->feed(item.mesh->vertices, item.first_copy, values && item.values_by_copy);
    glFrontFace(item.mirrored ? GL_CW : GL_CCW);
    item.mesh->vertices.bind();
    if (item.copies) {
        const auto number = static_cast<std::size_t>(&part - item.mesh->parts().data());
        item.copies->draw(GL_TRIANGLES, part.count, part.first, item.drawn_count(), number);
    } else {
        const auto offset = static_cast<std::size_t>(part.first) * sizeof(std::uint32_t);
        glDrawElements(GL_TRIANGLES, part.count, GL_UNSIGNED_INT,
                       reinterpret_cast<const void*>(offset));
    }
}

void Tools::draw(std::span<const SceneItem> items, const MeshPass& pass)
{
    // Defaults for meshes without these attributes: no tangent, white, no texture coordinates.
    glVertexAttrib3f(1, 0, 0, 1);
    glVertexAttrib4f(2, 1, 0, 0, 0);
    glVertexAttrib4f(3, 1, 1, 1, 1);
    glVertexAttrib2f(4, 0, 0);
    glVertexAttrib2f(5, 0, 0);
    if (pass.without_backs) glCullFace(GL_BACK);
    for (const SceneItem& item : items)
        for (const MirroredMesh::Part& part : item.mesh->parts()) {
            if (!(pass.casters ? item.casts : item.seen) || !pass.wanted(item, part)) continue;
            if (item.drawn_count() == 0) continue; // of tiles, none is seen
            if (pass.without_backs)
                (pass.without_backs(item, part) ? glEnable : glDisable)(GL_CULL_FACE);
            draw(item, part, pass);
        }
    if (pass.without_backs) glDisable(GL_CULL_FACE);
}

} // namespace trivar::gpu
