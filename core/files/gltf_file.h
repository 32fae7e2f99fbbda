// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/counted_notices.h"
#include "core/files/formats.h"
#include "core/files/gltf_entry.h"

#include <map>
#include <memory>
#include <optional>

namespace trivar {

// A glTF file that was opened: its JSON, of which nothing is believed beyond its version, and its
// buffers. Other files are read from inside its folder only.
class GltfFile {
public:
    // Throws Rejected where the container or the JSON cannot be read, or where the file needs an
    // extension that is not supported; optional ones are a notice. The text must outlive this.
    GltfFile(const FileText& file, bool binary, CountedNotices& notices);
    ~GltfFile();
    GltfFile(const GltfFile&) = delete;
    GltfFile& operator=(const GltfFile&) = delete;

    const std::string& name() const { return file_.name; }
    const GltfEntry& root() const { return *root_; }
    // Of the file and of those that its buffers are in: what memory may be taken in proportion to.
    std::size_t byte_count() const { return byte_count_; }

    // What an entry names by its number in one of the file's lists; `called` is what one of them
    // is. Throws Rejected where it is not there.
    GltfEntry named(const GltfEntry& owner, const char* name, const char* list,
                    const char* called) const;
    // The bytes of the buffer view that an entry names. Throws Rejected where they are not there;
    // a buffer that cannot be had says so only here, since perhaps nothing needs it.
    std::string_view view(const GltfEntry& owner, const char* name) const;

    // The bytes that a uri holds or names; nothing where there is no such file in the folder.
    std::optional<std::string> uri_bytes(std::string_view uri) const;

    // Much may be made of few bytes, of one accessor a thousand times over. What is made stays in
    // proportion to the file, so that a small one cannot fill the memory. Throws Rejected where
    // the things that an entry stands for go beyond that; `called` is what they are.
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
