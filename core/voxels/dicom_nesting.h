// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace trivar {

// Calls `work`, which reads the bytes of a DICOM file, with these bytes and enough stack; those of
// a deflated file are unpacked before. DCMTK recurses from one sequence into the next, 1.5 kB each,
// and has no bound of its own: a file of 200 kB that is nothing but sequences in sequences ends the
// process. Each of them has an item, and an item has a mark of four bytes, so the marks in the
// bytes bound the depth. Few are read where the caller is; more, as the frames of large files have
// them, on a thread with a stack for all; more than 262,144 are refused. What `work` throws is
// thrown here. Throws Rejected, also for deflated files whose head does not say how long it is.
void with_stack_for_dicom(std::string_view bytes, const std::string& name,
                          const std::function<void(std::string_view bytes)>& work);

} // namespace trivar
