// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/journey.h"

#include "core/placement/embed.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trivar {
namespace {

constexpr std::size_t chords = 1024;
constexpr double endless = std::numeric_limits<double>::infinity();

double modulo(double x, double period)
{
    return x - period * std::floor(x / period);
}

// Says whether the ends of the strip coincide over its whole width.
bool ends_meet(const Surface<glm::dvec3>& contact)
{
    constexpr double near_enough = 0.02; // relative to the width
    const auto at = [&](double u, double v) { return evaluate(contact, {u, v}).value; };
    const double width = glm::distance(at(0, 0), at(0, 1));
    for (const double v : {0.0, 0.5, 1.0})
        if (glm::distance(at(0, v), at(1, v)) > near_enough * width) return false;
    return true;
}

} // namespace

MiddleLine::MiddleLine(const Surface<glm::dvec3>& contact)
    : length_{0},
      first_(glm::length(evaluate(contact, {0, 0.5}, 1).u)),
      last_(glm::length(evaluate(contact, {1, 0.5}, 1).u)),
      closed_(contact.axes[0].closure() != Closure::open || ends_meet(contact)),
      rounds_to_start_(contact.axes[0].closure() == Closure::twisted ? 2 : 1)
{
    glm::dvec3 before = evaluate(contact, {0, 0.5}).value;
    for (std::size_t i = 1; i <= chords; ++i) {
        const double u = static_cast<double>(i) / chords;
        const glm::dvec3 p = evaluate(contact, {u, 0.5}).value;
        length_.push_back(length_.back() + glm::distance(before, p));
        before = p;
    }
}

double MiddleLine::length_at(double u) const
{
    if (u <= 0) return u * first_;
    if (u >= 1) return length() + (u - 1) * last_;
    const double at = u * chords;
    const auto i = std::min(static_cast<std::size_t>(at), chords - 1);
    return length_[i] + (at - static_cast<double>(i)) * (length_[i + 1] - length_[i]);
}

double MiddleLine::u_at(double length) const
{
    if (length <= 0) return first_ > 0 ? length / first_ : 0;
    if (length >= this->length()) return last_ > 0 ? 1 + (length - this->length()) / last_ : 1;
    const auto next = std::upper_bound(length_.begin(), length_.end(), length);
    const auto i = static_cast<std::size_t>(next - length_.begin()) - 1;
    return (static_cast<double>(i) + (length - length_[i]) / (length_[i + 1] - length_[i])) /
           chords;
}

glm::dvec2 MiddleLine::slopes(double from, double to) const
{
    const auto outside = [](double slope) { return slope > 0 ? 1 / slope : 0; };
    glm::dvec2 out(endless, 0);
    const auto add = [&](double slope) { out = {std::min(out.x, slope), std::max(out.y, slope)}; };
    if (from <= 0) add(outside(first_));
    if (to >= length()) add(outside(last_));
    for (std::size_t i = 0; i < chords; ++i)
        if (length_[i + 1] >= from && length_[i] <= to)
            add(1 / (static_cast<double>(chords) * (length_[i + 1] - length_[i])));
    return out;
}

// Makes the run over a way; one too short for the speed is covered at a lower speed, in the time of
// the easing.
Journey::Run Journey::run_over(double way, double speed, double in, double out)
{
    if (!(way > 0)) return {};
    if (speed * (in + out) / 2 > way) speed = 2 * way / (in + out);
    return {way, speed, in, out};
}

double Journey::Run::seconds() const
{
    return way > 0 ? way / speed + (in + out) / 2 : 0;
}

double Journey::Run::covered(double t) const
{
    const double end = seconds();
    if (t <= 0) return 0;
    if (t >= end) return way;
    if (t < in) return speed * t * t / (2 * in);
    if (t > end - out) return way - speed * (end - t) * (end - t) / (2 * out);
    return speed * (t - in / 2);
}

// Bounds the speed between two times. It rises evenly, stays, and falls evenly, so that it is least
// at one of them.
glm::dvec2 Journey::Run::speeds(double from_s, double to_s) const
{
    const double end = seconds();
    const auto at = [&](double t) {
        if (!(way > 0) || t < 0 || t > end) return 0.0;
        if (t < in) return speed * t / in;
        return t > end - out ? speed * (end - t) / out : speed;
    };
    const bool stays = to_s >= in && from_s <= end - out && way > 0 && to_s >= 0 && from_s <= end;
    return {std::min(at(from_s), at(to_s)), stays ? speed : std::max(at(from_s), at(to_s))};
}

