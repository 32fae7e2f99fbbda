# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DPROGRAM=FILE -P cmake/Carry.cmake: the libraries that a program takes, beside it; but not
# those of the system and of its graphics driver.
get_filename_component(folder ${PROGRAM} DIRECTORY)
file(GLOB former ${folder}/*.so*) # which would be found before the system's
if(former)
  file(REMOVE ${former})
endif()
file(GET_RUNTIME_DEPENDENCIES EXECUTABLES ${PROGRAM} RESOLVED_DEPENDENCIES_VAR libraries
     PRE_EXCLUDE_REGEXES "^lib(c|m|dl|rt|pthread|EGL|GL[a-zA-Z]*|OpenGL)\\.so" "^ld-linux")
file(COPY ${libraries} DESTINATION ${folder} FOLLOW_SYMLINK_CHAIN)
