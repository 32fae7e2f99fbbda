// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"
#include "core/document/document_digest.h"
#include "core/scene/log.h"

#include <filesystem>
#include <gtest/gtest.h>

namespace trivar {
namespace {

const std::filesystem::path logs = TRIVAR_SOURCE_DIR "/tests/logs";

TEST(Logs, OfEveryFormatVersionStayReadableAndMeanTheSame)
{
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(logs / "versions")) {
        const std::string name = entry.path().string();
        History history;
        const Log log = read_log(read_text_file(name), name);
        for (const LogLine& line : log.lines) {
            apply(history, line, name);
            if (line.digest.empty()) continue;
            EXPECT_EQ(digest(history.document()), line.digest) << name << ":" << line.number;
        }
        EXPECT_FALSE(history.document().objects.empty());
        ++files;
    }
    EXPECT_GE(files, log_version);
}

TEST(Logs, ThatAreWrongAreRefusedWithTheirLine)
{
    for (const auto& entry : std::filesystem::directory_iterator(logs / "rejected")) {
        const std::string name = entry.path().filename().string();
        try {
            replay(read_log(read_text_file(entry.path().string()), name));
            ADD_FAILURE() << name << " was read";
        } catch (const Rejected& error) {
            EXPECT_EQ(std::string(error.what()).rfind(name + ":", 0), 0u) << error.what();
        }
    }
}

} // namespace
} // namespace trivar
