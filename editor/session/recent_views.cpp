// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/session/recent_views.h"

#include "core/base/rejected.h"
#include "core/document/check_view.h"

#include <algorithm>
#include <fmt/format.h>
#include <locale>
#include <sstream>

namespace trivar {
namespace {

bool is_of(const std::string& line, const std::string& path)
{
    return line.size() > path.size() && line.ends_with(path) &&
           line[line.size() - path.size() - 1] == '\t';
}

} // namespace

std::optional<Camera> view_of(const std::vector<std::string>& lines, const std::string& path)
{
    const auto line =
        std::ranges::find_if(lines, [&](const std::string& each) { return is_of(each, path); });
    if (path.empty() || line == lines.end()) return std::nullopt;
    std::istringstream in(line->substr(0, line->size() - path.size()));
    in.imbue(std::locale::classic());
    Camera c;
    in >> c.eye.x >> c.eye.y >> c.eye.z >> c.target.x >> c.target.y >> c.target.z >>
        c.perspective >> c.fov_y >> c.height_world >> c.size_px.x >> c.size_px.y;
    if (!in) return std::nullopt;
    try {
        check_view(c);
    } catch (const Rejected&) { // the file was changed by another hand
        return std::nullopt;
    }
    return c;
}

void remember_view_of(std::vector<std::string>& lines, const std::string& path,
                      const Camera& camera, std::size_t most)
{
    std::erase_if(lines, [&](const std::string& each) { return is_of(each, path); });
    const Camera& c = camera;
    lines.insert(lines.begin(),
                 fmt::format("{} {} {} {} {} {} {} {} {} {} {}\t{}", c.eye.x, c.eye.y, c.eye.z,
                             c.target.x, c.target.y, c.target.z, c.perspective ? 1 : 0, c.fov_y,
                             c.height_world, c.size_px.x, c.size_px.y, path));
    if (lines.size() > most) lines.resize(most);
}

} // namespace trivar
