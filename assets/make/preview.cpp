// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/preview.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>

namespace make {

namespace {

constexpr int view_px = 640, oversampling = 2, raster_px = view_px * oversampling;
constexpr vec3 backdrop(.86f, .88f, .90f);

struct Vertex {
    vec3 at; // x, y in raster pixels, z towards the eye
    vec3 shade;
};

struct Raster {
    std::vector<float> depth = std::vector<float>(raster_px * raster_px, -1e9f);
    std::vector<vec3> color = std::vector<vec3>(raster_px * raster_px, backdrop);

    void draw(const Vertex& a, const Vertex& b, const Vertex& c)
    {
        const auto area = [](vec3 p, vec3 q, vec3 r) {
            return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
        };
        const float whole = area(a.at, b.at, c.at);
        if (whole <= 0) return;
        const auto first = [](float p, float q, float r) {
            return std::max(0, int(std::min({p, q, r})));
        };
        const auto last = [](float p, float q, float r) {
            return std::min(raster_px - 1, int(std::max({p, q, r})) + 1);
        };
        for (int y = first(a.at.y, b.at.y, c.at.y); y <= last(a.at.y, b.at.y, c.at.y); ++y) {
            for (int x = first(a.at.x, b.at.x, c.at.x); x <= last(a.at.x, b.at.x, c.at.x); ++x) {
                const vec3 p(x, y, 0);
                const float wa = area(p, b.at, c.at) / whole, wb = area(p, c.at, a.at) / whole;
                const float wc = 1 - wa - wb;
                if (wa < 0 || wb < 0 || wc < 0) continue;
                const float z = wa * a.at.z + wb * b.at.z + wc * c.at.z;
                const int i = y * raster_px + x;
                if (z <= depth[i]) continue;
                depth[i] = z;
                color[i] = wa * a.shade + wb * b.shade + wc * c.shade;
            }
        }
    }
};

struct View {
    vec3 right, up, toward_eye;
    vec2 center;
    float scale; // raster pixels a unit
};

View frame(vec3 toward_eye, vec3 lo, vec3 hi)
{
    const bool from_above = toward_eye.y > .99f;
    View view{{}, {}, toward_eye, {}, 1};
    view.right =
        glm::normalize(glm::cross(from_above ? vec3(0, 0, -1) : vec3(0, 1, 0), toward_eye));
    view.up = glm::cross(toward_eye, view.right);
    vec2 a(1e9f), b(-1e9f);
    for (int i = 0; i < 8; ++i) {
        const vec3 q(i & 1 ? lo.x : hi.x, i & 2 ? lo.y : hi.y, i & 4 ? lo.z : hi.z);
        const vec2 t(glm::dot(q, view.right), glm::dot(q, view.up));
        a = glm::min(a, t);
        b = glm::max(b, t);
    }
    view.scale = raster_px * .94f / std::max(b.x - a.x, b.y - a.y);
    view.center = .5f * (a + b);
    return view;
}

std::vector<Vertex> seen(const Mesh& mesh, const Material& material, const mat4& world,
                         const View& view)
{
    const vec3 d = view.toward_eye;
    const vec3 light = glm::normalize(view.right * -.5f + view.up * .8f + d * .7f);
    const std::vector<vec3> normal = normals(mesh);
    std::vector<Vertex> result;
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        const vec3 p(world * vec4(mesh.points[i], 1)), n = glm::normalize(mat3(world) * normal[i]);
        const vec2 at =
            (vec2(glm::dot(p, view.right), glm::dot(p, view.up)) - view.center) * view.scale +
            raster_px / 2.f;
        const vec3 base = mesh.colors.empty() ? material.color : mesh.colors[i] * material.color;
        const float diffuse = .30f + .18f * n.y + .62f * std::max(0.f, glm::dot(n, light));
        const float gloss = std::pow(std::max(0.f, glm::dot(n, glm::normalize(light + d))), 30.f);
        result.push_back({{at.x, at.y, glm::dot(p, d)},
                          base * diffuse + gloss * .22f * (1 - material.rough * .8f)});
    }
    return result;
}

} // namespace

void write_preview(const Model& model, const std::string& path, int clip, int key)
{
    const std::vector<mat4> world = world_matrices(model, clip, key);
    vec3 lo(1e9f), hi(-1e9f);
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        for (const Mesh& part : model.nodes[n].parts) {
            for (const vec3& p : part.points) {
                lo = glm::min(lo, vec3(world[n] * vec4(p, 1)));
                hi = glm::max(hi, vec3(world[n] * vec4(p, 1)));
            }
        }
    }
    const vec3 eyes[4] = {{.75f, .5f, .85f}, {.0001f, .02f, 1}, {0, 1, .001f}, {1, .12f, .22f}};
    std::vector<vec3> picture(4 * view_px * view_px, vec3(0));
    for (int v = 0; v < 4; ++v) {
        const View view = frame(glm::normalize(eyes[v]), lo, hi);
        Raster raster;
        for (std::size_t n = 0; n < model.nodes.size(); ++n) {
            for (const Mesh& part : model.nodes[n].parts) {
                const std::vector<Vertex> q =
                    seen(part, model.materials[part.material], world[n], view);
                for (const Face& f : part.faces) {
                    raster.draw(q[f[0]], q[f[1]], q[f[2]]);
                    if (f[3] >= 0) raster.draw(q[f[0]], q[f[2]], q[f[3]]);
                }
            }
        }
        for (int y = 0; y < raster_px; ++y) {
            for (int x = 0; x < raster_px; ++x) {
                const int row = view_px - 1 - y / oversampling + v / 2 * view_px;
                picture[row * 2 * view_px + x / oversampling + v % 2 * view_px] +=
                    raster.color[y * raster_px + x] / float(oversampling * oversampling);
            }
        }
    }
    std::ofstream file(path, std::ios::binary);
    file << "P6 " << 2 * view_px << " " << 2 * view_px << " 255\n";
    for (const vec3& k : picture) {
        for (int i = 0; i < 3; ++i) {
            file.put(char(std::uint8_t(glm::clamp(k[i], 0.f, 1.f) * 255)));
        }
    }
}

} // namespace make