// Returns the run within its time limit, at the end of which it slows down.
Journey::Run Journey::limited(const Run& run) const
{
    const double time = travel_.duration;
    if (time <= 0 || run.seconds() <= time) return run;
    double in = travel_.ease_in, out = travel_.ease_out;
    if (const double both = in + out; both > time) {
        in *= time / both;
        out *= time / both;
    }
    const double speed = std::abs(travel_.speed), way = speed * (time - (in + out) / 2);
    // If slowing down would take it to the end, it arrives as if there were no limit.
    return way < run.way ? Run{way, speed, in, out} : run;
}

Journey::Journey(const Travel& travel, const PlacementParameters& parameters,
                 const Surface<glm::dvec3>& contact)
    : travel_(travel),
      line_(contact),
      fill_(parameters.fill),
      middle_(parameters.start + parameters.fill / 2),
      from_(line_.length_at(middle_)),
      least_(line_.length_at(parameters.fill / 2)),
      most_(line_.length_at(1 - parameters.fill / 2))
{
    constexpr double least_room = 1e-6; // relative to the length: less is rounding
    direction_ = (travel.speed < 0) != looks_back(parameters) ? -1 : 1;
    rounds_ = travel.ends == Ends::loop && line_.closed();
    has_room_ =
        rounds_ || travel.ends == Ends::run_on || most_ - least_ > least_room * line_.length();
    const double members = travel.followers + 1;
    gap_ = travel.gap > 0              ? travel.gap
           : travel.ends != Ends::loop ? parameters.fill * line_.length()
           : rounds_                   ? line_.length() * line_.rounds_to_start() / members
                                       : (most_ - least_) / members;
    const double train = gap_ * travel.followers;
    if (travel.ends == Ends::back_and_forth) { // all of them stay on the stroke where they turn
        (direction_ > 0 ? least_ : most_) += direction_ * train;
        has_room_ = most_ - least_ > least_room * line_.length();
    }
    if (!has_room_ || travel.speed == 0) return;
    const double speed = std::abs(travel.speed), in = travel.ease_in, out = travel.ease_out;
    const double room = std::max(0.0, direction_ > 0 ? most_ - from_ : from_ - least_);
    switch (travel.ends) {
    case Ends::stay: run_ = limited(run_over(room, speed, in, out)); break;
    case Ends::hide: run_ = limited(run_over(room + train, speed, in, 0)); break;
    case Ends::run_on:
    case Ends::loop: run_ = limited(run_over(endless, speed, in, 0)); break;
    case Ends::back_and_forth:
        run_ = run_over(room, speed, in, out);
        back_ = run_over(most_ - least_, speed, in, out);
        break;
    }
}

double Journey::turned_length(double seconds) const
{
    if (travel_.duration > 0) seconds = std::min(seconds, travel_.duration);
    if (seconds < run_.seconds()) return from_ + direction_ * run_.covered(seconds);
    seconds -= run_.seconds();
    const double legs = std::floor(seconds / back_.seconds());
    const double covered = back_.covered(seconds - legs * back_.seconds());
    const bool returning = std::fmod(legs, 2) == 0;
    const bool falls = returning == (direction_ > 0);
    return falls ? most_ - covered : least_ + covered;
}

double Journey::length_of_first(double seconds) const
{
    if (!(seconds > 0) || !has_room_ || travel_.speed == 0) return from_;
    if (travel_.ends == Ends::back_and_forth) return turned_length(seconds);
    return from_ + direction_ * run_.covered(seconds);
}

double Journey::unrolled_u(double length) const
{
    const bool again = travel_.ends == Ends::loop;
    if (!again || (!rounds_ && !(most_ > least_))) return line_.u_at(length);
    const double begin = rounds_ ? 0 : least_, lap = rounds_ ? line_.length() : most_ - least_;
    const double laps = std::floor((length - begin) / lap);
    const double way_u = rounds_ ? 1 : line_.u_at(most_) - line_.u_at(least_);
    return laps * way_u + line_.u_at(begin + modulo(length - begin, lap));
}

