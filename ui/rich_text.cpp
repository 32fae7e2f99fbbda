// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/rich_text.h"

#include <imgui.h>

namespace trivar::ui {
namespace {

// A Word is never broken; several stand side by side if no space is between them.
struct Word {
    Run::Kind kind;
    std::string text;
    const std::string* target;
    bool space_before;
    float width = 0;
};

const ImFont* font_of(const RichStyle& style, Run::Kind kind)
{
    return kind == Run::Kind::strong ? style.strong : style.font;
}

std::vector<Word> words_of(const Theme& theme, const RichStyle& style, const std::vector<Run>& runs)
{
    std::vector<Word> words;
    bool space = false;
    for (const Run& run : runs) {
        std::string_view rest = run.text;
        while (!rest.empty()) {
            if (rest.front() == ' ' || rest.front() == '\n') {
                space = true;
                rest.remove_prefix(1);
                continue;
            }
            const std::size_t end = std::min(rest.find_first_of(" \n"), rest.size());
            Word word{run.kind, std::string(rest.substr(0, end)), &run.target, space};
            word.width = run.kind == Run::Kind::key
                             ? keycap_width(theme, word.text)
                             : text_width(font_of(style, run.kind), word.text);
            words.push_back(std::move(word));
            space = false;
            rest.remove_prefix(end);
        }
    }
    return words;
}

// Calls place(word, x, y) for each word, from the upper left corner; returns the height.
template <class Place>
float laid_out(const Theme& theme, const RichStyle& style, const std::vector<Word>& words,
               float width, Place&& place)
{
    const float space = text_width(style.font, " ");
    float x = 0, y = 0;
    for (std::size_t i = 0; i < words.size();) {
        std::size_t end = i + 1;
        float together = words[i].width;
        for (; end < words.size() && !words[end].space_before; ++end) together += words[end].width;
        const bool caps = i > 0 && words[i].kind == Run::Kind::key &&
                          words[i - 1].kind == Run::Kind::key; // of one chord
        const float before = x == 0 ? 0 : caps ? theme.px(4) : space;
        if (x > 0 && x + before + together > width) {
            x = 0;
            y += style.line;
        } else {
            x += before;
        }
        for (; i < end; ++i) {
            place(words[i], x, y);
            x += words[i].width;
        }
    }
    return words.empty() ? 0 : y + style.line;
}

} // namespace

float rich_height(const Theme& theme, const RichStyle& style, const std::vector<Run>& runs,
                  float width)
{
    return laid_out(theme, style, words_of(theme, style, runs), width, [](auto&&...) {});
}

DrawnText draw_rich(const Theme& theme, const RichStyle& style, const std::vector<Run>& runs,
                    glm::vec2 at, float width)
{
    DrawnText drawn;
    int links = 0;
    const std::vector<Word> words = words_of(theme, style, runs);
    drawn.height = laid_out(theme, style, words, width, [&](const Word& word, float x, float y) {
        const Rect r = rect_at(at + glm::vec2(x, y), {word.width, style.line});
        if (word.kind == Run::Kind::key) {
            paint_keycap(theme, r.lo, style.line, word.text);
            return;
        }
        Color ink = word.kind == Run::Kind::strong ? style.strong_ink : style.ink;
        if (word.kind == Run::Kind::link) {
            ink = theme.color.accent_text;
            ImGui::PushID(links++);
            ImGui::SetCursorScreenPos({r.lo.x, r.lo.y});
            if (ImGui::InvisibleButton("link", {r.width(), r.height()}))
                drawn.clicked = *word.target;
            if (ImGui::IsItemHovered()) {
                ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
                const float base = r.center().y + style.line * 0.32f;
                paint_line({r.lo.x, base}, {r.hi.x, base}, ink, theme.size.hairline);
            }
            ImGui::PopID();
        }
        paint_text(font_of(style, word.kind), r, ink, word.text);
    });
    return drawn;
}

} // namespace trivar::ui
