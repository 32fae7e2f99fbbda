// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/companions.h"

#include "core/base/rejected.h"
#include "core/files/file_bytes.h"
#include "core/files/gltf/glb_chunks.h"
#include "core/files/plain_text.h"
#include "core/files/text_scan.h"
#include "core/files/wavefront/wavefront_names.h"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>

namespace trivar {
namespace {

using nlohmann::json;

constexpr std::uintmax_t largest_file = std::uintmax_t{4} << 30;

// Returns the JSON of a GLB; empty if its chunks are damaged, which the reader reports if it
// matters.
std::string json_of_glb(std::string_view bytes)
{
    try {
        return glb_chunks(bytes).json;
    } catch (const Rejected&) {
        return {};
    }
}

class Companions {
public:
    explicit Companions(const std::string& folder) : files_(folder) {}

    void add_of_gltf(std::string_view text)
    {
        const json root = json::parse(text, nullptr, false);
        for (const char* list : {"buffers", "images"}) {
            if (!root.is_object() || !root.contains(list) || !root[list].is_array()) continue;
            for (const json& each : root[list])
                if (each.is_object() && each.contains("uri") && each["uri"].is_string())
                    add(files_.find(each["uri"].get_ref<const std::string&>()));
        }
    }

    void add_of_obj(std::string_view bytes, const std::string& name)
    {
        PlainText plain(bytes, name);
        plain.join_lines();
        std::set<NamedFile> libraries;
        for (TextScan scan(plain.view()); !scan.done(); scan.line())
            if (scan.word() == "mtllib")
                for (NamedFile& each : libraries_named(scan.rest(), files_).found)
                    libraries.insert(std::move(each));
        for (const NamedFile& library : libraries) {
            add(library);
            try {
                add_of_mtl(read_bytes(library.path, largest_file), library.name);
            } catch (const Rejected&) { // reported when the model is read
            }
        }
    }

    std::vector<std::string> names() const { return {names_.begin(), names_.end()}; }

private:
    void add_of_mtl(std::string_view bytes, const std::string& name)
    {
        const PlainText plain(bytes, name);
        for (TextScan scan(plain.view()); !scan.done(); scan.line())
            if (names_picture(scan.word())) add(picture_line(scan.rest(), files_).file);
    }

    void add(const std::optional<NamedFile>& file)
    {
        if (file) names_.insert(file->name);
    }

    FolderFiles files_;
    std::set<std::string> names_;
};

} // namespace

std::vector<std::string> companions_of(const std::string& path)
{
    const std::string extension = extension_of(path);
    if (extension != ".gltf" && extension != ".glb" && extension != ".obj") return {};
    Companions companions(std::filesystem::absolute(path).parent_path().string());
    const std::string bytes = read_bytes(path, largest_file);
    if (extension == ".gltf") companions.add_of_gltf(bytes);
    if (extension == ".glb") companions.add_of_gltf(json_of_glb(bytes));
    if (extension == ".obj") companions.add_of_obj(bytes, path);
    return companions.names();
}

} // namespace trivar
