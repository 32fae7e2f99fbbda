# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DBUILD=FOLDER -P tests/installed.cmake: what is installed works from where it lies.
set(prefix ${BUILD}/installed)
file(REMOVE_RECURSE ${prefix})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
set(shared ${prefix}/share/trivar)
set(program ${prefix}/bin/trivar)
set(scene ${shared}/assets/scenes/first_placement.trivar)
# Two kinds of pictures: one that the program reads itself, and one for which it starts another.
file(WRITE ${prefix}/one_pixel.hdr "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\nabc~")
foreach(arguments "--version" "--help" "info;${scene}" "info;${shared}/gallery/stacked.png"
        "info;${prefix}/one_pixel.hdr" "replay;${scene};--check;--export;${prefix}/laid.obj")
  execute_process(COMMAND ${program} ${arguments} WORKING_DIRECTORY ${prefix} OUTPUT_QUIET
                  ERROR_VARIABLE talk COMMAND_ERROR_IS_FATAL ANY)
  if(talk MATCHES "no such file")
    message(FATAL_ERROR "${talk}")
  endif()
endforeach()
foreach(file laid.obj share/trivar/manual/start.md share/trivar/gallery/stacked.png share/trivar/assets/tutorials/first_stroke.trivar)
  if(NOT EXISTS ${prefix}/${file})
    message(FATAL_ERROR "${file} is not there")
  endif()
endforeach()
file(REMOVE_RECURSE ${prefix})
