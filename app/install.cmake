# What `cmake --install` puts where, beside the library and the Python module, by component: runtime, doc.
include(GNUInstallDirs)
set(share ${CMAKE_INSTALL_DATAROOTDIR})
set(packaging ${CMAKE_SOURCE_DIR}/packaging/linux)

install(TARGETS angiopose angiopose-cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT runtime)
install(FILES ${packaging}/org.angiopose.AngioPose.desktop DESTINATION ${share}/applications COMPONENT runtime)
install(FILES ${packaging}/org.angiopose.AngioPose.mime.xml DESTINATION ${share}/mime/packages COMPONENT runtime)
install(FILES ${CMAKE_SOURCE_DIR}/resources/icons/angiopose.svg DESTINATION ${share}/icons/hicolor/scalable/apps
  COMPONENT runtime)

# Documents lie as they do in the source, so that their links to each other and to the examples hold.
foreach(document README CHANGELOG CONTRIBUTING KNOWN_ISSUES SECURITY THIRD_PARTY_NOTICES)
  install(FILES ${CMAKE_SOURCE_DIR}/${document}.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT doc)
endforeach()
install(FILES ${CMAKE_SOURCE_DIR}/LICENSE ${CMAKE_SOURCE_DIR}/CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR}
  COMPONENT doc)
install(FILES ${CMAKE_SOURCE_DIR}/resources/screenshot.png ${CMAKE_SOURCE_DIR}/resources/angiopose-case.schema.json
  DESTINATION ${CMAKE_INSTALL_DOCDIR}/resources COMPONENT doc)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/resources/docs ${CMAKE_SOURCE_DIR}/resources/examples ${CMAKE_SOURCE_DIR}/resources/icons
  DESTINATION ${CMAKE_INSTALL_DOCDIR}/resources COMPONENT doc PATTERN __pycache__ EXCLUDE)
