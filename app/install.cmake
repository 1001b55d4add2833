# Install rules of the components `runtime` and `doc`; the library and the Python module have their own.
include(GNUInstallDirs)
set(share ${CMAKE_INSTALL_DATAROOTDIR})
set(packaging ${CMAKE_SOURCE_DIR}/packaging/linux)

install(TARGETS angiopose angiopose-cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT runtime)

# Desktop integration: application entry, MIME types, AppStream metadata and thumbnailer.
install(FILES ${packaging}/org.angiopose.AngioPose.desktop DESTINATION ${share}/applications COMPONENT runtime)
install(FILES ${packaging}/org.angiopose.AngioPose.mime.xml DESTINATION ${share}/mime/packages COMPONENT runtime)
install(FILES ${packaging}/org.angiopose.AngioPose.metainfo.xml DESTINATION ${share}/metainfo COMPONENT runtime)
install(FILES ${packaging}/org.angiopose.AngioPose.thumbnailer DESTINATION ${share}/thumbnailers COMPONENT runtime)

find_package(Qt6 6.4 REQUIRED COMPONENTS Gui Svg)
set(icon ${CMAKE_SOURCE_DIR}/resources/icons/angiopose.svg)
set(icon_folder ${CMAKE_CURRENT_BINARY_DIR}/icons)
set(icon_sizes 16 22 24 32 36 48 64 72 96 128 192 256 512)
file(MAKE_DIRECTORY ${icon_folder})
add_executable(draw_icons ${CMAKE_SOURCE_DIR}/resources/icons/draw_icons.cpp)
target_link_libraries(draw_icons PRIVATE Qt6::Gui Qt6::Svg strict_warnings)
list(TRANSFORM icon_sizes REPLACE "(.+)" "${icon_folder}/\\1.png" OUTPUT_VARIABLE icons)
add_custom_command(OUTPUT ${icons} COMMAND draw_icons ${icon} ${icon_folder} ${icon_sizes} DEPENDS draw_icons ${icon}
  COMMENT "Drawing the icon in all sizes" VERBATIM)
install(FILES ${icon} DESTINATION ${share}/icons/hicolor/scalable/apps COMPONENT runtime)
foreach(size ${icon_sizes})
  install(FILES ${icon_folder}/${size}.png DESTINATION ${share}/icons/hicolor/${size}x${size}/apps RENAME angiopose.png
    COMPONENT runtime)
endforeach()

# Man page and shell completions of the command line, generated from the same definitions as --help.
set(described ${CMAKE_CURRENT_BINARY_DIR}/description)
file(MAKE_DIRECTORY ${described})
foreach(kind man bash zsh fish)
  add_custom_command(OUTPUT ${described}/cli.${kind} COMMAND angiopose-cli description ${kind} > ${described}/cli.${kind}
    DEPENDS angiopose-cli COMMENT "Describing angiopose-cli: ${kind}" VERBATIM)
  list(APPEND descriptions ${described}/cli.${kind})
endforeach()
add_custom_target(installed_extras ALL DEPENDS ${icons} ${descriptions})

set(completion ${packaging}/completion)
install(FILES ${packaging}/angiopose.1 ${packaging}/angiopose-study.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1
  COMPONENT runtime)
install(PROGRAMS ${CMAKE_SOURCE_DIR}/packaging/cluster/angiopose-study TYPE BIN COMPONENT runtime)
install(FILES ${described}/cli.man DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 RENAME angiopose-cli.1 COMPONENT runtime)
install(FILES ${completion}/angiopose.bash DESTINATION ${share}/bash-completion/completions RENAME angiopose
  COMPONENT runtime)
install(FILES ${described}/cli.bash DESTINATION ${share}/bash-completion/completions RENAME angiopose-cli
  COMPONENT runtime)
install(FILES ${completion}/_angiopose DESTINATION ${share}/zsh/vendor-completions COMPONENT runtime)
install(FILES ${described}/cli.zsh DESTINATION ${share}/zsh/vendor-completions RENAME _angiopose-cli COMPONENT runtime)
install(FILES ${completion}/angiopose.fish DESTINATION ${share}/fish/vendor_completions.d COMPONENT runtime)
install(FILES ${described}/cli.fish DESTINATION ${share}/fish/vendor_completions.d RENAME angiopose-cli.fish
  COMPONENT runtime)

# Modules for 3D Slicer; the user adds this folder to the module paths in the Slicer settings.
install(DIRECTORY ${CMAKE_SOURCE_DIR}/resources/slicer DESTINATION ${share}/angiopose COMPONENT runtime
  PATTERN __pycache__ EXCLUDE)

# The installed documents keep the folder layout of the source tree, so that relative links remain valid.
foreach(document README CHANGELOG CONTRIBUTING KNOWN_ISSUES SECURITY THIRD_PARTY_NOTICES)
  install(FILES ${CMAKE_SOURCE_DIR}/${document}.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT doc)
endforeach()
install(FILES ${CMAKE_SOURCE_DIR}/LICENSE ${CMAKE_SOURCE_DIR}/CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR}
  COMPONENT doc)
install(FILES ${CMAKE_SOURCE_DIR}/resources/screenshot.png ${CMAKE_SOURCE_DIR}/resources/angiopose-case.schema.json
  ${CMAKE_SOURCE_DIR}/resources/angiopose-result.schema.json
  DESTINATION ${CMAKE_INSTALL_DOCDIR}/resources COMPONENT doc)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/resources/docs ${CMAKE_SOURCE_DIR}/resources/studies ${CMAKE_SOURCE_DIR}/resources/examples
  ${CMAKE_SOURCE_DIR}/resources/icons
  DESTINATION ${CMAKE_INSTALL_DOCDIR}/resources COMPONENT doc PATTERN __pycache__ EXCLUDE
  PATTERN draw_icons.cpp EXCLUDE)
