// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/digest.h"

#include <array>
#include <gtest/gtest.h>
#include <vector>

namespace trivar {
namespace {

std::string of_text(std::string_view text)
{
    Digest d;
    d.add_bytes(std::as_bytes(std::span(text)));
    return d.hex();
}

// XXH3's own 128-bit values for no bytes and for "a": xxhsum -H2.
TEST(Digest, IsXxh3)
{
    EXPECT_EQ(Digest().hex(), "99aa06d3014798d86001c324468d497f");
    EXPECT_EQ(of_text("a"), "a96faf705af16834e6c632b61e964e1f");
}

TEST(Digest, DoesNotDependOnHowTheBytesWereCut)
{
    const std::string text(5000, 'x');
    for (const std::size_t cut : {0u, 1u, 256u, 4999u}) {
        Digest d;
        d.add_bytes(std::as_bytes(std::span(text).first(cut)));
        d.add_bytes(std::as_bytes(std::span(text).subspan(cut)));
        EXPECT_EQ(d.hex(), of_text(text));
    }
}

TEST(Digest, TellsTextsApartThatJoinToTheSame)
{
    Digest a, b;
    a.add_text("ab");
    a.add_text("c");
    b.add_text("a");
    b.add_text("bc");
    EXPECT_NE(a.hex(), b.hex());
}

TEST(Digest, OfValuesIsThatOfTheirBytesInOrder)
{
    const std::array<double, 2> values{1.5, -0.0};
    Digest together, apart, swapped;
    together.add(std::span<const double>(values));
    apart.add(values[0]);
    apart.add(values[1]);
    swapped.add(values[1]);
    swapped.add(values[0]);
    EXPECT_EQ(together.hex(), apart.hex());
    EXPECT_NE(together.hex(), swapped.hex());
}

TEST(Digest, CanBeReadOnTheWay)
{
    Digest d;
    d.add(1);
    const std::string once = d.hex();
    EXPECT_EQ(d.hex(), once);
    EXPECT_EQ(once.size(), 32u);
    d.add(2);
    EXPECT_NE(d.hex(), once);
}

} // namespace
} // namespace trivar
