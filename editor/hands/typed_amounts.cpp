// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/typed_amounts.h"

#include "ui/keys.h"

#include <algorithm>
#include <cctype>
#include <imgui.h>
#include <string_view>

namespace trivar {

bool TypedAmounts::open() const
{
    return std::any_of(texts_.begin(), texts_.end(), [](const auto& t) { return !t.empty(); });
}

bool TypedAmounts::take(char c)
{
    std::string& text = texts_[static_cast<std::size_t>(at_)];
    const bool letter = std::isalpha(static_cast<unsigned char>(c)) != 0;
    const bool begins = (c >= '0' && c <= '9') || c == '-' || c == '.' || c == '=' || c == '(';
    if (text.empty() && !begins) return false;
    if (letter && std::string_view("xyzXYZ").find(c) != std::string_view::npos &&
        !text.starts_with('='))
        return false;
    if (!letter && !begins && std::string_view("+*/^), ").find(c) == std::string_view::npos)
        return false;
    constexpr std::size_t longest = 40; // still fits beside the hints
    if (text.size() < longest) text += c;
    return true;
}

void TypedAmounts::begin_anew()
{
    texts_ = {texts_[static_cast<std::size_t>(at_)], {}, {}};
    at_ = 0;
}

void TypedAmounts::erase_last()
{
    std::string& text = texts_[static_cast<std::size_t>(at_)];
    if (!text.empty()) text.pop_back();
}

std::optional<double> TypedAmounts::value(int i, Measure measure) const
{
    // "1.2 *" is on its way to a number: what stands there so far counts.
    std::string readable = text(i);
    while (!readable.empty()) {
        if (const auto value = evaluate_expression(readable, measure)) return value;
        readable.pop_back();
    }
    return {};
}

std::string TypedAmounts::words(int i, const std::string& unit, const std::string& said) const
{
    const bool at_work = i == at_;
    std::string typed = text(i);
    if (!open() || (!at_work && typed.empty())) return said;
    const bool plain = typed.find_first_not_of("-.0123456789") == std::string::npos;
    if (typed.starts_with('=')) typed.erase(0, 1);
    if (at_work) typed += "|";
    return plain ? typed + unit : typed + " = " + said;
}

bool TypedAmounts::take_letters()
{
    bool taken = false;
    for (const ImWchar c : ImGui::GetIO().InputQueueCharacters)
        taken |= c < 128 && take(static_cast<char>(c));
    if (!open() || !ImGui::IsKeyPressed(ui::key_backspace, true)) return taken;
    erase_last();
    return true;
}

} // namespace trivar
