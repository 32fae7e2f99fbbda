// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/command_line/bench.h"

#include "gpu/context.h"
#include "gpu/ffd/deform_findings.h"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace trivar {
namespace {

using gpu::DeformRate, gpu::NormalsBy, gpu::Sum, gpu::Way;

const char* bench_word(Way way)
{
    return way == Way::processor ? "processor" : way == Way::one_phase ? "one phase" : "two phases";
}

const char* bench_word(Sum sum)
{
    return sum == Sum::nested ? "nested" : sum == Sum::raised ? "raised" : "filtered (preview)";
}

const char* bench_word(NormalsBy normals)
{
    return normals == NormalsBy::nothing     ? "none"
           : normals == NormalsBy::cofactors ? "exact"
                                             : "differences";
}

std::string report_text(const gpu::DeformReport& report)
{
    std::string out =
        fmt::format("{}\ncopies buffers at {:.1f} GB/s, read and written; does {:.1f} "
                    "thousand million multiply-adds a second\n\n",
                    report.device.name, report.device.copy_bytes_per_s / 1e9,
                    report.device.multiply_adds_per_s / 1e9);
    out +=
        fmt::format("{:<11} {:<18} {:<11} {:>5} {:>7} {:>6} {:>9} {:>9} {:>10}  {:>5} {:<11} {}\n",
                    "way", "sum", "normals", "order", "lattice", "passes", "vertices", "time ms",
                    "million/s", "share", "of what", "error: position, normal");
    for (const DeformRate& r : report.rates) {
        out += fmt::format("{:<11} {:<18} {:<11} {:>5} {:>5}^3 {:>6} {:>9} {:>9.3f} {:>10.2f}",
                           bench_word(r.what.way), bench_word(r.what.method.sum),
                           bench_word(r.what.method.normals), r.what.order, r.what.lattice,
                           r.what.passes, r.what.vertices, r.time_ms, r.vertices_per_s / 1e6);
        if (r.copy_allows_per_s > 0)
            out += fmt::format("  {:>4.0f}% {:<11}", 100 * r.vertices_per_s / gpu::allowed_per_s(r),
                               gpu::bound_by(r));
        if (r.position_error) out += fmt::format(" {:.1e}", *r.position_error);
        if (r.normal_error_deg) out += fmt::format(", {:.4f} degrees", *r.normal_error_deg);
        out += '\n';
    }
    out += '\n';
    for (const std::string& sentence : gpu::findings(report)) out += sentence + '\n';
    return out;
}

nlohmann::ordered_json report_json(const gpu::DeformReport& report)
{
    nlohmann::ordered_json rates = nlohmann::ordered_json::array();
    for (const DeformRate& r : report.rates) {
        nlohmann::ordered_json rate{{"way", bench_word(r.what.way)},
                                    {"sum", bench_word(r.what.method.sum)},
                                    {"normals", bench_word(r.what.method.normals)},
                                    {"order", r.what.order},
                                    {"lattice", r.what.lattice},
                                    {"passes", r.what.passes},
                                    {"vertices", r.what.vertices},
                                    {"time_ms", r.time_ms},
                                    {"vertices_per_s", r.vertices_per_s}};
        if (r.copy_allows_per_s > 0) {
            rate["copy_allows_per_s"] = r.copy_allows_per_s;
            rate["arithmetic_allows_per_s"] = r.arithmetic_allows_per_s;
            rate["bound_by"] = gpu::bound_by(r);
        }
        if (r.position_error) rate["position_error"] = *r.position_error;
        if (r.normal_error_deg) rate["normal_error_deg"] = *r.normal_error_deg;
        rates.push_back(std::move(rate));
    }
    return {{"device", report.device.name},
            {"copy_bytes_per_s", report.device.copy_bytes_per_s},
            {"multiply_adds_per_s", report.device.multiply_adds_per_s},
            {"rates", rates},
            {"findings", gpu::findings(report)},
            {"notices", report.notices}};
}

} // namespace

Status run_bench(const BenchOptions& options, const Streams& streams)
{
    const gpu::HeadlessContext context(true);
    std::vector<gpu::DeformCase> cases = gpu::every_deform_case();
    const auto most = static_cast<std::size_t>(options.vertices);
    std::erase_if(cases, [&](const gpu::DeformCase& c) { return c.vertices > most; });
    const auto shown = [&](double fraction, std::string_view stage) {
        streams.talk << fmt::format("\r\x1b[K{:3.0f} % {}", 100 * fraction, stage) << std::flush;
    };
    const gpu::DeformReport report =
        gpu::deform_rates(cases, {options.most_s, 60 * options.minutes},
                          streams.terminal ? Progress(shown) : Progress());
    if (streams.terminal) streams.talk << "\r\x1b[K";
    streams.out << (options.json ? report_json(report).dump(2) + "\n" : report_text(report));
    for (const std::string& notice : report.notices) streams.talk << "trivar: " << notice << "\n";
    return Status::done;
}

} // namespace trivar
