# Untested; see packaging/README.md.
{ lib, stdenv, cmake, ninja, boost, cli11, eigen, embree, fmt, imath, libhwy, libjpeg_turbo, nlohmann_json
, openexr, libpng, openimageio, proj, sleef, tbb, tomlplusplus
, yaml-cpp }:

stdenv.mkDerivation {
  pname = "balcony";
  version = "0.1.0";
  src = lib.cleanSource ../..;

  nativeBuildInputs = [ cmake ninja ];
  buildInputs = [
    boost cli11 eigen embree fmt imath libhwy libjpeg_turbo nlohmann_json openexr libpng openimageio proj
    sleef tbb tomlplusplus yaml-cpp
  ];
  cmakeFlags = [ "-DBUILD_TESTING=OFF" "-DBALCONY_BENCH=OFF" "-DBALCONY_PYTHON=OFF" ];

  meta = {
    description = "Rendering through extended cameras";
    license = lib.licenses.asl20;
    mainProgram = "balcony";
    platforms = lib.platforms.linux;
  };
}
