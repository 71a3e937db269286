// Image files, and pixels for the search of a board.
#include <memory>

#include "controller/vision/board/locate.h"
#include "fuzz/kind.h"
#include "sim/app/image_files.h"
#include "sim/app/systems.h"
#include "sim/images/png.h"
#include "sim/plant/height_file.h"
#include "sim/scenario/load_scenario.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

constexpr int kWidth = 128, kHeight = 96;
constexpr std::size_t kPixels = std::size_t{kWidth} * kHeight;

FuzzKind ImageKind() {
  const auto folder = std::make_shared<ScratchFolder>();
  std::vector<std::string> seeds{"P2 3 2 255\n0 1 2\n3 4 255\n", "P5\n# grey\n3 2 255\nabcdef",
                                 "P6 2 1 255\nabcdef"};
  const GrayImage grey{4, 3, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 255}};
  seeds.push_back(EncodePng(grey));
  seeds.push_back(EncodePng(RgbImage{2, 2, grey.pixels}));
  const std::string images = SourceFile("tests/fuzz/images");
  for (const std::string& file : ImageFilesIn(images)) seeds.push_back(Slurp(file));
  return {"image",
          [seeds] { return seeds; },
          {"IHDR",     "IDAT",     "PLTE",     "tRNS", "iCCP", "IEND",     "P5",
           "VP8 ",     "VP8L",     "VP8X",     "ALPH", "ANIM", "\xff\xd8", "\xff\xc0",
           "\xff\xc4", "\xff\xda", "\xff\xd9", "eXIf", "Exif", "II*"},
          [folder](const std::string& bytes) {
            const std::string file = folder->Write("image", bytes);
            DecodePng<GrayImage>(bytes);
            DecodePng<RgbImage>(bytes);
            return ReadOrRefused([&] {
              LoadGray(file);
              IsCutJpeg(file);
            });
          }};
}

/// Each reader of heights, as the program asks it.
FuzzKind HeightsKind() {
  const auto folder = std::make_shared<ScratchFolder>();
  // A TIFF of 2 x 2 numbers of 8 bits in one strip.
  std::string tiff("II*\0\x08\0\0\0\x08\0", 10);
  const auto tag = [&](int id, int type, int value) {
    for (const int half : {id, type, 1, 0, value, 0}) {
      tiff += static_cast<char>(half & 255);
      tiff += static_cast<char>(half >> 8);
    }
  };
  for (const auto& [id, value] : {std::pair(256, 2), {257, 2}, {258, 8}, {259, 1}, {262, 1}}) {
    tag(id, 3, value);
  }
  tag(273, 4, 110);
  tag(278, 3, 2);
  tag(279, 4, 4);
  tiff += std::string(4, '\0') + "abcd";
  const std::vector<std::string> seeds{
      "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 0.5\nNODATA_value -9999\n1 2 3\n-4 "
      "5e-1 "
      "-9999\n",
      EncodePng(GrayImage{4, 3, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 255}}),
      EncodePng(DeepImage{2, 2, 16, {0, 1, 500, 65535}}), tiff};
  return {"heights",
          [seeds] { return seeds; },
          {"ncols", "nrows", "cellsize", "NODATA_value", "IHDR", "IDAT", "II*", "MM", "nan", "1e9"},
          [folder](const std::string& bytes) {
            const char* ending = bytes.starts_with("\x89PNG")                         ? "png"
                                 : bytes.starts_with("II") || bytes.starts_with("MM") ? "tif"
                                                                                      : "asc";
            const std::string file = folder->Write(std::string("heights.") + ending, bytes);
            return ReadOrRefused([&] { LoadHeights({.file = file, .cell_m = 0.5}); });
          }};
}

/// A camera's image from bytes as they come; those that are missing are black.
GrayImage ImageOf(std::string_view bytes) {
  GrayImage image{kWidth, kHeight, {bytes.begin(), bytes.end()}};
  image.pixels.resize(kPixels);
  return image;
}

/// What Axel's controller does with a pair of images, by either pipeline; whether it finds discs.
/// From 1 m a board on so few pixels shows all of them.
FuzzKind PixelsKind() {
  const std::vector<System> systems = Systems();
  const Scenario scenario = LoadScenario(
      SourceFile("scenarios/axel_typical.yaml"),
      {"camera={width_px: 128, height_px: 96}", "start={r_m: 1, alpha_deg: 0, heading_deg: 0}"},
      KnownSystems(systems));
  const System& axel = FindSystem(systems, scenario.system);
  const auto seeds = [axel, scenario] {
    std::string pair;
    for (const CameraImage& image : axel.make_ready(scenario).plant->TakeImages({0, 1}, 0.0)) {
      const auto& pixels = std::get<GrayImage>(image.pixels).pixels;
      pair.append(pixels.begin(), pixels.end());
    }
    return std::vector{pair, pair.substr(0, kPixels)};
  };
  const StereoRig rig = axel.files.rig(scenario.robot_file, kWidth, kHeight).value();
  const FiducialBoard board =
      axel.files.board(SourceFile("models/axel/station/station.yaml")).value().board;
  return {"pixels", seeds, {}, [rig, board](const std::string& bytes) {
            const std::string_view all = bytes;
            StereoImages images{ImageOf(all.substr(0, kPixels)), {}};
            if (all.size() > kPixels) images.right = ImageOf(all.substr(kPixels, kPixels));
            bool found = false;
            for (const auto pipeline : {VisionPipeline::kDockyard, VisionPipeline::kTsai2013}) {
              const VisionSettings settings{.pipeline = pipeline};
              const SightingReport report = LocateBoard(images, rig, board, {}, settings).report;
              found |= report.DetectedBy(0) + report.DetectedBy(1) > 0;
            }
            return found;
          }};
}

}  // namespace

std::vector<NamedKind> ImageKinds() {
  return {{"image", ImageKind}, {"heights", HeightsKind}, {"pixels", PixelsKind}};
}

}  // namespace dockyard
