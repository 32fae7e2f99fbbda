// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/volume_source.h"

#include "core/base/rejected.h"
#include "core/files/file_sentences.h"
#include "core/voxels/sample_type.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

constexpr std::uint64_t longest_head = std::uint64_t{4} << 20;

void check_most(std::uint64_t bytes, std::uintmax_t most, const std::string& name)
{
    if (bytes > most)
        throw Rejected(
            fmt::format("{}: has {} bytes, more than the {} allowed", name, bytes, most));
}

} // namespace

VolumeSource::VolumeSource(ByteFile file, std::string name, const std::string& folder,
                           const ReadVolumeOptions& options, Progress progress, int time)
    : file_(std::move(file)),
      name_(std::move(name)),
      files_(folder),
      bytes_left_(options.max_bytes),
      most_in_memory_(options.memory_bytes),
      progress_(std::move(progress)),
      time_(time)
{
    check_most(file_.size(), bytes_left_, name_);
    bytes_left_ -= file_.size();
    head_ = file_.part(0, longest_head, head_buffer_);
}

std::string_view VolumeSource::bytes()
{
    if (file_.size() == head_.size()) return head_;
    if (file_.is_in_memory() || whole_buffer_.empty()) {
        check_most(file_.size(), file_.is_in_memory() ? file_.size() : most_in_memory_, name_);
        return file_.part(0, file_.size(), whole_buffer_);
    }
    return whole_buffer_;
}

std::string VolumeSource::beside(std::string_view name)
{
    const auto found = files_.find(name);
    if (!found)
        refuse(fmt::format("it names the file '{}', which is not in its folder", shown(name)));
    companions_.insert(found->name);
    return found->path;
}

ByteFile VolumeSource::open_beside(std::string_view name)
{
    const std::string path = beside(name);
    ByteFile file = ByteFile::opened(path);
    check_most(file.size(), bytes_left_, path);
    bytes_left_ -= file.size();
    return file;
}

ByteFile VolumeSource::whole(const ByteFile& file, const std::string& name) const
{
    if (file.is_in_memory()) return file;
    check_most(file.size(), most_in_memory_, name);
    std::string bytes;
    file.part(0, file.size(), bytes);
    return ByteFile::kept(std::move(bytes));
}

void VolumeSource::refuse(std::string_view reason) const
{
    throw Rejected(fmt::format("{}: {}", name_, reason));
}

void VolumeSource::say(std::string_view sentence)
{
    notices_.push_back(fmt::format("{}: {}", name_, sentence));
}

} // namespace trivar
