// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/camera.h"
#include "core/base/ref.h"
#include "core/mesh/clip.h"
#include "core/mesh/curves.h"

#include <array>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace trivar {

// An image with 8 bits a channel, rows from the top, RGBA.
struct Image {
    std::string name;
    glm::ivec2 size_px{0};
    std::vector<std::uint8_t> rgba; // 4 x width x height; sRGB in colour textures
    std::string source_bytes; // the encoded file as it came, for a lossless way out; may be empty
    std::string mime;         // image/png, image/jpeg, ...
};

struct Texture {
    Ref<Image> image; // null: none
    int uv_set = 0;
    bool repeat_u = true, repeat_v = true;
    bool operator==(const Texture&) const = default;
};

// A Filling is a material that fills a body, in place of textures: its pattern follows from where a
// point is before the body is deformed. No file format stores it.
enum class Filling { none, wood, flesh, metal };

// glTF 2.0's metallic-roughness material. Colours are linear.
struct Material {
    std::string name;
    glm::vec4 base_color{0.8f, 0.8f, 0.8f, 1};
    float metallic = 0;
    float roughness = 0.6f;
    glm::vec3 emissive{0};
    float normal_scale = 1;
    enum class Alpha { opaque, mask, blend } alpha = Alpha::opaque;
    float alpha_cutoff = 0.5f;
    bool double_sided = false;
    Texture base_color_texture, metallic_roughness_texture, normal_texture, occlusion_texture,
        emissive_texture;
    Filling filling = Filling::none;
    bool operator==(const Material&) const = default;
};

// The material of a model whose file describes none: a middle grey, whose relief is seen in bright
// light, where white would be all white.
inline Material unpainted()
{
    Material grey;
    grey.base_color = {0.3f, 0.285f, 0.26f, 1};
    grey.roughness = 0.75f;
    return grey;
}

struct Node {
    std::string name;
    int parent = -1; // index into Model::nodes, always smaller than the node's own
    glm::dmat4 to_parent{1};
    int mesh = -1;                         // index into Model::meshes, or -1: none
    int skin = -1;                         // index into Model::skins, or none: of the mesh
    std::vector<float> morph_weights = {}; // of the mesh's targets; missing ones are 0
    int curves = -1;                       // index into Model::curves, or none; no skin moves them
    int camera = -1;                       // index into Model::cameras, or none
    // The transform of a node that a clip moves: to_parent is outer times the matrix that the clip
    // makes of `rest`.
    glm::dmat4 outer{1};
    NodeTransform rest = {};
};

// A Skin names the nodes that move the vertices of a mesh.
struct Skin {
    std::vector<int> joints;               // indices into Model::nodes
    std::vector<glm::dmat4> mesh_to_joint; // as the mesh was made: "inverse bind matrices"
};

// A Model is the content of a file or a primitive: meshes and curves that hang on a tree of nodes.
// World: Z up, metres.
struct Model {
    std::vector<Node> nodes;
    std::vector<Ref<Mesh>> meshes;
    std::vector<Ref<Curves>> curves;
    // A camera on a node contributes only its angle and size; it looks along the node's -Z.
    std::vector<Camera> cameras;
    std::vector<Material> materials; // at least one
    std::vector<Skin> skins;
    std::vector<Clip> clips;
    std::vector<std::string> notices; // what was repaired on the way in, one sentence each
    std::string extras;               // a JSON object that a GLB gets as its extras; empty: none
};

// Node to model space: the product of to_parent up to the root.
glm::dmat4 node_to_model(const Model& model, int node);

// The number of lines that hang on the model's nodes.
std::size_t line_count(const Model& model);

// A model of one mesh on one root node, with one default material if none is given.
Model single_mesh_model(std::string name, Mesh mesh, std::vector<Material> materials = {});

} // namespace trivar
