// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/write_model.h"

#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace make {

namespace {

std::string line(const char* keyword, std::initializer_list<float> values)
{
    std::string text = keyword;
    for (float v : values) {
        char number[32];
        std::snprintf(number, sizeof number, " %.6g", double(v));
        text += number;
    }
    return text + "\n";
}

} // namespace

void write_obj(const Mesh& mesh, const std::string& path, const std::vector<Crease>& creases)
{
    std::ofstream file(path);
    for (const vec3& p : mesh.points) file << line("v", {p.x, p.y, p.z});
    for (std::size_t f = 0; f < mesh.uvs.size(); ++f) {
        for (std::size_t k = 0; k < (mesh.faces[f][3] < 0 ? 3u : 4u); ++k) {
            file << line("vt", {mesh.uvs[f][k].x, mesh.uvs[f][k].y});
        }
    }
    int uv = 0;
    for (const Face& face : mesh.faces) {
        file << "f";
        for (int i : face) {
            if (i < 0) continue;
            file << " " << i + 1;
            if (!mesh.uvs.empty()) file << "/" << ++uv;
        }
        file << "\n";
    }
    for (const Crease& c : creases) { // OpenSubdiv's shape files count points from 0 here
        file << "t crease 2/1/0 " << c.a << " " << c.b << line("", {c.sharpness});
    }
    file.close();
    if (!file) throw std::runtime_error("cannot write " + path);
}

} // namespace make
