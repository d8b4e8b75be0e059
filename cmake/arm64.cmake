# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
#
# The toolchain of the preset arm64: Debian's cross compiler, and libraries of Debian's architecture
# arm64 beside those of this machine. qemu runs the tests.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64)

# PROJ's package file refuses cross compilers, so project() says that this is none.
set(CMAKE_PROJECT_INCLUDE "${CMAKE_CURRENT_LIST_FILE}")
set(CMAKE_CROSSCOMPILING OFF)
