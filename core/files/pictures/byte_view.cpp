// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/pictures/byte_view.h"

#include "core/base/rejected.h"

#include <fmt/format.h>

namespace trivar {

std::string_view ByteView::part(std::uint64_t at, std::uint64_t count) const
{
    if (at <= size() && count <= size() - at)
        return bytes.substr(static_cast<std::size_t>(at), static_cast<std::size_t>(count));
    if (ends_early) throw Rejected(ends_early);
    throw Rejected(fmt::format("is cut off after {} bytes", size()));
}

} // namespace trivar
