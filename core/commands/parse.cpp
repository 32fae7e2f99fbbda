// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/read_json.h"

#include "core/base/rejected.h"
#include "core/base/text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

namespace trivar {
namespace {

using nlohmann::json;

// Builds one JSON value from the events of the parser, in time linear in the text.
class LineBuilder : public json::json_sax_t {
public:
    json taken() { return std::move(root_); }

    bool null() override { return put(nullptr); }
    bool boolean(bool value) override { return put(value); }
    bool number_integer(std::int64_t value) override { return put(value); }
    bool number_unsigned(std::uint64_t value) override { return put(value); }
    bool number_float(double value, const std::string&) override { return put(value); }
    bool string(std::string& value) override { return put(std::move(value)); }
    bool binary(json::binary_t&) override { return false; } // not in text
    bool start_object(std::size_t) override { return open(json::object()); }
    bool start_array(std::size_t) override { return open(json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool key(std::string& name) override
    {
        const auto [entry, fresh] = open_.back()->emplace(name, nullptr);
        if (!fresh) throw Rejected(fmt::format("field \"{}\" appears twice", printable(name)));
        field_ = &*entry;
        return true;
    }
    bool parse_error(std::size_t, const std::string&, const json::exception& error) override
    {
        if (const auto* parse = dynamic_cast<const json::parse_error*>(&error))
            throw Rejected(fmt::format("not valid JSON at byte {}", parse->byte));
        throw Rejected("not valid JSON: a number is too large");
    }

private:
    json& added(json value)
    {
        json& place = open_.empty()              ? root_
                      : open_.back()->is_array() ? open_.back()->emplace_back()
                                                 : *field_;
        return place = std::move(value);
    }
    bool put(json value)
    {
        added(std::move(value));
        return true;
    }
    bool open(json brackets)
    {
        constexpr std::size_t most_open =
            10; // no field nests further, and some walks are recursive
        if (open_.size() > most_open) throw Rejected("brackets nest too deeply");
        open_.push_back(&added(std::move(brackets)));
        return true;
    }
    bool close()
    {
        open_.pop_back();
        return true;
    }

    json root_;
    std::vector<json*> open_; // each holds the next, and only the last one grows
    json* field_ = nullptr;   // of the last one, whose value comes next
};

} // namespace

json parse_object(std::string_view line)
{
    LineBuilder builder;
    json::sax_parse(line, &builder);
    json object = builder.taken();
    if (!object.is_object()) throw Rejected("the line must be an object in braces");
    return object;
}

} // namespace trivar
