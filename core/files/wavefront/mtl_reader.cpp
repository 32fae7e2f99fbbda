// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/files/file_bytes.h"
#include "core/files/file_sentences.h"
#include "core/files/formats.h"
#include "core/files/pictures/image.h"
#include "core/files/plain_text.h"
#include "core/files/text_scan.h"
#include "core/files/wavefront/wavefront_names.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <set>

namespace trivar {
namespace {

constexpr std::uintmax_t max_picture_bytes = std::uintmax_t{1} << 30;

class MtlReader {
public:
    explicit MtlReader(const FileText& file)
        : file_(file),
          plain_(file.bytes, file.name),
          files_(file.folder)
    {
    }

    Mtl read()
    {
        TextScan scan(plain_.view());
        while (!scan.done()) {
            ++line_;
            read_line(scan.line());
        }
        say_what_was_left_out();
        return std::move(mtl_);
    }

private:
    void read_line(std::string_view text)
    {
        TextScan scan(text);
        keyword_ = scan.word();
        if (keyword_ == "newmtl") {
            mtl_.materials.emplace_back().name = std::string(scan.rest());
            return;
        }
        if (mtl_.materials.empty()) return;
        Material& m = mtl_.materials.back();
        if (keyword_ == "Kd")
            set_color(m.base_color, scan);
        else if (keyword_ == "Ke")
            set_color(m.emissive, scan);
        else if (keyword_ == "d")
            set(m.base_color.w, scan, [](float d) { return d; });
        else if (keyword_ == "Tr")
            set(m.base_color.w, scan, [](float tr) { return 1 - tr; });
        else if (keyword_ == "Pm")
            set(m.metallic, scan, [](float pm) { return pm; });
        else if (keyword_ == "Pr")
            set(m.roughness, scan, [](float pr) { return pr; });
        // A Phong exponent n looks like a roughness r with r^4 = 2 / (n + 2) (B. Walter 2007).
        else if (keyword_ == "Ns")
            set(m.roughness, scan,
                [](float n) { return std::pow(2 / (std::max(n, 0.0f) + 2), 0.25f); });
        else if (keyword_ == "map_Kd")
            set_texture(m.base_color_texture, scan);
        else if (keyword_ == "map_Ke")
            set_texture(m.emissive_texture, scan);
        else if (keyword_ == "norm")
            m.normal_scale = set_texture(m.normal_texture, scan);
        else if (names_picture(keyword_))
            kinds_.emplace(shown(keyword_));
        m.alpha = m.base_color.w < 1 ? Material::Alpha::blend : Material::Alpha::opaque;
    }

    template <class Convert> void set(float& value, TextScan& scan, Convert convert)
    {
        if (const auto number = scan.number())
            value = std::clamp(convert(static_cast<float>(*number)), 0.0f, 1.0f);
        else
            say_unreadable(scan);
    }

    template <class Color> void set_color(Color& color, TextScan& scan)
    {
        glm::vec3 read(0);
        for (int i = 0; i < 3; ++i) {
            const auto number = scan.number();
            if (!number && i == 0) return say_unreadable(scan);
            read[i] = number ? std::clamp(static_cast<float>(*number), 0.0f, 1e4f) : read[0];
        }
        for (int i = 0; i < 3; ++i) color[i] = read[i];
    }

    // Sets a texture and returns the strength of a normal map.
    float set_texture(Texture& texture, const TextScan& scan)
    {
        const PictureLine line = picture_line(TextScan(scan).rest(), files_);
        for (const std::string& option : line.left_out) options_.insert(shown(option));
        texture.repeat_u = texture.repeat_v = !line.clamped;
        if (line.file)
            texture.image = image(*line.file);
        else if (line.name.empty())
            unnamed_.add(fmt::format("line {}", line_));
        else if (sought_.insert(line.name).second)
            missing_.add(fmt::format("{} (line {})", shown(line.name), line_));
        return static_cast<float>(std::clamp(line.strength, -100.0, 100.0));
    }

    Ref<Image> image(const NamedFile& file)
    {
        const auto [at, added] = images_.emplace(file.path, nullptr);
        if (!added) return at->second;
        if (file.in_other_case) other_case_.add(file.name);
        try {
            const std::string bytes = read_bytes(file.path, max_picture_bytes);
            const glm::dvec2 size_px(picture_size(bytes, file.name));
            pixels_ += size_px.x * size_px.y;
            if (pixels_ > static_cast<double>(max_pixels_per_model))
                throw Rejected(fmt::format("{}: it was left out, because the pictures of the model "
                                           "have too many pixels in all",
                                           file.name));
            at->second = make_ref(pictures_.read_bytes(bytes, file.name));
        } catch (const Rejected& rejected) {
            mtl_.notices.emplace_back(rejected.what());
        }
        return at->second;
    }

    void say_unreadable(const TextScan& scan)
    {
        if (unreadable_++ == 0)
            first_unreadable_ = fmt::format("line {}: {} {}", line_, keyword_, not_a_number(scan));
    }

    void say_what_was_left_out()
    {
        const auto say = [&](const std::string& what) {
            mtl_.notices.push_back(fmt::format("{}: {}", file_.name, what));
        };
        const auto names = [](const std::set<std::string>& from) {
            NameList list;
            for (const std::string& each : from) list.add(each);
            return list.text();
        };
        if (unreadable_ > 0)
            say(first_unreadable_ + "; it was left out" +
                (unreadable_ == 1
                     ? ""
                     : " with " + counted(unreadable_ - 1, "line", "lines") + " more of its kind"));
        if (missing_.count() > 0)
            say(fmt::format("{} not in the model's folder: {}",
                            counted(missing_.count(), "picture is", "pictures are"),
                            missing_.text()));
        if (unnamed_.count() > 0)
            say(fmt::format("{}: a picture's file must be named there", unnamed_.text()));
        if (other_case_.count() > 0)
            say(fmt::format("{} named with other capitals than in the folder: {}",
                            counted(other_case_.count(), "picture is", "pictures are"),
                            other_case_.text()));
        if (!kinds_.empty())
            say(fmt::format("the pictures of {} were left out; those of map_Kd, map_Ke and norm "
                            "are read",
                            names(kinds_)));
        if (!options_.empty())
            say(fmt::format("options of its pictures were left out: {}", names(options_)));
    }

    const FileText& file_;
    PlainText plain_;
    FolderFiles files_;
    Mtl mtl_;
    PictureReader pictures_;
    double pixels_ = 0;                        // of all pictures together
    std::map<std::string, Ref<Image>> images_; // by path
    std::string_view keyword_;
    std::string first_unreadable_;
    NameList missing_, unnamed_, other_case_;
    std::set<std::string> sought_, kinds_, options_;
    std::size_t line_ = 0, unreadable_ = 0;
};

} // namespace

Mtl read_mtl(const FileText& file)
{
    return MtlReader(file).read();
}

} // namespace trivar
