// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/closing.h"

#include <imgui.h>
#include <imgui_internal.h>

namespace trivar::ui {
namespace {

// Closes everything opened in the innermost window since it began, or since there were that many
// fonts.
void close_in_window(int fonts)
{
    ImGui::ErrorCheckEndWindowRecover(nullptr);
    while (ImGui::GetCurrentContext()->FontStack.Size > fonts) ImGui::PopFont();
}

} // namespace

void draw_closing(const std::function<void()>& draw)
{
    const ImGuiContext& context = *ImGui::GetCurrentContext();
    const int windows = context.CurrentWindowStack.Size, fonts = context.FontStack.Size;
    try {
        draw();
    } catch (...) {
        while (context.CurrentWindowStack.Size > windows) {
            close_in_window(context.CurrentWindowStack.back().StackSizesOnBegin.SizeOfFontStack);
            if (context.CurrentWindow->Flags & ImGuiWindowFlags_ChildWindow)
                ImGui::EndChild();
            else
                ImGui::End();
        }
        close_in_window(fonts);
        throw;
    }
}

} // namespace trivar::ui
