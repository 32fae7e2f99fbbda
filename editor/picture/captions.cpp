// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/picture/captions.h"

#include "core/base/number_text.h"
#include "core/base/rounded.h"
#include "core/refinement/refine.h"
#include "gpu/look.h"
#include "ui/headless.h"
#include "ui/widgets.h"

#include <algorithm>
#include <array>

namespace trivar {
namespace {

constexpr std::size_t most_sampled = 600; // of a part, that tell where it is

std::string at_most_mm(double metres)
{
    return ui::short_number(rounded_up(metres * 1000, 3)) + " mm";
}

std::string words_of(const RefinementResult& refined, const Refining& refining)
{
    if (refining.rule == RefinementRule::chua_neumann_midpoint)
        return "by the midpoint test, nothing certified";
    static constexpr std::array<const char*, 4> split{
        "by curvature", "at midpoints", "at Greville points", "at the greatest error"};
    const std::string how =
        refining.rule == RefinementRule::thesis_four_split
            ? "split in four"
            : std::string("split ") + split.at(static_cast<std::size_t>(refining.split));
    const std::size_t open = refined.not_certified();
    return how + ", " +
           (open > 0 ? with_commas(open) + " not certified"
                     : "certified to " + at_most_mm(refined.bound));
}

std::vector<glm::dvec3> points_of(const EvaluatedObject& object)
{
    std::vector<glm::dvec3> out;
    for (const Part& part : with_points(object.parts, object.curves)) {
        const std::vector<glm::vec3>& p = part.before_volume()->positions;
        const std::size_t step = 1 + p.size() / most_sampled;
        for (std::size_t i = 0; i < p.size(); i += step)
            out.push_back(part.bent
                              ? deform(glm::dvec3(p[i]), part.bent->embedding, *part.bent->volume)
                                    .position_world
                              : glm::dvec3(part.to_world * glm::dvec4(p[i], 1)));
    }
    return out;
}

// The middle of the lower edge of what is seen of it, pixels.
std::optional<glm::vec2> foot_of(const Caption& caption, const Camera& camera)
{
    glm::dvec2 lo(1e300), hi(-1e300);
    for (const glm::dvec3& p : caption.points) {
        const PicturePoint at = project(camera, p);
        if (at.depth_world <= 0) continue;
        lo = glm::min(lo, at.p_px);
        hi = glm::max(hi, at.p_px);
    }
    if (!(lo.x <= hi.x)) return std::nullopt;
    return glm::vec2((lo.x + hi.x) / 2, hi.y);
}

} // namespace

std::vector<Caption> captions_of(const Evaluation& evaluated, const Document& document,
                                 std::span<const Id> hidden_here)
{
    std::vector<Caption> out;
    for (const auto& [id, object] : evaluated.objects) {
        const auto cause = document.objects.find(id); // it may be deleted since
        if (!object->refined || cause == document.objects.end() || !cause->second->refining ||
            std::ranges::binary_search(hidden_here, id))
            continue;
        const std::size_t count = object->refined->triangles();
        out.push_back({with_commas(count) + (count == 1 ? " triangle" : " triangles"),
                       words_of(*object->refined, *cause->second->refining), points_of(*object)});
    }
    return out;
}

std::vector<CaptionPlace> caption_places(const std::vector<Caption>& captions, const ui::Rect& view,
                                         const Camera& camera, const ui::Theme& theme)
{
    std::vector<CaptionPlace> out;
    for (const Caption& caption : captions) {
        const std::optional<glm::vec2> foot = foot_of(caption, camera);
        if (!foot) continue;
        const glm::vec2 size{std::max(ui::text_width(theme.font.title, caption.title),
                                      ui::text_width(theme.font.body, caption.words)) +
                                 theme.px(28),
                             theme.px(56)};
        const glm::vec2 spare = glm::max(view.size() - size - theme.px(12), theme.px(12));
        const glm::vec2 at = glm::clamp(*foot + glm::vec2(-size.x / 2, theme.px(10)),
                                        glm::vec2(theme.px(12)), spare);
        out.push_back({&caption, ui::rect_at(view.lo + glm::round(at), size)});
    }
    std::ranges::stable_sort(out, {}, [](const CaptionPlace& each) { return each.rect.lo.y; });
    for (std::size_t i = 0; i < out.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) {
            ui::Rect &rect = out[i].rect, &other = out[k].rect;
            const ui::Rect grown = other.grown(theme.px(6));
            if (rect.hi.x <= grown.lo.x || rect.lo.x >= grown.hi.x || rect.hi.y <= grown.lo.y ||
                rect.lo.y >= grown.hi.y)
                continue;
            rect = ui::rect_at({rect.lo.x, grown.hi.y}, rect.size());
        }
    return out;
}

void paint_captions(const std::vector<Caption>& captions, const ui::Rect& view,
                    const Camera& camera, const ui::Theme& theme)
{
    const ui::Palette& c = theme.color;
    for (const auto& [caption, rect] : caption_places(captions, view, camera, theme)) {
        ui::paint_box(rect, c.chip, theme.size.rounding_card);
        const float middle = rect.lo.y + theme.px(31);
        ui::paint_text(theme.font.title,
                       {{rect.lo.x, rect.lo.y + theme.px(7)}, {rect.hi.x, middle}}, c.chip_text,
                       caption->title, ui::Align::center);
        ui::paint_text(theme.font.body, {{rect.lo.x, middle}, {rect.hi.x, rect.hi.y - theme.px(7)}},
                       ui::faded(c.chip_text, 0.78f), caption->words, ui::Align::center);
    }
}

Image with_captions(Image image, const std::vector<Caption>& captions, const Camera& camera,
                    const RenderSettings& settings)
{
    if (captions.empty()) return image;
    const glm::vec2 size(image.size_px);
    constexpr float usual_px = 540;
    ui::ThemeOptions options;
    options.scale = std::clamp(std::min(size.x, size.y) / usual_px, 0.75f, 3.0f);
    options.look.light = !gpu::is_dark(settings.look);
    Camera of_image = camera;
    of_image.size_px = glm::dvec2(image.size_px);
    return ui::drawn_over(image, options, [&](ui::Frame& frame) {
        paint_captions(captions, {glm::vec2(0), size}, of_image, frame.theme);
    });
}

// Drawn over black they are their own light; over white, what comes through beside that.
DeepImage with_captions(DeepImage image, const std::vector<Caption>& captions, const Camera& camera,
                        const RenderSettings& settings)
{
    if (captions.empty()) return image;
    const auto over = [&](std::uint8_t gray) {
        Image ground;
        ground.size_px = image.size_px;
        ground.rgba.assign(image.rgba.size(), gray);
        for (std::size_t i = 3; i < ground.rgba.size(); i += 4) ground.rgba[i] = 255;
        return with_captions(std::move(ground), captions, camera, settings).rgba;
    };
    const std::vector<std::uint8_t> black = over(0), white = over(255);
    for (std::size_t i = 0; i < image.rgba.size(); ++i) {
        if (i % 4 == 3) continue;
        const unsigned through = white[i] - std::min(black[i], white[i]);
        image.rgba[i] = static_cast<std::uint16_t>(257u * black[i] + image.rgba[i] * through / 255);
    }
    return image;
}

} // namespace trivar
