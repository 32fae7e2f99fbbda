// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/text.h"
#include "tests/support/fixtures.h"

#include <gtest/gtest.h>

namespace trivar::testing {

// CopiedShaders is a folder that ShaderFolder takes for a checkout: a copy of the shaders, to be
// changed.
struct CopiedShaders {
    TemporaryFolder folder;
    CopiedShaders()
    {
        for (const char* part : {"gpu/shaders", "core/kernel"}) {
            std::filesystem::create_directories(folder.path() / part);
            std::filesystem::copy(std::filesystem::path(TRIVAR_SOURCE_DIR) / part,
                                  folder.path() / part);
        }
    }
    std::filesystem::path path(const std::string& name) const
    {
        return folder.path() / "gpu/shaders" / name;
    }
    void replace(const std::string& name, const std::string& old, const std::string& by) const
    {
        std::string text = read_text_file(path(name).string());
        const std::size_t at = text.find(old);
        ASSERT_NE(at, std::string::npos) << old;
        write_file(path(name), text.replace(at, old.size(), by));
    }
};

} // namespace trivar::testing
