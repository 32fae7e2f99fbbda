// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/help/about.h"

#include "editor/help/built_with.h"

#include <fmt/format.h>
#include <sstream>

namespace trivar {

std::vector<Library> libraries()
{
    std::vector<Library> all;
    std::istringstream lines(built::libraries);
    for (std::string name, version, licence; std::getline(lines, name, '|') &&
                                             std::getline(lines, version, '|') &&
                                             std::getline(lines, licence);)
        all.push_back({name, version, licence});
    return all;
}

std::string program_version()
{
    return built::version;
}

std::string program_build()
{
    return built::by;
}

std::string about_text(const std::string& graphics)
{
    std::string text = fmt::format("Trivar {}, GPL-3.0-or-later\nBuild: {}\nGraphics: {}\n",
                                   program_version(), program_build(), graphics);
    for (const Library& each : libraries())
        text += fmt::format("{}{}{}, {}\n", each.name, each.version.empty() ? "" : " ",
                            each.version, each.licence);
    return text;
}

} // namespace trivar
