# SPDX-License-Identifier: GPL-3.0-or-later
# cmake --install build --prefix X puts the program into X/bin, its parts into X/lib/trivar and what it
# shows into X/share/trivar, where it looks for them from its own place.
set(shared share/trivar)
install(TARGETS trivar RUNTIME DESTINATION bin)
# Its parts that are files of their own (core/base/this_program.h).
install(TARGETS trivar_codec trivar_picture LIBRARY DESTINATION lib/trivar RUNTIME DESTINATION lib/trivar)
install(FILES LICENSE DESTINATION ${shared})
install(DIRECTORY docs/manual docs/gallery DESTINATION ${shared})
install(DIRECTORY assets/scenes assets/tutorials DESTINATION ${shared}/assets FILES_MATCHING PATTERN *.trivar)
install(DIRECTORY ${CMAKE_BINARY_DIR}/assets/models DESTINATION ${shared}/assets)
# In the checkout scenes name the models that the build makes; here those beside them. Their digests
# are of the paths as well.
install(CODE "set(assets \"\${CMAKE_INSTALL_PREFIX}/${shared}/assets\")")
install(CODE [[
  file(GLOB scenes $ENV{DESTDIR}${assets}/scenes/*.trivar $ENV{DESTDIR}${assets}/tutorials/*.trivar)
  foreach(scene ${scenes})
    file(READ ${scene} text)
    string(REPLACE "../../build/assets/" "../" text "${text}")
    string(REGEX REPLACE "{\"digest\"[^\n]*\n" "" text "${text}")
    file(WRITE ${scene} "${text}")
  endforeach()
]])
