// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/command.h"

#include <optional>
#include <string>
#include <vector>

namespace trivar {

// A CommandForm is a command whose values are filled in one after another, as a person types them:
// "12 mm" and "+=0.1" for a number, "1 2 3" for three, "Snake, Big rock" for objects, "0 1, 0.5 2"
// for points.
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
        std::string typed = {};   // empty: unchanged
        std::string present = {}; // the value of an unchanged field, as it would be typed
    };
    std::string title; // "Set material"
    Command otherwise; // gives the values that are not typed
    std::vector<Field> fields;
    std::size_t at = 0; // the field at hand
    // The one of `options_of` that a hand chose.
    std::optional<std::size_t> chosen = {};
    std::string trouble = {}; // why it did not run
};

// The form of a command; empty where it takes values that nobody types, like files, or no values.
std::optional<CommandForm> form_of(const Command& ready, std::string title,
                                   const Document& document);

// The command with the typed values. Throws Rejected.
Command filled(const CommandForm& form, const Document& document);
// Shows the values of unchanged fields, from a command that `filled` gave.
void show_present(CommandForm& form, const Command& command, const Document& document);

// A FormOption is a possible value of the current field; the best match of what is typed comes
// first. There are none where any value is possible.
struct FormOption {
    std::string typed;                // as it would be typed
    std::string words;                // as it is shown
    Id object = 0;                    // 0: it is none
    std::vector<std::size_t> letters; // of the words that matched
};
std::vector<FormOption> options_of(const CommandForm& form, const Document& document);
// The option that would be taken: the one chosen by hand, or the best match of an incomplete word.
std::optional<std::size_t> taken_option(const CommandForm& form,
                                        const std::vector<FormOption>& options,
                                        const Document& document);
void take(CommandForm& form, const FormOption& option);

} // namespace trivar
