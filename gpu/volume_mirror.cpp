// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/volume_mirror.h"

#include "core/base/rejected.h"
#include "gpu/context.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <type_traits>

namespace trivar::gpu {
namespace {

constexpr float whole_word = 65535;

// Numbers as words from the least to the greatest of them; `number(i)` is finite or not a number.
MirroredSamples as_words(const glm::ivec3& size, auto&& number)
{
    const std::size_t layer = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    float least = std::numeric_limits<float>::max(), greatest = -least;
    for (std::size_t i = 0; i < layer * static_cast<std::size_t>(size.z); ++i)
        if (const float a = number(i); std::isfinite(a)) {
            least = std::min(least, a);
            greatest = std::max(greatest, a);
        }
    if (least > greatest) least = greatest = 0;
    const float range = greatest > least ? greatest - least : 1;
    MirroredSamples out{Texture3D(Texture3D::Texels::words, size), {range, least}};
    std::vector<std::uint16_t> words(layer);
    for (int z = 0; z < size.z; ++z) {
        const std::size_t first = layer * static_cast<std::size_t>(z);
        for (std::size_t i = 0; i < layer; ++i) {
            const float a = number(first + i);
            const float share = std::isfinite(a) ? (a - least) / range : 0;
            words[i] = static_cast<std::uint16_t>(share * whole_word + 0.5f);
        }
        out.texels.write(z, std::span<const std::uint16_t>(words));
    }
    return out;
}

MirroredSamples samples_of(const VoxelField& field)
{
    const glm::ivec3 size = field.grid().size;
    if (!field.goes_through_samples()) {
        const std::vector<float> values = lattice_values(field.field());
        return as_words(size, [&](std::size_t i) { return values[i]; });
    }
    return std::visit(
        [&]<class Sample>(const std::vector<Sample>& all) {
            if constexpr (std::is_same_v<Sample, std::uint8_t>)
                if (!is_software()) {
                    MirroredSamples out{Texture3D(Texture3D::Texels::bytes, size), {255, 0}};
                    out.texels.write(0, std::span<const std::uint8_t>(all));
                    return out;
                }
            if constexpr (std::is_same_v<Sample, std::uint16_t>) {
                MirroredSamples out{Texture3D(Texture3D::Texels::words, size), {whole_word, 0}};
                out.texels.write(0, std::span<const std::uint16_t>(all));
                return out;
            }
            return as_words(size, [&](std::size_t i) { return static_cast<float>(all[i]); });
        },
        field.grid().samples);
}

MirroredSamples coefficients_of(const ScalarField<float>& field)
{
    const glm::ivec3 size = field.size() + 2;
    const auto row = static_cast<std::size_t>(size.x), column = static_cast<std::size_t>(size.y);
    return as_words(size, [&](std::size_t i) {
        const std::size_t line = i / row;
        return field.coefficient(static_cast<int>(i % row) - 1, static_cast<int>(line % column) - 1,
                                 static_cast<int>(line / column) - 1);
    });
}

glm::vec2 after(const glm::dvec2& share_of_sample, const glm::vec2& sample_of_texel)
{
    return {share_of_sample.x * sample_of_texel.x,
            share_of_sample.x * sample_of_texel.y + share_of_sample.y};
}

} // namespace

VolumeMirror::FieldEntry& VolumeMirror::field(const Ref<VoxelField>& field)
{
    auto found = fields_.find(field.get());
    if (found == fields_.end() || found->second.alive.lock() != field)
        found =
            fields_.insert_or_assign(field.get(), FieldEntry{field, samples_of(*field), nullptr})
                .first;
    return found->second;
}

const MirroredVolume* VolumeMirror::volume(const Ref<Casting>& data, bool spline)
{
    try {
        FieldEntry& samples = field(data->field);
        const ScalarField<float>& function = data->field->field();
        spline = spline && function.order() != FieldOrder::linear;
        if (spline && !samples.coefficients)
            samples.coefficients = std::make_unique<MirroredSamples>(coefficients_of(function));
        auto found = volumes_.find(data.get());
        if (found == volumes_.end() || found->second.alive.lock() != data) {
            MirroredVolume made;
            made.transfer = Texture2D::row_of(data->transfer.before);
            made.empty = Texture3D(Texture3D::Texels::numbers, data->empty.count);
            made.empty.write(0, std::span<const std::uint8_t>(data->empty.reach));
            made.open = Texture3D(Texture3D::Texels::bytes, data->open.count);
            made.open.write(0, std::span<const std::uint8_t>(data->open.share));
            made.last = function.end();
            found = volumes_.insert_or_assign(data.get(), VolumeEntry{data, std::move(made)}).first;
        }
        MirroredVolume& out = found->second.volume;
        out.samples = &samples.samples;
        out.coefficients = spline ? samples.coefficients.get() : nullptr;
        out.order = spline ? function.order() : FieldOrder::linear;
        out.sample_share = after(data->share_of_sample, out.samples->share);
        if (spline) out.coefficient_share = after(data->share_of_sample, out.coefficients->share);
        notice_.clear();
        return &out;
    } catch (const Rejected& error) {
        notice_ = error.what();
        return nullptr;
    }
}

void VolumeMirror::drop_dead()
{
    std::erase_if(volumes_, [](const auto& item) { return item.second.alive.expired(); });
    std::erase_if(fields_, [](const auto& item) { return item.second.alive.expired(); });
}

std::size_t VolumeMirror::bytes() const
{
    std::size_t sum = 0;
    for (const auto& [field, entry] : fields_) {
        sum += entry.samples.texels.bytes();
        if (entry.coefficients) sum += entry.coefficients->texels.bytes();
    }
    for (const auto& [data, entry] : volumes_)
        sum += entry.volume.empty.bytes() + entry.volume.open.bytes() +
               static_cast<std::size_t>(entry.volume.transfer.size_px().x) * sizeof(glm::vec4);
    return sum;
}

} // namespace trivar::gpu
