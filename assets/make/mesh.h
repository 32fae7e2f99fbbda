// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <string>
#include <utility>
#include <vector>

// The generator of the sample models. Lengths are scene units, Y is up, colours are sRGB in 0..1.
namespace make {

using glm::mat3;
using glm::mat4;
using glm::quat;
using glm::vec2;
using glm::vec3;
using glm::vec4;

using Face = std::array<int, 4>; // counter-clockwise from outside; a triangle when [3] == -1
inline std::size_t corner_count(const Face& face)
{
    return face[3] < 0 ? 3 : 4;
}

// One or several closed pieces of one material, as a modeller sees them: a point is stored once,
// whatever its seams; texture coordinates sit on the corners.
struct Mesh {
    std::vector<vec3> points;
    std::vector<vec3> colors; // #points, or empty
    std::vector<Face> faces;
    std::vector<std::array<vec2, 4>> uvs; // #faces, or empty
    int material = 0;

    Mesh& add(const Mesh& other);
    Mesh& move(vec3 by);
    Mesh& scale(vec3 by); // a mirroring scale also turns the faces round
    Mesh& turn(float angle_deg, vec3 axis);
    Mesh& apply(const mat4& matrix);
    Mesh& warp(const std::function<vec3(vec3)>& map);
    Mesh& paint(const std::function<vec3(vec3)>& color);
    Mesh& mat(int index);
};

Mesh mirrored(const Mesh& mesh); // across z = 0
void orient_outward(Mesh& mesh); // turns every face round when the enclosed volume is negative

// #points unit normals, weighted by area so that flats stay flat beside bevels.
std::vector<vec3> normals(const Mesh& mesh);

struct Texture { // 3 bytes a texel, rows from v = 0
    glm::ivec2 size_px{0};
    std::vector<std::uint8_t> rgb;
};

struct Material {
    std::string name;
    vec3 color;
    float rough = .7f, metal = 0;
    Texture texture = {}; // empty: none
    float alpha = 1;      // opacity
    float glow = 0;       // light that it gives off, in its own colour, times this
};

struct Node {
    std::string name;
    int parent = -1; // always smaller than the node's own index
    vec3 translation{0};
    quat rotation{1, 0, 0, 0};
    std::vector<Mesh> parts;
};

struct Channel { // either translations or rotations, one a key
    int node;
    std::vector<vec3> translations;
    std::vector<quat> rotations;
};

struct Clip {
    std::string name;
    std::vector<float> times_s;
    std::vector<Channel> channels;
};

// Which joints a point of the root's mesh goes with, by their places in the skin's list.
struct Influence {
    std::array<std::uint8_t, 4> joints{};
    vec4 weights{1, 0, 0, 0}; // sum 1
};

struct Skin {                // of the root's mesh
    std::vector<int> joints; // nodes; none: no skin
    std::function<Influence(vec3)> at = {};
};

struct Model {
    std::string name;
    std::vector<Material> materials;
    std::vector<Node> nodes;
    std::vector<Clip> clips;
    Skin skin = {};
    std::vector<std::pair<std::string, std::string>> extras; // JSON values on the root node

    int material(const std::string& label, vec3 color, float rough = .7f, float metal = 0);
    int node(const std::string& label, int parent = -1, vec3 translation = vec3(0));
    Node& root(); // made when there is none yet
};

// Node to world, at rest or at one key of a clip.
std::vector<mat4> world_matrices(const Model& model, int clip = -1, int key = 0);

vec3 srgb(unsigned hex);      // 0xrrggbb
vec3 linear_light(vec3 srgb); // IEC 61966-2-1's curve

} // namespace make
