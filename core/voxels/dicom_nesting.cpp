// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/dicom_nesting.h"

#include "core/base/rejected.h"
#include "core/voxels/inflate.h"
#include "core/voxels/sample_type.h"

#include <cstring>
#include <exception>
#include <fmt/format.h>
#include <optional>
#include <pthread.h>

namespace trivar {
namespace {

using namespace std::string_view_literals;

constexpr auto deflated_syntax = "1.2.840.10008.1.2.1.99"sv,
               plain_syntax = "1.2.840.10008.1.2.1\0\0\0"sv;

// A deflated file as one that is not: behind the head, which says how long it is and is not packed,
// all is deflated. Nothing for another file.
std::optional<std::string> inflated(std::string_view bytes, const std::string& name)
{
    constexpr std::size_t preamble = 132, first_element = 12;
    constexpr std::uint64_t most = std::uint64_t{1} << 29;
    if (bytes.size() < preamble + first_element ||
        bytes.substr(preamble, 8) != "\x02\0\0\0UL\4\0"sv)
        return {};
    std::uint32_t length = 0;
    std::memcpy(&length, bytes.data() + preamble + 8, sizeof(length));
    const std::string_view head = bytes.substr(0, preamble + first_element + std::size_t{length});
    const std::size_t at = head.find(deflated_syntax, preamble);
    if (at == head.npos) return {};
    std::string out(head);
    out.replace(at, plain_syntax.size(), plain_syntax);
    return out + unpacked(bytes.substr(head.size()), Packing::deflate, most, name);
}

std::size_t count_marks(std::string_view bytes, std::string_view mark, std::size_t most)
{
    std::size_t count = 0;
    for (std::size_t at = bytes.find(mark); at != bytes.npos && count <= most;
         at = bytes.find(mark, at + mark.size()))
        ++count;
    return count;
}

struct Work {
    const std::function<void()>& run;
    std::exception_ptr thrown;
};

void* run_work(void* given)
{
    Work& work = *static_cast<Work*>(given);
    try {
        work.run();
    } catch (...) {
        work.thrown = std::current_exception();
    }
    return nullptr;
}

// Only the used part of a stack takes memory.
void run_on_thread(std::size_t stack_bytes, const std::string& name,
                   const std::function<void()>& run)
{
    Work work{run, {}};
    pthread_attr_t attributes;
    pthread_t thread;
    pthread_attr_init(&attributes);
    const bool begun = pthread_attr_setstacksize(&attributes, stack_bytes) == 0 &&
                       pthread_create(&thread, &attributes, run_work, &work) == 0;
    pthread_attr_destroy(&attributes);
    if (!begun) throw Rejected(name + ": there is not enough memory to read this DICOM file");
    pthread_join(thread, nullptr);
    if (work.thrown) std::rethrow_exception(work.thrown);
}

} // namespace

void with_stack_for_dicom(std::string_view bytes, const std::string& name,
                          const std::function<void(std::string_view bytes)>& work)
{
    constexpr std::size_t few = 500, most = std::size_t{1} << 18;
    constexpr std::size_t stack_for_one = 4096, stack_at_least = std::size_t{1} << 23;
    const std::optional<std::string> plain = inflated(bytes, name);
    if (plain)
        bytes = *plain;
    else if (bytes.find(deflated_syntax) != bytes.npos)
        throw Rejected(name +
                       ": this DICOM file is deflated and does not say where; write it again "
                       "by dcmconv +te IN OUT");
    const std::size_t items = count_marks(bytes, "\xfe\xff\x00\xe0"sv, most) +
                              count_marks(bytes, "\xff\xfe\xe0\x00"sv, most);
    if (items > most)
        throw Rejected(fmt::format("{}: this DICOM file has more than {} items in sequences, which "
                                   "is not read",
                                   name, with_commas(most)));
    if (items <= few)
        work(bytes);
    else
        run_on_thread(stack_at_least + items * stack_for_one, name, [&] { work(bytes); });
}

} // namespace trivar
