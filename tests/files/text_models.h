// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/rejected.h"
#include "core/files/read_model.h"

#include <fmt/format.h>
#include <string>
#include <vector>

namespace trivar::testing {

// A TextModel is a small model that any of the formats of text can hold.
struct TextModel {
    std::vector<std::string> vertices; // "x y z"
    std::vector<std::vector<int>> faces;
};

// Two triangles of a square.
inline TextModel square_model()
{
    return {{"0 0 0", "1 0 0", "1 1 0", "0 1 0"}, {{0, 1, 2}, {0, 2, 3}}};
}

inline std::string obj_text(const TextModel& model)
{
    std::string text;
    for (const std::string& v : model.vertices) text += "v " + v + "\n";
    for (const auto& face : model.faces) {
        text += "f";
        for (const int v : face) text += fmt::format(" {}", v + 1);
        text += "\n";
    }
    return text;
}

inline std::string ply_text(const TextModel& model)
{
    std::string text = fmt::format("ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\n"
                                   "property float y\nproperty float z\nelement face {}\n"
                                   "property list uchar int vertex_indices\nend_header\n",
                                   model.vertices.size(), model.faces.size());
    for (const std::string& v : model.vertices) text += v + "\n";
    for (const auto& face : model.faces)
        text += fmt::format("{} {}\n", face.size(), fmt::join(face, " "));
    return text;
}

inline std::string off_text(const TextModel& model)
{
    std::string text = fmt::format("OFF\n{} {} 0\n", model.vertices.size(), model.faces.size());
    for (const std::string& v : model.vertices) text += v + "\n";
    for (const auto& face : model.faces)
        text += fmt::format("{} {}\n", face.size(), fmt::join(face, " "));
    return text;
}

inline std::string stl_text(const TextModel& model)
{
    std::string text = "solid a\n";
    for (const auto& face : model.faces) {
        text += " facet normal 0 0 1\n  outer loop\n";
        for (const int v : face)
            text += "   vertex " + model.vertices[static_cast<std::size_t>(v)] + "\n";
        text += "  endloop\n endfacet\n";
    }
    return text + "endsolid a\n";
}

inline std::string text_of(const TextModel& model, const std::string& extension)
{
    if (extension == ".obj") return obj_text(model);
    if (extension == ".ply") return ply_text(model);
    if (extension == ".stl") return stl_text(model);
    return off_text(model);
}

inline Model read_text_model(const std::string& text, const std::string& extension)
{
    return read_model_bytes(text, "a" + extension, "");
}

// Empty where the file is read.
inline std::string refusal_of(const std::string& text, const std::string& extension)
{
    try {
        read_text_model(text, extension);
        return "";
    } catch (const Rejected& rejected) {
        return rejected.what();
    }
}

} // namespace trivar::testing
