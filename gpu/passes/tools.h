// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/frame.h"
#include "gpu/framebuffer.h"
#include "gpu/mirror.h"
#include "gpu/program.h"
#include "gpu/tiles/tile_mirror.h"
#include "gpu/volume_mirror.h"

#include <functional>

namespace trivar::gpu {

enum class DepthTest { off, less, less_equal, equal, greater };

// A DrawState is the state that a pass sets, so that no pass depends on the one before.
struct DrawState {
    DepthTest depth = DepthTest::off;
    bool write_depth = false, write_color = true, blend = false;
};
void set_state(const DrawState& state);

// A MeshPass is one pass over the meshes of a scene.
struct MeshPass {
    std::string fragment;             // the fragment program, used with mesh.vert
    bool casters = false;             // draws what casts shadows, and not what is seen
    std::vector<std::string> defines; // for every variant
    glm::mat4 scene_to_clip;
    bool reads_material = true; // false: only cut-outs do
    // whether there is a VALUES variant, which shows the values of vertices
    bool value_variant = false;
    // whether there is a PLAIN variant, without textures and vertex colours
    bool plain_variant = false;
    std::function<bool(const SceneItem&, const MirroredMesh::Part&)> wanted;
    // The parts whose backs are left out; empty: the caller sets that state.
    std::function<bool(const SceneItem&, const MirroredMesh::Part&)> without_backs = {};
    std::function<void(const Program&, const SceneItem&)> prepare = {}; // uniforms of its own
};

// Tools are what all passes draw with.
class Tools {
public:
    Tools();
    const Program& use(const ProgramName& name) { return programs_.use(name); }
    Programs& programs() { return programs_; }
    // Sets the shader texts of all programs, also of those that deform: see Programs. Returns
    // whether they changed.
    bool take(const Ref<ShaderTexts>& texts);
    std::string shader_trouble() const;
    Mirror& mirror() { return mirror_; }
    DeformedMeshes& deformed() { return deformed_; }
    VolumeMirror& volumes() { return volumes_; }
    TileMirror& tiles() { return tiles_; }
    const TileMirror& tiles() const { return tiles_; }
    void set_frame(const Frame& frame);
    // Runs the current program over the whole framebuffer, at the far plane.
    void full_screen() const;
    void draw(std::span<const SceneItem> items, const MeshPass& pass);
    // Draws a part; the copies or tiles of an item, if it has any, are one draw.
    void draw(const SceneItem& item, const MirroredMesh::Part& part, const MeshPass& pass);

private:
    Programs programs_;
    Ref<ShaderTexts> texts_;
    Mirror mirror_;
    DeformedMeshes deformed_;
    TileMirror tiles_;
    VolumeMirror volumes_;
    VertexArray nothing_;
    Buffer frame_;
    std::vector<Sampler> samplers_;              // by 2 repeat_u + repeat_v
    int bind_textures(const Material& material); // returns a bit for each that reads the second uv
    void set_material(const Program& program, const Material& material,
                      const std::optional<glm::vec3>& flat_color);
};

// Adds the definitions that place the item's copies in the vertex stage; binds their patches, if
// they are tiles.
void add_placing(std::vector<std::string>& defines, const SceneItem& item);

// Whether the part is opaque: not see-through.
bool opaque(const SceneItem& item, const MirroredMesh::Part& part);

// A full-screen program without variants.
ProgramName full_screen_program(std::string fragment, std::vector<std::string> defines = {});

} // namespace trivar::gpu
