// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/part_taker.h"

#include "core/base/rejected.h"
#include "core/voxels/coarsened.h"

#include <algorithm>
#include <fmt/format.h>
#include <type_traits>

namespace trivar {
namespace {

constexpr std::size_t read_at_once = std::size_t{4} << 20; // bytes; at least a row
constexpr int most_coarsening = 64;

std::size_t size(std::int64_t count)
{
    return static_cast<std::size_t>(count);
}

std::string words_of(const glm::ivec3& n)
{
    return fmt::format("{} x {} x {}", n.x, n.y, n.z);
}

} // namespace

glm::ivec3 GridPart::step() const
{
    return coarsening_steps(box.size(), glm::ivec3(coarsen));
}

glm::ivec3 GridPart::size() const
{
    return box.size() / step();
}

std::uint64_t GridPart::count() const
{
    const glm::u64vec3 n(size());
    return n.x * n.y * n.z;
}

PartTaker::PartTaker(const SampleBlock& whole, const ReadVolumeOptions& options,
                     const std::string& name, Progress progress)
    : whole_(whole),
      options_(options),
      name_(name),
      progress_(std::move(progress))
{
    for (int k = 0; k < 3; ++k)
        part_.whole[k] = static_cast<int>(whole.size[static_cast<std::size_t>(k)]);
    part_.box = options.box.value_or(SampleBox{glm::ivec3(0), part_.whole - 1});
    if (glm::any(glm::lessThan(part_.box.first, glm::ivec3(0))) ||
        glm::any(glm::greaterThanEqual(part_.box.last, part_.whole)) ||
        glm::any(glm::lessThanEqual(part_.box.last, part_.box.first)))
        throw Rejected(fmt::format("{}: a box from sample {}, {}, {} to {}, {}, {} is no part of "
                                   "its {} samples",
                                   name, part_.box.first.x, part_.box.first.y, part_.box.first.z,
                                   part_.box.last.x, part_.box.last.y, part_.box.last.z,
                                   words_of(part_.whole)));
    part_.coarsen = std::max(1, options.coarsen);
    part_.bytes_per_sample = kept_size_of(whole.type);
    fit();
    out_ = samples_for(whole.type, 0);
    slab_ = samples_for(whole.type, 0);
}

void PartTaker::fit()
{
    wants_samples_ = !options_.head_only;
    const auto takes = [&](const GridPart& part) {
        const std::uint64_t slices =
            options_.each_slice ? static_cast<std::uint64_t>(part.size().z) : 1;
        return part.count() / slices * (part.bytes_per_sample + options_.bytes_beside);
    };
    if (!wants_samples_ || takes(part_) <= options_.memory_bytes) return;
    if (options_.if_too_large == TooLarge::head) {
        wants_samples_ = false;
        return;
    }
    GridPart fits = part_;
    while (takes(fits) > options_.memory_bytes && fits.coarsen < most_coarsening) ++fits.coarsen;
    const bool does = takes(fits) <= options_.memory_bytes;
    if (options_.if_too_large == TooLarge::coarsen && does) {
        part_ = fits;
        return;
    }
    too_large_ = fmt::format(
        "{}: its {} samples take {} bytes of memory, more than the {} allowed{}", name_,
        words_of(part_.size()), with_commas(takes(part_)), with_commas(options_.memory_bytes),
        does ? fmt::format("; one for {} along each axis would fit", fits.coarsen) : "");
}

void PartTaker::check_fits() const
{
    if (!too_large_.empty()) throw Rejected(too_large_);
}

bool PartTaker::wants(std::int64_t slice) const
{
    const std::int64_t first = part_.box.first.z,
                       end = first + std::int64_t{part_.size().z} * part_.step().z;
    return wants_samples() && slice >= first && slice < end;
}

void PartTaker::take(const ByteStream& bytes, ByteOrder order)
{
    check_fits();
    const std::size_t row = size(whole_.size[0]) * size_of(whole_.type);
    const auto rows = static_cast<std::uint64_t>(whole_.size[1]);
    const SampleBox& box = part_.box;
    const auto first = static_cast<std::uint64_t>(box.first.y),
               behind = rows - static_cast<std::uint64_t>(box.last.y) - 1;
    std::uint64_t unread = 0; // bytes before the next that are wanted
    std::string buffer;
    for (std::int64_t z = 0; z < whole_.size[2]; ++z) {
        if (!wants(z)) {
            unread += row * rows;
            continue;
        }
        unread += row * first;
        for (std::uint64_t y = first; y + behind < rows;) {
            if (unread > 0) bytes.skip(unread);
            unread = 0;
            const std::uint64_t at_once = std::min<std::uint64_t>(
                rows - behind - y, std::max<std::size_t>(1, read_at_once / row));
            buffer.resize(static_cast<std::size_t>(at_once) * row);
            bytes.read(buffer);
            const TakenSamples taken = taken_samples(buffer, whole_.type, order);
            rounded_ += taken.rounded;
            add_rows(taken.samples, 0, static_cast<std::size_t>(at_once));
            y += at_once;
        }
        unread += row * behind;
        end_slice();
    }
    if (unread > 0) bytes.skip(unread);
}

void PartTaker::take(const TakenSamples& all)
{
    check_fits();
    const auto rows = size(whole_.size[1]);
    for (std::int64_t z = 0; z < whole_.size[2]; ++z) {
        if (!wants(z)) continue;
        add_rows(all.samples, size(z) * rows + size(part_.box.first.y), size(part_.box.size().y));
        end_slice();
    }
    rounded_ += all.rounded;
}

void PartTaker::take_slice(const VoxelGrid::Samples& slice)
{
    check_fits();
    add_rows(slice, size(part_.box.first.y), size(part_.box.size().y));
    end_slice();
}

// Adds rows of the volume, those along x that are in the box, to the slab.
void PartTaker::add_rows(const VoxelGrid::Samples& rows, std::size_t first_row, std::size_t count)
{
    const bool at_once = part_.step() == glm::ivec3(1) && !options_.each_slice;
    std::visit(
        [&](auto& to, const auto& from) {
            if constexpr (std::is_same_v<std::remove_cvref_t<decltype(to)>,
                                         std::remove_cvref_t<decltype(from)>>) {
                // All at once, so that nothing is moved; pages are taken as they are written.
                if (to.capacity() == 0)
                    to.reserve(at_once ? static_cast<std::size_t>(part_.count())
                                       : size(part_.box.size().x) * size(part_.box.size().y) *
                                             size(part_.step().z));
                const std::size_t width = size(whole_.size[0]), first = size(part_.box.first.x),
                                  end = size(part_.box.last.x) + 1;
                const auto row_at = [&](std::size_t row) {
                    return from.begin() + static_cast<std::ptrdiff_t>(row * width);
                };
                if (first == 0 && end == width) {
                    to.insert(to.end(), row_at(first_row), row_at(first_row + count));
                    return;
                }
                for (std::size_t row = first_row; row < first_row + count; ++row)
                    to.insert(to.end(), row_at(row) + static_cast<std::ptrdiff_t>(first),
                              row_at(row) + static_cast<std::ptrdiff_t>(end));
            }
        },
        at_once ? out_ : slab_, rows);
}

void PartTaker::end_slice()
{
    const glm::ivec3 step = part_.step();
    report(progress_, static_cast<double>(given_) / part_.size().z, "Reading");
    if (++in_slab_ < step.z) return;
    in_slab_ = 0;
    const int slice = given_++;
    if (step == glm::ivec3(1)) {
        if (!options_.each_slice) return; // it is in its place already
        options_.each_slice(slice, slab_);
    } else {
        const VoxelGrid::Samples made =
            coarsened_samples(slab_, {part_.box.size().x, part_.box.size().y, step.z}, step);
        if (options_.each_slice)
            options_.each_slice(slice, made);
        else
            std::visit(
                [&](auto& to, const auto& from) {
                    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(to)>,
                                                 std::remove_cvref_t<decltype(from)>>) {
                        if (to.capacity() == 0) to.reserve(static_cast<std::size_t>(part_.count()));
                        to.insert(to.end(), from.begin(), from.end());
                    }
                },
                out_, made);
    }
    std::visit([](auto& all) { all.clear(); }, slab_);
}

} // namespace trivar
