// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/digest.h"

#include <cstdint>
#include <fmt/format.h>
#include <xxhash.h>

namespace trivar {

struct Digest::State {
    XXH3_state_t* xxh = XXH3_createState();
    ~State() { XXH3_freeState(xxh); }
};

Digest::Digest() : state_(std::make_unique<State>())
{
    XXH3_128bits_reset(state_->xxh);
}

Digest::~Digest() = default;

void Digest::add_bytes(std::span<const std::byte> bytes)
{
    XXH3_128bits_update(state_->xxh, bytes.data(), bytes.size());
}

void Digest::add_text(std::string_view text)
{
    add(static_cast<std::uint64_t>(text.size()));
    add_bytes(std::as_bytes(std::span(text)));
}

std::string Digest::hex() const
{
    const XXH128_hash_t hash = XXH3_128bits_digest(state_->xxh);
    return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

} // namespace trivar
