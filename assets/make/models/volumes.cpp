// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "assets/make/field.h"
#include "assets/make/models/phantoms.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>

namespace make {

namespace {

void nrrd(const std::string& path, glm::ivec3 n, vec3 lo, vec3 hi,
          const std::function<float(vec3)>& f)
{
    std::ofstream o(path, std::ios::binary);
    vec3 s = (hi - lo) / vec3(n - 1);
    o << "NRRD0004\ntype: uint8\ndimension: 3\nsizes: " << n.x << " " << n.y << " " << n.z
      << "\nspacings: " << s.x << " " << s.y << " " << s.z << "\nencoding: raw\n\n";
    std::string b;
    for (int z = 0; z < n.z; z++)
        for (int y = 0; y < n.y; y++)
            for (int x = 0; x < n.x; x++)
                b.push_back(char(uint8_t(std::clamp(f(lo + s * vec3(x, y, z)), 0.f, 255.f))));
    o << b;
}

} // namespace

void write_volumes(const std::string& dir)
{
    std::filesystem::create_directories(dir);
    auto grain = [](vec3 p) { return 3.f * noise(p * 140.f); };
    nrrd(dir + "/hand.nrrd", {96, 160, 40}, {-.30f, -.03f, -.085f}, {.23f, .80f, .115f},
         [&](vec3 p) {
             float b = hand_bone(p), s = hand_skin(p), w = .006f;
             float v = 62.f * smooth_step(w, -w, s) + 14.f * smooth_step(-.004f, -.012f, s);
             float cortex = 205.f - 65.f * smooth_step(-.004f, -.011f, b);
             return mix(v, cortex, smooth_step(w * .7f, -w * .7f, b)) + grain(p);
         });
    nrrd(dir + "/jaw.nrrd", {96, 80, 112}, {-.12f, -.02f, -.34f}, {.48f, .45f, .34f}, [&](vec3 p) {
        float b = jaw_bone(p), t = jaw_teeth(p), w = .006f;
        float v = 175.f * smooth_step(w, -w, b) - 35.f * smooth_step(-.012f, -.024f, b);
        return std::max(v, 235.f * smooth_step(w, -w, t)) + grain(p);
    });
    nrrd(dir + "/crystal.nrrd", {80, 80, 80}, vec3(0), vec3(1),
         [](vec3 p) { return 255.f * std::min(1.f, crystal_density(p)); });
}

} // namespace make
