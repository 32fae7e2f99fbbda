// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/document/document_digest.h"
#include "core/export/still_export.h"
#include "tests/support/scenes/commands.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

TEST(Certificates, ComeBackFromTheirJson)
{
    const Document document = testing::small_document();
    Evaluator evaluator(std::make_shared<const AssetStore>("/nowhere"));
    const auto [model, certificate, tiles] = export_of(evaluator(refined_to(document, 1e-3), 1),
                                                       {document, 1e-3, 1, "here/pot.trivar", 7});
    ASSERT_TRUE(certificate);
    EXPECT_TRUE(tiles.empty());
    Certificate c = *certificate;
    EXPECT_EQ(to_json(c), model.extras);
    EXPECT_EQ(c.log, "pot.trivar");
    EXPECT_TRUE(not_certified(c).empty());
    c.not_laid = {{9, "Snake", "its file is missing"}};
    EXPECT_EQ(not_certified(c), std::vector<std::string>{"Snake is not certified: it does not lie "
                                                         "where it should: its file is missing"});
    c.instances = 0.002;
    const std::string text = to_json(c);
    EXPECT_EQ(to_json(certificate_from_json(text)), text);
    ASSERT_FALSE(c.parts.empty());
    EXPECT_LE(c.bound, 1e-3);
    EXPECT_EQ(c.scene, digest(document));
    const Certificate::PartClaim& part = c.parts.front();
    EXPECT_EQ(part.object, 3);
    EXPECT_EQ(model.nodes.at(static_cast<std::size_t>(part.node)).name, "Pot");
    c.lines = -1;
    EXPECT_THROW(certificate_from_json(to_json(c)), Rejected);
    for (const char* text_without : {"", "{}", "{\"trivar_certificate\":{\"version\":9}}"})
        EXPECT_THROW(certificate_from_json(text_without), Rejected);
}

} // namespace
} // namespace trivar
