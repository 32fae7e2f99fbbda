// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/expression.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string>
#include <vector>

namespace trivar {
namespace {

constexpr double pi = 3.14159265358979323846;

struct Unit {
    std::string_view name;
    Measure measure;
    double size; // in metres, or in degrees
};
constexpr std::array units{
    Unit{"mm", Measure::length, 0.001},  Unit{"cm", Measure::length, 0.01},
    Unit{"m", Measure::length, 1},       Unit{"km", Measure::length, 1000},
    Unit{"in", Measure::length, 0.0254}, Unit{"ft", Measure::length, 0.3048},
    Unit{"deg", Measure::angle, 1},      Unit{"rad", Measure::angle, 180 / pi},
};

// A Reader parses this grammar by recursive descent: sum = product { + - product }, product =
// signed { * / signed }, signed = [+ -] power, power = value [ ^ signed ], value = (number | pi |
// f(sum, ...) | (sum)) [unit]
class Reader {
public:
    Reader(std::string_view text, Measure measure) : rest_(text), measure_(measure) {}

    std::optional<double> all()
    {
        const auto value = sum();
        skip_spaces();
        return rest_.empty() ? value : std::nullopt;
    }

private:
    using Value = std::optional<double>;

    void skip_spaces()
    {
        while (!rest_.empty() && rest_.front() == ' ') rest_.remove_prefix(1);
    }
    bool take(char c)
    {
        skip_spaces();
        if (rest_.empty() || rest_.front() != c) return false;
        rest_.remove_prefix(1);
        return true;
    }
    std::string_view word()
    {
        skip_spaces();
        std::size_t n = 0;
        while (n < rest_.size() && std::isalpha(static_cast<unsigned char>(rest_[n]))) ++n;
        const std::string_view result = rest_.substr(0, n);
        rest_.remove_prefix(n);
        return result;
    }

    Value sum()
    {
        Value left = product();
        while (left) {
            const bool plus = take('+');
            if (!plus && !take('-')) break;
            const Value right = product();
            if (!right) return {};
            left = plus ? *left + *right : *left - *right;
        }
        return left;
    }
    Value product()
    {
        Value left = with_sign();
        while (left) {
            const bool times = take('*');
            if (!times && !take('/')) break;
            const Value right = with_sign();
            if (!right) return {};
            left = times ? *left * *right : *left / *right;
        }
        return left;
    }
    Value with_sign()
    {
        constexpr int deepest = 64; // deeper nesting is not typed by hand
        if (depth_ > deepest) return {};
        ++depth_;
        Value value;
        if (take('-')) {
            value = with_sign();
            if (value) value = -*value;
        } else {
            value = take('+') ? with_sign() : power();
        }
        --depth_;
        return value;
    }
    Value power()
    {
        const Value base = measured();
        if (!base || !take('^')) return base;
        const Value exponent = with_sign();
        return exponent ? Value(std::pow(*base, *exponent)) : Value();
    }
    Value measured()
    {
        const Value value = single();
        if (!value) return {};
        const std::string_view name = word();
        if (name.empty()) return value;
        for (const Unit& unit : units)
            if (unit.name == name && unit.measure == measure_) return *value * unit.size;
        return {};
    }
    Value single()
    {
        if (take('(')) return closed(sum());
        const std::string_view name = word();
        if (name == "pi") return pi;
        if (!name.empty()) return function(name);
        double value = 0;
        const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        if (error != std::errc()) return {};
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        return value;
    }
    Value closed(Value value) { return take(')') ? value : Value(); }
    Value function(std::string_view name)
    {
        if (!take('(')) return {};
        std::vector<double> with;
        do {
            const Value one = sum();
            if (!one) return {};
            with.push_back(*one);
        } while (take(','));
        if (!take(')')) return {};
        if (name == "min") return *std::min_element(with.begin(), with.end());
        if (name == "max") return *std::max_element(with.begin(), with.end());
        if (with.size() != 1) return {};
        const double angle = measure_ == Measure::angle ? with[0] * pi / 180 : with[0];
        if (name == "sin") return std::sin(angle);
        if (name == "cos") return std::cos(angle);
        if (name == "sqrt") return std::sqrt(with[0]);
        return {};
    }

    std::string_view rest_;
    Measure measure_;
    int depth_ = 0;
};

// "2.4·10⁻¹⁷", as number_text writes it, in the signs of keyboards: "2.4e-17".
std::string in_ascii(std::string_view text)
{
    constexpr std::string_view times_ten = "·10", typed = "0123456789-";
    constexpr std::array<std::string_view, 11> raised{"⁰", "¹", "²", "³", "⁴", "⁵",
                                                      "⁶", "⁷", "⁸", "⁹", "⁻"};
    std::string plain;
    for (;;) {
        const std::size_t at = text.find(times_ten);
        plain += text.substr(0, at);
        if (at == text.npos) return plain;
        text.remove_prefix(at + times_ten.size());
        plain += 'e';
        for (std::size_t i = 0; i < raised.size();) {
            if (!text.starts_with(raised[i])) {
                ++i;
                continue;
            }
            plain += typed[i];
            text.remove_prefix(raised[i].size());
            i = 0;
        }
    }
}

} // namespace

std::optional<double> evaluate_expression(std::string_view typed, Measure measure, double present)
{
    const std::string plain = in_ascii(typed);
    std::string_view text = plain;
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    char relative = '=';
    if (text.size() > 1 && text[1] == '=' && std::string_view("+-*/").find(text[0]) != text.npos) {
        relative = text[0];
        text.remove_prefix(2);
    } else if (text.starts_with('=')) {
        text.remove_prefix(1);
    }
    // A factor has no unit.
    const bool factor = relative == '*' || relative == '/';
    const auto value = Reader(text, factor ? Measure::plain : measure).all();
    if (!value) return {};
    const double result = relative == '+'   ? present + *value
                          : relative == '-' ? present - *value
                          : relative == '*' ? present * *value
                          : relative == '/' ? present / *value
                                            : *value;
    return std::isfinite(result) ? std::optional(result) : std::nullopt;
}

} // namespace trivar
