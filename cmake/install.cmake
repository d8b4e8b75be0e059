# cmake --install: the command, the public headers, one static library per layer, and the files that
# find_package(balcony) needs. Headers in src/ are private and not installed.
include(CMakePackageConfigHelpers)
set(package_folder "${CMAKE_INSTALL_LIBDIR}/cmake/balcony")

get_property(layers GLOBAL PROPERTY BALCONY_LAYERS)
list(REMOVE_ITEM layers balcony_cli)

# balcony::balcony is all layers.
add_library(balcony_all INTERFACE)
add_library(balcony::balcony ALIAS balcony_all)
set_target_properties(balcony_all PROPERTIES EXPORT_NAME balcony)
target_link_libraries(balcony_all INTERFACE ${layers})

# All that is installed, to be built without tests and benchmarks.
add_custom_target(installed DEPENDS balcony image_module proj_module ${layers})

install(TARGETS balcony_all ${layers} EXPORT balconyTargets
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
install(EXPORT balconyTargets NAMESPACE balcony:: DESTINATION "${package_folder}")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/balcony" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}"
    FILES_MATCHING PATTERN "*.hpp")

configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/balconyConfig.cmake.in"
    "${CMAKE_CURRENT_BINARY_DIR}/balconyConfig.cmake" INSTALL_DESTINATION "${package_folder}")
write_basic_package_version_file("${CMAKE_CURRENT_BINARY_DIR}/balconyConfigVersion.cmake"
    COMPATIBILITY SameMinorVersion)
install(FILES
    "${CMAKE_CURRENT_BINARY_DIR}/balconyConfig.cmake"
    "${CMAKE_CURRENT_BINARY_DIR}/balconyConfigVersion.cmake"
    "${CMAKE_CURRENT_LIST_DIR}/library_dependencies.cmake"
    "${CMAKE_CURRENT_LIST_DIR}/FindOpenImageIO.cmake"
    "${CMAKE_CURRENT_LIST_DIR}/FindSLEEF.cmake"
    "${CMAKE_CURRENT_LIST_DIR}/FindTurboJPEG.cmake"
    DESTINATION "${package_folder}")

install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" "${PROJECT_SOURCE_DIR}/NOTICE"
    DESTINATION "${CMAKE_INSTALL_DOCDIR}")

# Vim and Neovim read these folders by themselves if the prefix is /usr; editors/README.md describes
# the other cases and VS Code.
install(DIRECTORY "${PROJECT_SOURCE_DIR}/editors/vim/" DESTINATION "${CMAKE_INSTALL_DATADIR}/vim/vimfiles")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/editors/vim/" DESTINATION "${CMAKE_INSTALL_DATADIR}/nvim/site")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/editors/vscode/"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/balcony/editors/vscode")
install(FILES "${PROJECT_SOURCE_DIR}/editors/README.md"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/balcony/editors")
