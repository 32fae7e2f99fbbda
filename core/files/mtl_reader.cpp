// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/files/file_bytes.h"
#include "core/files/formats.h"
#include "core/files/image.h"
#include "core/files/text_scan.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace trivar {
namespace {

class MtlReader {
public:
    explicit MtlReader(const FileText& file) : file_(file) {}

    Mtl read()
    {
        TextScan scan(file_.bytes);
        while (!scan.done()) {
            ++line_;
            read_line(scan.line());
        }
        return std::move(mtl_);
    }

private:
    void read_line(std::string_view text)
    {
        TextScan scan(text);
        const std::string_view keyword = scan.word();
        if (keyword == "newmtl") {
            scan.skip_blanks();
            std::string_view name = text.substr(static_cast<std::size_t>(scan.at - text.data()));
            while (!name.empty() && is_blank(name.back())) name.remove_suffix(1);
            mtl_.materials.emplace_back().name = std::string(name);
            return;
        }
        if (mtl_.materials.empty()) return;
        Material& m = mtl_.materials.back();
        if (keyword == "Kd")
            set_color(m.base_color, scan);
        else if (keyword == "Ke")
            set_color(m.emissive, scan);
        else if (keyword == "d")
            set(m.base_color.w, scan, [](float d) { return d; });
        else if (keyword == "Tr")
            set(m.base_color.w, scan, [](float tr) { return 1 - tr; });
        else if (keyword == "Pm")
            set(m.metallic, scan, [](float pm) { return pm; });
        else if (keyword == "Pr")
            set(m.roughness, scan, [](float pr) { return pr; });
        // A Phong exponent n looks like a roughness r with r^4 = 2 / (n + 2) (B. Walter 2007).
        else if (keyword == "Ns")
            set(m.roughness, scan,
                [](float n) { return std::pow(2 / (std::max(n, 0.0f) + 2), 0.25f); });
        else if (keyword == "map_Kd")
            set_texture(m.base_color_texture, text, scan);
        else if (keyword == "map_Ke")
            set_texture(m.emissive_texture, text, scan);
        else if (keyword == "norm")
            set_texture(m.normal_texture, text, scan);
        m.alpha = m.base_color.w < 1 ? Material::Alpha::blend : Material::Alpha::opaque;
    }

    template <class Convert> void set(float& value, TextScan& scan, Convert convert)
    {
        if (const auto number = scan.number())
            value = std::clamp(convert(static_cast<float>(*number)), 0.0f, 1.0f);
        else
            say_unreadable();
    }

    template <class Color> void set_color(Color& color, TextScan& scan)
    {
        glm::vec3 read(0);
        for (int i = 0; i < 3; ++i) {
            const auto number = scan.number();
            if (!number && i == 0) return say_unreadable();
            read[i] = number ? std::clamp(static_cast<float>(*number), 0.0f, 1e4f) : read[0];
        }
        for (int i = 0; i < 3; ++i) color[i] = read[i];
    }

    // Options begin with a minus; what follows them is the file's name, which may have blanks.
    void set_texture(Texture& texture, std::string_view text, TextScan& scan)
    {
        static const std::map<std::string_view, int> arguments{
            {"-blendu", 1}, {"-blendv", 1}, {"-cc", 1},      {"-clamp", 1}, {"-texres", 1},
            {"-bm", 1},     {"-boost", 1},  {"-imfchan", 1}, {"-type", 1},  {"-mm", 2},
            {"-o", 3},      {"-s", 3},      {"-t", 3}};
        for (scan.skip_blanks(); !scan.done() && *scan.at == '-'; scan.skip_blanks()) {
            const auto option = arguments.find(scan.word());
            if (option == arguments.end()) break;
            for (int i = 0; i < option->second; ++i) {
                const TextScan before = scan;
                if (option->second == 3 && !scan.number()) { // one to three numbers
                    scan = before;
                    break;
                }
                if (option->second < 3) scan.word();
            }
        }
        std::string_view name = text.substr(static_cast<std::size_t>(scan.at - text.data()));
        while (!name.empty() && is_blank(name.back())) name.remove_suffix(1);
        texture.image = image(std::string(name));
    }

    Ref<Image> image(const std::string& name)
    {
        const auto [at, added] = images_.emplace(name, nullptr);
        if (!added) return at->second;
        const auto path = file_inside(file_.folder, name);
        if (!path) {
            say(fmt::format("the picture {} is not in the folder", name));
            return nullptr;
        }
        try {
            at->second = make_ref(pictures_.read(*path));
        } catch (const Rejected& rejected) {
            mtl_.notices.emplace_back(rejected.what());
        }
        return at->second;
    }

    void say(const std::string& what)
    {
        mtl_.notices.push_back(fmt::format("{}: line {}: {}", file_.name, line_, what));
    }
    void say_unreadable()
    {
        if (unreadable_++ == 0)
            say("no finite number; the default is used here and wherever one is missing");
    }

    const FileText& file_;
    Mtl mtl_;
    PictureReader pictures_;
    std::map<std::string, Ref<Image>> images_;
    int line_ = 0, unreadable_ = 0;
};

} // namespace

Mtl read_mtl(const FileText& file)
{
    return MtlReader(file).read();
}

} // namespace trivar
