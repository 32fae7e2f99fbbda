// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/counted_notices.h"
#include "core/files/formats.h"
#include "core/files/gltf/gltf_entry.h"

#include <map>
#include <memory>
#include <optional>

namespace trivar {

// A GltfFile is an opened glTF file: its JSON, of which only the version has been checked, and its
// buffers. Other files are read from inside its folder only.
class GltfFile {
public:
    // Throws Rejected where the container or the JSON cannot be read, or where the file needs an
    // unsupported extension; optional ones become a notice. The text must outlive the GltfFile.
    GltfFile(const FileText& file, bool binary, CountedNotices& notices);
    ~GltfFile();
    GltfFile(const GltfFile&) = delete;
    GltfFile& operator=(const GltfFile&) = delete;

    const std::string& name() const { return file_.name; }
    const GltfEntry& root() const { return *root_; }
    // The size of the file and of its buffers' files: memory may be used in proportion to it.
    std::size_t byte_count() const { return byte_count_; }

    // The entry that another entry names by its number in one of the file's lists; `called` is the
    // word for one of them. Throws Rejected where it does not exist.
    GltfEntry named(const GltfEntry& owner, const char* name, const char* list,
                    const char* called) const;
    // The bytes of the buffer view that an entry names. Throws Rejected where they do not exist; a
    // buffer that cannot be read is reported only here, because perhaps nothing needs it.
    std::string_view view(const GltfEntry& owner, const char* name) const;

    // The bytes that a uri holds or names; empty where there is no such file in the folder.
    std::optional<std::string> uri_bytes(std::string_view uri) const;

    // Counts the things made from the file, so that they stay in proportion to the file and a small
    // file cannot fill the memory, for example with one accessor used a thousand times. Throws
    // Rejected if the things of an entry exceed that; `called` is the word for them.
    void account(const GltfEntry& owner, std::size_t count, const char* called,
                 std::size_t bytes_each);

private:
    struct Buffer {
        std::string_view bytes;
        std::string trouble; // why there are none
    };
    Buffer opened(const GltfEntry& buffer, std::optional<std::string_view> binary);

    const FileText& file_;
    std::unique_ptr<nlohmann::json> json_;
    std::unique_ptr<GltfEntry> root_;
    std::size_t byte_count_, bytes_left_ = 0;
    std::vector<Buffer> buffers_;
    std::map<std::string_view, std::string> by_uri_; // two buffers may lie in one file
};

} // namespace trivar
