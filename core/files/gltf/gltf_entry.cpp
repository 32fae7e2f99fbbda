// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/gltf/gltf_entry.h"

#include "core/base/rejected.h"
#include "core/base/text.h"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace trivar {
namespace {

using EntryJson = nlohmann::json;

constexpr const char *whole_words = "a whole number from 0 up", *object_words = "an object",
                     *text_words = "text";

std::string in_quotes(std::string_view text)
{
    constexpr std::size_t longest = 40;
    const std::string_view rest = text.size() > longest ? "..." : "";
    return fmt::format("'{}{}'", printable(text.substr(0, longest)), rest);
}

std::string words_for(const EntryJson& value)
{
    switch (value.type()) {
    case EntryJson::value_t::object: return "an object";
    case EntryJson::value_t::array: return fmt::format("a list of {}", value.size());
    case EntryJson::value_t::string:
        return "the text " + in_quotes(value.get_ref<const std::string&>());
    default: return value.dump();
    }
}

std::optional<std::string_view> text_of(const EntryJson& value)
{
    if (!value.is_string()) return {};
    return value.get_ref<const std::string&>();
}

std::optional<bool> flag_of(const EntryJson& value)
{
    return value.is_boolean() ? std::optional(value.get<bool>()) : std::nullopt;
}

std::optional<double> number_of(const EntryJson& value)
{
    return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
}

// Returns the value if it is a whole number. JSON has one kind of number: 3.0 is whole, too.
std::optional<std::size_t> whole_of(const EntryJson& value)
{
    constexpr double beyond = 9007199254740992.0; // 2^53: doubles above skip whole numbers
    const double number = value.is_number() ? value.get<double>() : -1;
    if (!(number >= 0 && number < beyond) || number != std::floor(number)) return {};
    return static_cast<std::size_t>(number);
}

// Returns an index; none for -1, which some programs write for a missing index.
std::optional<int> index_of(const EntryJson& value)
{
    if (value == -1) return -1;
    const std::optional<std::size_t> size = whole_of(value);
    if (!size || *size > std::size_t{std::numeric_limits<int>::max()}) return {};
    return static_cast<int>(*size);
}

} // namespace

GltfEntry::GltfEntry(const Json& root, const std::string& file_name)
    : value_(&root),
      file_name_(&file_name)
{
    if (!root.is_object())
        fail(fmt::format("its JSON is damaged: it is {}, but must be an object", words_for(root)));
}

GltfEntry::GltfEntry(const Json& value, const GltfEntry& owner, const char* called,
                     std::optional<std::size_t> number)
    : value_(&value),
      owner_(&owner),
      file_name_(owner.file_name_),
      called_(called),
      number_(number)
{
    if (!value.is_object())
        fail(fmt::format("this is {}, but must be an object", words_for(value)));
}

std::string GltfEntry::place() const
{
    if (!owner_) return {};
    std::string out = owner_->place();
    if (!out.empty()) out += ", ";
    const bool tells_more = role_[0] != '\0' && role_ != std::string_view(called_);
    if (tells_more) out += fmt::format("{} (", role_);
    out += called_;
    if (number_) out += fmt::format(" {}", *number_);
    if (tells_more) out += ")";
    if (const auto name = value_->find("name");
        value_->is_object() && name != value_->end() && name->is_string() && *name != "")
        out += " " + in_quotes(name->get_ref<const std::string&>());
    return out;
}

void GltfEntry::fail(const std::string& what) const
{
    const std::string where = place();
    throw Rejected(fmt::format("{}: {}{}{}", *file_name_, where, where.empty() ? "" : ": ", what));
}

void GltfEntry::refuse(const char* name, const std::string& wanted) const
{
    const Json* found = find(name);
    fail(found ? fmt::format("'{}' is {}, but must be {}", name, words_for(*found), wanted)
               : fmt::format("'{}' is missing and must be {}", name, wanted));
}

const EntryJson* GltfEntry::find(const char* name) const
{
    const auto at = value_->find(name);
    return at == value_->end() || at->is_null() ? nullptr : &*at;
}

