// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// A GltfEntry is a JSON object of a glTF file together with words for its place, such as "animation
// 2, channel 0". Every request has the requested type, or Rejected is thrown with the file, the
// place, what stands there and what should. A null counts as missing. An entry must not outlive the
// JSON and the entry that gave it.
class GltfEntry {
public:
    // The outermost object of a file.
    GltfEntry(const nlohmann::json& root, const std::string& file_name);

    bool has(const char* name) const;
    // The value of a name; where there is none, the value in the comment.
    std::string_view text(const char* name) const; // empty; lives as long as the JSON
    bool flag(const char* name) const;             // false
    double number(const char* name, double otherwise) const;
    std::size_t size(const char* name, std::size_t otherwise = 0) const;
    int index(const char* name) const; // -1
    std::vector<int> indices(const char* name) const;
    std::vector<std::string_view> texts(const char* name) const;
    std::vector<double> numbers(const char* name) const;
    std::vector<double> numbers(const char* name, std::size_t count) const; // or none
    std::optional<GltfEntry> part(const char* name) const;
    // Values that must exist.
    std::string_view needed_text(const char* name) const;
    std::size_t needed_size(const char* name) const;
    std::size_t needed_index(const char* name) const;
    GltfEntry needed_part(const char* name) const;

    // A list of objects; `called` is the word for one of them, with its number from 0.
    std::size_t count(const char* list) const;
    GltfEntry item(const char* list, const char* called, std::size_t number) const;
    // The same entry under the words by which another entry names it, which say more than a place
    // in a list.
    GltfEntry as_named_by(const GltfEntry& owner, const char* name) const;
    void each(const char* list, const char* called,
              const std::function<void(const GltfEntry&)>& use) const;
    std::vector<std::string> names() const; // of all values in it

    // Throws Rejected as "FILE: PLACE: WHAT".
    [[noreturn]] void fail(const std::string& what) const;
    std::string place() const; // empty: the whole file

private:
    using Json = nlohmann::json;
    GltfEntry(const Json& value, const GltfEntry& owner, const char* called,
              std::optional<std::size_t> number);
    const Json* find(const char* name) const;
    const Json* list(const char* name) const;
    [[noreturn]] void refuse(const char* name, const std::string& wanted) const;
    template <class Value>
    std::optional<Value> read(const char* name, const char* wanted,
                              std::optional<Value> (*value)(const Json&)) const;
    template <class Value>
    std::vector<Value> read_list(const char* name, const char* wanted,
                                 std::optional<Value> (*value)(const Json&)) const;

    const Json* value_;
    const GltfEntry* owner_ = nullptr;
    const std::string* file_name_;
    const char *called_ = "", *role_ = "";
    std::optional<std::size_t> number_ = {};
};

} // namespace trivar
