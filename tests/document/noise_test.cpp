// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluation/evaluate.h"
#include "tests/document/commands.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

TEST(Noise, ShiftsEveryVertexALittleAndTheSameEveryTime)
{
    const Document plain = after(Document{}, AddSphere{});
    const Document shifted = after(plain, AddNoise{{1}, {.amount = 0.01}});
    const auto shown = [](const Document& document) {
        return Evaluator(std::make_shared<const AssetStore>("/nowhere"))(document);
    };
    const Mesh a = *shown(plain).objects.at(1)->parts.at(0).mesh(),
               b = *shown(shifted).objects.at(1)->parts.at(0).mesh();
    for (std::size_t v = 0; v < a.positions.size(); ++v)
        EXPECT_LT(glm::distance(a.positions[v], b.positions[v]), 0.01f);
    EXPECT_NE(a.positions, b.positions);
    EXPECT_EQ(digest(shown(shifted)), digest(shown(shifted)));
}

} // namespace
} // namespace trivar