const EntryJson* GltfEntry::list(const char* name) const
{
    const Json* found = find(name);
    if (found && !found->is_array()) refuse(name, "a list");
    return found;
}

template <class Value>
std::optional<Value> GltfEntry::read(const char* name, const char* wanted,
                                     std::optional<Value> (*value)(const Json&)) const
{
    const Json* found = find(name);
    if (!found) return {};
    std::optional<Value> read = value(*found);
    if (!read) refuse(name, wanted);
    return read;
}

template <class Value>
std::vector<Value> GltfEntry::read_list(const char* name, const char* wanted,
                                        std::optional<Value> (*value)(const Json&)) const
{
    const Json* found = list(name);
    if (!found) return {};
    std::vector<Value> out;
    out.reserve(found->size());
    for (const Json& each : *found) {
        const std::optional<Value> read = value(each);
        if (!read)
            fail(fmt::format("'{}' has {} at number {}, but all in it must be {}", name,
                             words_for(each), out.size(), wanted));
        out.push_back(*read);
    }
    return out;
}

bool GltfEntry::has(const char* name) const
{
    return find(name) != nullptr;
}

std::string_view GltfEntry::text(const char* name) const
{
    return read(name, text_words, text_of).value_or("");
}

bool GltfEntry::flag(const char* name) const
{
    return read(name, "true or false", flag_of).value_or(false);
}

double GltfEntry::number(const char* name, double otherwise) const
{
    return read(name, "a number", number_of).value_or(otherwise);
}

std::size_t GltfEntry::size(const char* name, std::size_t otherwise) const
{
    return read(name, whole_words, whole_of).value_or(otherwise);
}

int GltfEntry::index(const char* name) const
{
    return read(name, whole_words, index_of).value_or(-1);
}

std::vector<int> GltfEntry::indices(const char* name) const
{
    return read_list(name, "whole numbers from 0 up", index_of);
}

std::vector<std::string_view> GltfEntry::texts(const char* name) const
{
    return read_list(name, text_words, text_of);
}

std::vector<double> GltfEntry::numbers(const char* name) const
{
    return read_list(name, "numbers", number_of);
}

std::vector<double> GltfEntry::numbers(const char* name, std::size_t count) const
{
    std::vector<double> out = numbers(name);
    if (has(name) && out.size() != count) refuse(name, fmt::format("{} numbers", count));
    return out;
}

std::optional<GltfEntry> GltfEntry::part(const char* name) const
{
    const Json* found = find(name);
    if (!found) return {};
    if (!found->is_object()) refuse(name, object_words);
    return GltfEntry(*found, *this, name, {});
}

std::string_view GltfEntry::needed_text(const char* name) const
{
    if (!has(name)) refuse(name, text_words);
    return text(name);
}

std::size_t GltfEntry::needed_size(const char* name) const
{
    if (!has(name)) refuse(name, whole_words);
    return size(name);
}

std::size_t GltfEntry::needed_index(const char* name) const
{
    const int out = index(name);
    if (out < 0) refuse(name, whole_words);
    return static_cast<std::size_t>(out);
}

GltfEntry GltfEntry::needed_part(const char* name) const
{
    if (!has(name)) refuse(name, object_words);
    return *part(name);
}

std::size_t GltfEntry::count(const char* name) const
{
    const Json* found = list(name);
    return found ? found->size() : 0;
}

GltfEntry GltfEntry::item(const char* name, const char* called, std::size_t number) const
{
    return {value_->at(name).at(number), *this, called, number};
}

GltfEntry GltfEntry::as_named_by(const GltfEntry& owner, const char* name) const
{
    GltfEntry out = *this;
    out.owner_ = &owner;
    out.role_ = name;
    return out;
}

void GltfEntry::each(const char* name, const char* called,
                     const std::function<void(const GltfEntry&)>& use) const
{
    const std::size_t all = count(name);
    for (std::size_t i = 0; i < all; ++i) use(item(name, called, i));
}

std::vector<std::string> GltfEntry::names() const
{
    std::vector<std::string> out;
    for (const auto& [name, value] : value_->items()) out.push_back(name);
    return out;
}

} // namespace trivar
