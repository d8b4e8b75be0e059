# The target public_headers, which only .ci/run builds: every public header compiles first and alone,
# without private headers.
file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}/include"
    "${PROJECT_SOURCE_DIR}/include/*.hpp")
set(sources "")
foreach(header IN LISTS headers)
    string(MAKE_C_IDENTIFIER "${header}" name)
    file(CONFIGURE OUTPUT "${CMAKE_BINARY_DIR}/public_headers/${name}.cpp" @ONLY CONTENT "#include \"@header@\"\n")
    list(APPEND sources "${CMAKE_BINARY_DIR}/public_headers/${name}.cpp")
endforeach()
add_library(public_headers OBJECT EXCLUDE_FROM_ALL ${sources})
target_include_directories(public_headers PRIVATE "${PROJECT_SOURCE_DIR}/include")
target_link_libraries(public_headers PRIVATE balcony_options Imath::Imath)
