// SPDX-License-Identifier: GPL-3.0-or-later
// glTF files as JSON, to be changed and read.
#pragma once

#include "core/base/rejected.h"
#include "core/files/pictures/image.h"
#include "core/files/read_model.h"
#include "tests/files/sample_models.h"
#include "tests/support/rigged.h"

#include <nlohmann/json.hpp>

namespace trivar::testing {

using GltfText = nlohmann::json;

inline std::string data_uri(const std::string& bytes)
{
    return "data:application/octet-stream;base64," + base64(bytes);
}

// A triangle with texture coordinates; every part of the file is the only one of its kind.
inline GltfText triangle_gltf()
{
    const float numbers[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, /* texture coordinates */ 0, 0, 1, 0, 0, 1};
    const std::string bytes(reinterpret_cast<const char*>(numbers), sizeof numbers);
    return GltfText::parse(R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
        "nodes":[{"mesh":0}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1}}]}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},
                     {"bufferView":0,"byteOffset":36,"componentType":5126,"count":3,"type":"VEC2"}],
        "bufferViews":[{"buffer":0,"byteLength":60}],
        "buffers":[{"byteLength":60,"uri":")" +
                           data_uri(bytes) + "\"}]}");
}

// The same with a material and a picture on it.
inline GltfText textured_gltf()
{
    GltfText out = triangle_gltf();
    out["meshes"][0]["primitives"][0]["material"] = 0;
    out["materials"] =
        GltfText::parse(R"([{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}])");
    out["textures"] = GltfText::parse(R"([{"source":0,"sampler":0}])");
    out["samplers"] = GltfText::parse(R"([{"wrapS":33071}])");
    out["images"] = {{{"uri", data_uri(encoded_image(checker_image(), ".png"))}}};
    return out;
}

inline Model read_gltf_text(const GltfText& text, const std::string& folder = "")
{
    return read_model_bytes(text.dump(), "a.gltf", folder);
}

// Empty where the file was read.
inline std::string gltf_refusal(const std::string& bytes, const std::string& name)
{
    try {
        read_model_bytes(bytes, name, "");
        return "";
    } catch (const Rejected& why) {
        return why.what();
    }
}

inline std::string gltf_refusal(const GltfText& text)
{
    return gltf_refusal(text.dump(), "a.gltf");
}

} // namespace trivar::testing
