# Untested; see packaging/README.md.
class Balcony < Formula
  desc "Rendering through extended cameras"
  homepage "https://balcony.invalid"
  url "https://balcony.invalid/balcony-0.1.0.tar.gz"
  sha256 "0" * 64
  license "Apache-2.0"

  depends_on "boost" => :build
  depends_on "cli11" => :build
  depends_on "cmake" => :build
  depends_on "eigen" => :build
  depends_on "ninja" => :build
  depends_on "tomlplusplus" => :build
  depends_on "embree"
  depends_on "fmt"
  depends_on "highway"
  depends_on "imath"
  depends_on :linux
  depends_on "nlohmann-json"
  depends_on "openexr"
  depends_on "jpeg-turbo"
  depends_on "libpng"
  depends_on "openimageio"
  depends_on "proj"
  depends_on "sleef"
  depends_on "tbb"
  depends_on "yaml-cpp"

  def install
    system "cmake", "-S", ".", "-B", "build", "-G", "Ninja", "-DBUILD_TESTING=OFF",
                    "-DBALCONY_BENCH=OFF", "-DBALCONY_PYTHON=OFF", *std_cmake_args
    system "cmake", "--build", "build"
    system "cmake", "--install", "build"
  end

  test do
    system bin/"balcony", "demo", "--size", "60x12"
    assert_path_exists testpath/"gallery.png"
  end
end
