// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/files/folder_files.h"
#include "core/voxels/byte_stream.h"
#include "core/voxels/volume_options.h"

#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// A VolumeSource is the input of each reader of volumes: the open file, and access to the files
// beside it that it names. Only the requested parts of a large file are read.
class VolumeSource {
public:
    // `name` is that of the file, for sentences; other files are read from `folder`, none if it is
    // empty. Throws Rejected where the file has more bytes than the options allow.
    VolumeSource(ByteFile file, std::string name, const std::string& folder,
                 const ReadVolumeOptions& options, Progress progress = {}, int time = 1);

    const ByteFile& file() const { return file_; }
    std::uint64_t size() const { return file_.size(); }
    const std::string& name() const { return name_; }
    const Progress& progress() const { return progress_; }
    int time() const { return time_; } // of several volumes in the file the one to read, from 1
    // The first bytes, in which heads stand: at most 4 MB.
    std::string_view head() const { return head_; }
    // All bytes, for formats that cannot be read bit by bit; they are kept. Throws Rejected where
    // they are more than the memory that the options allow.
    std::string_view bytes();

    // The path of a file beside it, found as FolderFiles does; it counts as read from now on.
    // Throws Rejected where there is none.
    std::string beside(std::string_view name);
    // Such a file. Throws Rejected, also where all of them are too many bytes.
    ByteFile open_beside(std::string_view name);
    // All bytes of a file, in memory. Throws Rejected where they are more than is allowed.
    ByteFile whole(const ByteFile& file, const std::string& name) const;
    // The names of these files in the folder, each once, sorted.
    std::vector<std::string> companions() const { return {companions_.begin(), companions_.end()}; }

    // Throws Rejected: "name: reason".
    [[noreturn]] void refuse(std::string_view reason) const;
    // Adds a sentence for the user, in which the file's name comes first.
    void say(std::string_view sentence);
    const std::vector<std::string>& notices() const { return notices_; }

private:
    ByteFile file_;
    std::string name_;
    FolderFiles files_;
    std::uintmax_t bytes_left_, most_in_memory_;
    Progress progress_;
    int time_;
    std::string head_buffer_, whole_buffer_;
    std::string_view head_;
    std::set<std::string> companions_;
    std::vector<std::string> notices_;
};

} // namespace trivar
