#include "sim/log/frame_codec.h"

#include <cmath>
#include <type_traits>
#include <vector>

#include "controller/base/check.h"
#include "controller/base/number_text.h"
#include "sim/images/png.h"

namespace dockyard {
namespace {

enum class PixelKind : std::uint8_t { kGray, kRgb };

void PutVector(std::string& out, const Eigen::Vector3d& value) {
  for (int i = 0; i < 3; ++i) PutDouble(out, value(i));
}

/// A sensor's number. A controller takes for granted that it is finite.
double TakeReading(ByteReader& in) {
  const double value = in.Double();
  if (!std::isfinite(value)) throw DataError("a reading is not a finite number");
  return value;
}

Eigen::Vector3d TakeVector(ByteReader& in) {
  Eigen::Vector3d value;
  for (int i = 0; i < 3; ++i) value(i) = TakeReading(in);
  return value;
}

void PutImage(std::string& out, const CameraImage& image, std::vector<std::string>* pngs) {
  PutU32(out, static_cast<std::uint32_t>(image.camera));
  PutU64(out, static_cast<std::uint64_t>(image.exposed));
  PutDouble(out, image.exposure_s);
  std::visit(
      [&](const auto& pixels) {
        constexpr bool rgb = std::is_same_v<std::decay_t<decltype(pixels)>, RgbImage>;
        const std::size_t count = static_cast<std::size_t>(pixels.width) * pixels.height;
        DOCKYARD_CHECK(pixels.pixels.size() == count * (rgb ? 3 : 1));
        PutU8(out, static_cast<std::uint8_t>(rgb ? PixelKind::kRgb : PixelKind::kGray));
        PutU32(out, static_cast<std::uint32_t>(pixels.width));
        PutU32(out, static_cast<std::uint32_t>(pixels.height));
        if (pngs != nullptr) {
          pngs->push_back(count == 0 ? std::string() : EncodePng(pixels));
        } else {
          PutU32(out, static_cast<std::uint32_t>(pixels.pixels.size()));
          out.append(reinterpret_cast<const char*>(pixels.pixels.data()), pixels.pixels.size());
        }
      },
      image.pixels);
}

/// The bytes of one image, raw or PNG, into pixels of its kind.
template <class Image>
Image TakePixels(std::uint32_t width, std::uint32_t height, std::string_view bytes,
                 ImageCoding coding) {
  constexpr int channels = std::is_same_v<Image, RgbImage> ? 3 : 1;
  Image image;
  image.width = static_cast<int>(width);
  image.height = static_cast<int>(height);
  if (coding == ImageCoding::kRaw || bytes.empty()) {
    image.pixels.assign(bytes.begin(), bytes.end());
  } else if (auto decoded = DecodePng<Image>(bytes)) {
    image = std::move(*decoded);
  }
  const std::size_t wanted = static_cast<std::size_t>(width) * height * channels;
  if (image.pixels.size() != wanted || image.width != static_cast<int>(width) ||
      image.height != static_cast<int>(height)) {
    throw DataError("an image cannot be decoded");
  }
  return image;
}

/// @param png  its PNG; null: the pixels stand in the record
CameraImage TakeImage(ByteReader& in, const std::string* png, std::uint32_t version) {
  constexpr std::uint32_t kLargestSide = 16384;
  CameraImage image;
  image.camera = static_cast<int>(in.U32());
  image.exposed = static_cast<Tick>(in.U64());
  if (version >= 6) image.exposure_s = TakeReading(in);
  const std::uint8_t kind = in.U8();
  const std::uint32_t width = in.U32(), height = in.U32();
  const ImageCoding coding = png != nullptr ? ImageCoding::kBeside : ImageCoding::kRaw;
  const std::string_view bytes = png != nullptr ? *png : in.Take(in.U32());
  if (width > kLargestSide || height > kLargestSide)
    throw DataError("an image is impossibly large");
  if (kind == static_cast<std::uint8_t>(PixelKind::kGray)) {
    image.pixels = TakePixels<GrayImage>(width, height, bytes, coding);
  } else if (kind == static_cast<std::uint8_t>(PixelKind::kRgb)) {
    image.pixels = TakePixels<RgbImage>(width, height, bytes, coding);
  } else {
    throw DataError("unknown kind of image " + std::to_string(kind));
  }
  return image;
}

/// A count of things that follow; more than any robot has means a damaged log.
std::uint32_t TakeCount(ByteReader& in) {
  constexpr std::uint32_t kMost = 1024;
  const std::uint32_t count = in.U32();
  if (count > kMost) throw DataError("a count of " + std::to_string(count) + " is damaged");
  return count;
}

MotorCommand TakeMotor(ByteReader& in) {
  MotorCommand motor;
  const std::uint8_t mode = in.U8();
  if (mode > static_cast<std::uint8_t>(MotorMode::kPosition)) {
    throw DataError("unknown motor mode " + std::to_string(mode));
  }
  motor.mode = static_cast<MotorMode>(mode);
  motor.target = in.Double();
  motor.speed_limit_rad_s = in.Double();
  motor.accel_rad_s2 = in.Double();
  motor.current_limit_a = in.Double();
  return motor;
}

}  // namespace

void PutFrame(std::string& out, const SensorFrame& frame, ImageCoding coding,
              std::vector<std::string>* pngs) {
  DOCKYARD_CHECK((coding == ImageCoding::kBeside) == (pngs != nullptr));
  PutU64(out, static_cast<std::uint64_t>(frame.tick));
  PutDouble(out, frame.imu.roll_rad);
  PutDouble(out, frame.imu.pitch_rad);
  PutDouble(out, frame.imu.yaw_rad);
  PutVector(out, frame.imu.rate_R);
  PutVector(out, frame.imu.specific_force_R);
  PutU32(out, static_cast<std::uint32_t>(frame.motors.size()));
  for (const MotorReading& motor : frame.motors) {
    PutU64(out, static_cast<std::uint64_t>(motor.encoder_counts));
    PutDouble(out, motor.current_a);
  }
  PutU32(out, static_cast<std::uint32_t>(frame.values.size()));
  for (const double value : frame.values) PutDouble(out, value);
  const bool left_out = coding == ImageCoding::kLeftOut && !frame.images.empty();
  PutU8(out, left_out ? 1 : 0);
  PutU32(out, left_out ? 0 : static_cast<std::uint32_t>(frame.images.size()));
  if (left_out) return;
  for (const CameraImage& image : frame.images) PutImage(out, image, pngs);
}

LoggedFrame TakeFrame(ByteReader& in, ImageCoding coding, const std::vector<std::string>& pngs,
                      std::uint32_t version) {
  LoggedFrame logged;
  SensorFrame& frame = logged.frame;
  frame.tick = static_cast<Tick>(in.U64());
  frame.imu.roll_rad = TakeReading(in);
  frame.imu.pitch_rad = TakeReading(in);
  frame.imu.yaw_rad = TakeReading(in);
  frame.imu.rate_R = TakeVector(in);
  frame.imu.specific_force_R = TakeVector(in);
  frame.motors.resize(TakeCount(in));
  for (MotorReading& motor : frame.motors) {
    motor.encoder_counts = static_cast<std::int64_t>(in.U64());
    motor.current_a = TakeReading(in);
  }
  frame.values.resize(TakeCount(in));
  for (double& value : frame.values) value = version >= 6 ? TakeReading(in) : in.U8();
  const std::uint8_t left_out = in.U8();
  if (left_out > 1) throw DataError("unknown kind of images " + std::to_string(left_out));
  logged.images_left_out = left_out == 1;
  const std::uint32_t images = TakeCount(in);
  const bool beside = coding == ImageCoding::kBeside;
  if (beside && pngs.size() != images) throw DataError("a frame's images are missing");
  for (std::uint32_t i = 0; i < images; ++i) {
    frame.images.push_back(TakeImage(in, beside ? &pngs[i] : nullptr, version));
  }
  return logged;
}

void PutCommands(std::string& out, const Commands& commands) {
  PutU32(out, static_cast<std::uint32_t>(commands.motors.size()));
  for (const MotorCommand& motor : commands.motors) {
    PutU8(out, static_cast<std::uint8_t>(motor.mode));
    PutDouble(out, motor.target);
    PutDouble(out, motor.speed_limit_rad_s);
    PutDouble(out, motor.accel_rad_s2);
    PutDouble(out, motor.current_limit_a);
  }
  PutU32(out, static_cast<std::uint32_t>(commands.take_images.size()));
  for (const int camera : commands.take_images) PutU32(out, static_cast<std::uint32_t>(camera));
  PutU32(out, static_cast<std::uint32_t>(commands.switches.size()));
  for (const std::uint8_t on : commands.switches) PutU8(out, on);
  PutU8(out, static_cast<std::uint8_t>(commands.verdict));
  PutDouble(out, commands.exposure_stops);
}

Commands TakeCommands(ByteReader& in) {
  Commands commands;
  commands.motors.resize(TakeCount(in));
  for (MotorCommand& motor : commands.motors) motor = TakeMotor(in);
  commands.take_images.resize(TakeCount(in));
  for (int& camera : commands.take_images) camera = static_cast<int>(in.U32());
  commands.switches.resize(TakeCount(in));
  for (std::uint8_t& on : commands.switches) on = in.U8();
  const std::uint8_t verdict = in.U8();
  if (verdict > static_cast<std::uint8_t>(Verdict::kGivenUp)) {
    throw DataError("unknown verdict " + std::to_string(verdict));
  }
  commands.verdict = static_cast<Verdict>(verdict);
  commands.exposure_stops = in.Double();
  if (!(std::abs(commands.exposure_stops) <= kMostExposure_stops)) {
    throw DataError("an exposure must lie within " + NumberText(kMostExposure_stops) +
                    " stops of the cameras' own");
  }
  return commands;
}

}  // namespace dockyard