Journey::Place Journey::at(double seconds, int follower) const
{
    const bool rests = !(seconds > 0) || !has_room_ || travel_.speed == 0;
    if (rests && follower == 0) return {};
    const double behind = direction_ * gap_ * follower;
    double length = length_of_first(seconds) - behind;
    Place out{.gone_u = rests ? 0 : unrolled_u(length) - unrolled_u(from_ - behind)};
    if (rounds_) {
        const double round = std::floor(length / line_.length());
        const double middle =
            line_.u_at(modulo(length, line_.length())) + modulo(round, line_.rounds_to_start());
        out.shift_u = (middle < fill_ / 2 ? middle + line_.rounds_to_start() : middle) - middle_;
        return out;
    }
    const double tiny = 1e-9 * line_.length();
    const double start = line_.length_at(fill_ / 2), end = line_.length_at(1 - fill_ / 2);
    if (travel_.ends == Ends::loop && most_ > least_)
        length = least_ + modulo(length - least_, most_ - least_);
    else if (travel_.ends == Ends::hide && !rests)
        out.hidden = direction_ > 0 ? length >= end - tiny : length <= start + tiny;
    if (travel_.ends != Ends::run_on && follower > 0)
        out.hidden |= direction_ > 0 ? length < start - tiny : length > end + tiny;
    out.shift_u = line_.u_at(length) - middle_;
    return out;
}

// Bounds the signed speed, in lengths per second.
glm::dvec2 Journey::speeds_of_first(double from_s, double to_s) const
{
    if (!has_room_ || travel_.speed == 0) return glm::dvec2(0);
    const double fastest = std::max(run_.speed, back_.speed);
    glm::dvec2 out(-fastest, fastest); // it may turn
    if (travel_.ends != Ends::back_and_forth)
        out = run_.speeds(from_s, to_s);
    else if (travel_.duration > 0 && from_s >= travel_.duration)
        out = glm::dvec2(0);
    else if (travel_.duration > 0 && to_s > travel_.duration)
        return out;
    else if (to_s < run_.seconds())
        out = run_.speeds(from_s, to_s);
    else if (from_s > run_.seconds()) {
        const double leg = back_.seconds(), from = (from_s - run_.seconds()) / leg,
                     to = (to_s - run_.seconds()) / leg;
        if (std::floor(from) != std::floor(to)) return out;
        out = back_.speeds((from - std::floor(from)) * leg, (to - std::floor(to)) * leg);
        if (std::fmod(std::floor(from), 2) == 0) out = {-out.y, -out.x}; // on its way back
    }
    return direction_ > 0 ? out : glm::dvec2(-out.y, -out.x);
}

// Bounds how far gone_u is from an even motion. It changes by speed times slope; a function whose
// derivative is in an interval is off its chord by at most a quarter of the length of the interval
// times the time.
double Journey::unevenness_u(double from_s, double to_s, int follower) const
{
    const glm::dvec2 speed = speeds_of_first(from_s, to_s);
    if (speed == glm::dvec2(0)) return 0;
    const double behind = direction_ * gap_ * follower;
    double a = length_of_first(from_s), b = length_of_first(to_s);
    const double reach = std::max(std::abs(speed.x), std::abs(speed.y)) * (to_s - from_s);
    if (travel_.ends == Ends::back_and_forth) { // it may have turned between
        a = std::min(a, b) - reach;
        b = a + 3 * reach;
    }
    double from = std::min(a, b) - behind, to = std::max(a, b) - behind;
    const bool again = travel_.ends == Ends::loop && (rounds_ || most_ > least_);
    if (again) {
        const double begin = rounds_ ? 0 : least_, lap = rounds_ ? line_.length() : most_ - least_;
        const double laps = std::floor((from - begin) / lap) * lap;
        from -= laps;
        to -= laps;
        if (to > begin + lap) { // from the end of a lap into the next
            from = 0;
            to = line_.length();
        }
    }
    const glm::dvec2 slope = line_.slopes(from, to);
    const double least = speed.x * (speed.x < 0 ? slope.y : slope.x),
                 most = speed.y * (speed.y < 0 ? slope.x : slope.y);
    return (most - least) * (to_s - from_s) / 4;
}

double Journey::seconds() const
{
    if (!has_room_ || travel_.speed == 0) return 0;
    if (travel_.ends != Ends::back_and_forth) return run_.seconds();
    return travel_.duration > 0 ? travel_.duration : endless;
}

double Journey::speed_for(double seconds) const
{
    const bool ends = travel_.ends == Ends::stay || travel_.ends == Ends::hide;
    if (!ends || !has_room_ || travel_.duration > 0) return travel_.speed;
    const double in = travel_.ease_in, out = travel_.ends == Ends::stay ? travel_.ease_out : 0;
    const double speed = run_.way / std::max(seconds - (in + out) / 2, (in + out) / 2);
    return std::isfinite(speed) ? std::copysign(speed, travel_.speed) : travel_.speed;
}

} // namespace trivar
