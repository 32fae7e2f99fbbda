// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/command.h"

#include <optional>
#include <string>
#include <vector>

namespace trivar {

// A command whose values are filled in one after another, as a person types them: "12 mm" and
// "+=0.1" for a number, "1 2 3" for three, "Snake, Big rock" for objects, "0 1, 0.5 2" for points.
struct CommandForm {
    struct Field {
        enum Kind { number, text, choice, object, objects, points };
        std::string name; // "parameters.width": as a typed command has it
        std::string label, unit, help;
        Kind kind = text;
        bool list = false; // of numbers
        std::vector<std::string> choices = {};
        struct Ready { // points that can be taken and changed
            std::string words, typed;
        };
        std::vector<Ready> ready = {};
        std::string typed = {};   // empty: as it is
        std::string present = {}; // the value that it has then, as it would be typed
    };
    std::string title; // "Set material"
    Command otherwise; // the values of what is not typed
    std::vector<Field> fields;
    std::size_t at = 0; // the field at hand
    // Of `options_of` the one that was chosen by hand.
    std::optional<std::size_t> chosen = {};
    std::string trouble = {}; // why it was not run
};

// The form of a command; nothing where it takes what nobody types, like files, or no values.
std::optional<CommandForm> form_of(const Command& ready, std::string title,
                                   const Document& document);

// The command with what was typed. Throws Rejected.
Command filled(const CommandForm& form, const Document& document);
// The values that hold beside those typed, of a command that `filled` gave.
void show_present(CommandForm& form, const Command& command, const Document& document);

// What could stand in the field at hand, the best match of what is typed first; nothing where
// anything can.
struct FormOption {
    std::string typed;                // as it would be typed
    std::string words;                // as it is shown
    Id object = 0;                    // 0: it is none
    std::vector<std::size_t> letters; // of the words that matched
};
std::vector<FormOption> options_of(const CommandForm& form, const Document& document);
// The one that would be taken: chosen by hand, or the best match of what is only begun.
std::optional<std::size_t> taken_option(const CommandForm& form,
                                        const std::vector<FormOption>& options,
                                        const Document& document);
void take(CommandForm& form, const FormOption& option);

} // namespace trivar
