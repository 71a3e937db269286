// The sensor: from light on it to numbers. Linear; no gamma.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "controller/base/check.h"
#include "controller/base/two_widths.h"
#include "render/exposure_rule.h"
#include "render/frame_grabber.h"
#include "render/kept_sensor.h"
#include "render/optics.h"
#include "render/pixel_defects.h"
#include "render/pixel_noise.h"
#include "render/shading.h"
#include "render/stereo_renderer.h"
#include "render/video_fields.h"
#include "render/window.h"

namespace dockyard {
namespace {

// Below this many electrons the Poisson law is drawn itself, above it as the normal law of the same
// mean and variance: its skewness, 1 / sqrt(mean), is 0.14 there.
constexpr float kFewElectrons = 50.0f;

void CheckSensor(const SensorOptions& s) {
  DOCKYARD_CHECK(s.full_well_e > 0.0 && std::isfinite(s.full_well_e));
  DOCKYARD_CHECK(s.read_noise_e >= 0.0 && std::isfinite(s.read_noise_e));
  DOCKYARD_CHECK(s.response_sigma >= 0.0 && s.response_sigma <= 0.2);
  DOCKYARD_CHECK(s.bits >= 8 && s.bits <= 16);
  DOCKYARD_CHECK(s.exposure_percent > 0.0 && s.exposure_percent < 100.0);
  DOCKYARD_CHECK(s.target_level > 0.0 && s.target_level <= 1.0);
  DOCKYARD_CHECK(s.fixed_exposure_e >= 0.0 && std::isfinite(s.fixed_exposure_e));
  DOCKYARD_CHECK(std::abs(s.exposure_stops) <= 16.0);
  DOCKYARD_CHECK(s.video.noise_share >= 0.0 && s.video.noise_share <= 0.2);
  DOCKYARD_CHECK(s.video.line_jitter_px >= 0.0 && s.video.line_jitter_px <= 5.0);
  DOCKYARD_CHECK(s.defects.hot_share >= 0.0 && s.defects.hot_share <= 0.5);
  DOCKYARD_CHECK(s.defects.dead_share >= 0.0 && s.defects.dead_share <= 0.5);
  DOCKYARD_CHECK(s.defects.hot_dark_e >= 0.0 && s.defects.hot_offset_e >= 0.0);
  CheckOptics(s);
  for (const WindowOptions& window : s.windows) CheckWindow(window);
}

// The stream of the pixels' responses.
std::uint64_t PatternOf(const SensorOptions& s, int view) {
  return SplitMix(s.pattern_key, static_cast<std::uint64_t>(view));
}

// `view` is that of a grey image, or 2 + 3 times it and the channel: of a colour camera.
int CameraOfView(int view) { return view < 2 ? view : (view - 2) / 3; }

VideoKeys VideoKeysOf(const SensorOptions& s, int view, std::uint64_t noise_key) {
  constexpr std::uint64_t kLines = 0x6c696e6573, kNoise = 0x766964656f;
  const int camera = CameraOfView(view);
  return {.lines = SplitMix(SplitMix(s.noise_key, kLines), static_cast<std::uint64_t>(camera)),
          .noise = SplitMix(noise_key, kNoise)};
}

// responses: of the pixels, or null where those are to be found.
DOCKYARD_TWO_WIDTHS
DeepImage Digitise(const RadianceImage& image, double gain_e, const SensorOptions& s, int view,
                   std::uint64_t key, const float* responses = nullptr) {
  constexpr std::size_t kAtOnce = 64;
  DeepImage out{.width = image.width, .height = image.height, .bits = s.bits, .pixels = {}};
  out.pixels.resize(image.values.size());
  const auto gain = static_cast<float>(gain_e);
  const auto read_noise = static_cast<float>(s.read_noise_e);
  const auto read_variance = read_noise * read_noise;
  const auto most = static_cast<float>((1 << s.bits) - 1);
  const auto levels_per_e = static_cast<float>(most / s.full_well_e);
  const auto sigma = static_cast<float>(s.response_sigma);
  const std::uint64_t pattern = PatternOf(s, view);
  // All channels of a colour image share their defects.
  const std::uint64_t defects = PatternOf(s, CameraOfView(view));
  const bool direct = IsDirect(s.video);
  std::vector<float> signal(direct ? 0 : out.pixels.size());  // into the frame grabber
  float electrons[kAtOnce], normal[kAtOnce], noisy[kAtOnce];
  for (std::size_t first = 0; first < out.pixels.size(); first += kAtOnce) {
    const std::size_t count = std::min(kAtOnce, out.pixels.size() - first);
    const float* light = &image.values[first];
    for (std::size_t i = 0; i < count; ++i) electrons[i] = std::max(gain * light[i], 0.0f);
    if (sigma > 0.0f && responses) {
      for (std::size_t i = 0; i < count; ++i) electrons[i] *= responses[first + i];
    } else if (sigma > 0.0f) {
      for (std::size_t i = 0; i < count; ++i) {
        electrons[i] *= std::max(1.0f + sigma * HashNormal(pattern, first + i), 0.0f);
      }
    }
    if (HasDefects(s.defects)) AddDefects(s.defects, defects, first, count, electrons);
    for (std::size_t i = 0; i < count; ++i) normal[i] = HashNormal(key, first + i);
    for (std::size_t i = 0; i < count; ++i) {
      noisy[i] = electrons[i] + std::sqrt(electrons[i] + read_variance) * normal[i];
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (electrons[i] >= kFewElectrons) continue;
      noisy[i] = DrawPoisson(electrons[i], key, first + i) + read_noise * normal[i];
    }
    if (!direct) {
      std::copy_n(noisy, count, &signal[first]);
      continue;
    }
    std::uint16_t* pixels = &out.pixels[first];
    for (std::size_t i = 0; i < count; ++i) {
      const float level = noisy[i] * levels_per_e + 0.5f;
      pixels[i] = static_cast<std::uint16_t>(std::min(std::max(level, 0.0f), most));
    }
  }
  if (!direct) {
    out.pixels =
        Grabbed(signal, image.width, s.full_well_e, s.bits, s.video, VideoKeysOf(s, view, key));
  }
  return out;
}

const Camera& CameraOf(const StereoRig& rig, int view) { return view == 0 ? rig.left : rig.right; }

// Light on the sensor of the left (0) or right (1) camera.
RadianceImage ThroughLens(RadianceImage image, const Camera& camera, const SensorOptions& sensor,
                          int view, const RadianceImage* falloff = nullptr) {
  DOCKYARD_CHECK(image.width == camera.width && image.height == camera.height);
  DOCKYARD_CHECK(image.values.size() == static_cast<std::size_t>(camera.width) * camera.height);
  if (sensor.eyes[view] == EyeState::kSilent) return {};
  ApplyWindow(camera, sensor.windows[view], image);
  if (sensor.eyes[view] == EyeState::kDark) {
    std::fill(image.values.begin(), image.values.end(), 0.0f);
  }
  ApplyOptics(camera, sensor, image, falloff);
  return image;
}

std::array<RadianceImage, 2> ThroughLens(std::array<RadianceImage, 2> images, const StereoRig& rig,
                                         const SensorOptions& sensor) {
  for (int view = 0; view < 2; ++view) {
    images[view] = ThroughLens(std::move(images[view]), CameraOf(rig, view), sensor, view);
  }
  return images;
}

GrayImage UpperBits(const DeepImage& deep) {
  GrayImage image{.width = deep.width, .height = deep.height, .pixels = {}};
  image.pixels.resize(deep.pixels.size());
  const int shift = deep.bits - 8;
  const std::size_t count = deep.pixels.size();
  const std::uint16_t* __restrict from = deep.pixels.data();
  std::uint8_t* __restrict to = image.pixels.data();
  for (std::size_t i = 0; i < count; ++i) to[i] = static_cast<std::uint8_t>(from[i] >> shift);
  return image;
}

// Of the light on the sensors.
std::array<DeepImage, 2> DigitisePair(const std::array<RadianceImage, 2>& images,
                                      const SensorOptions& sensor, KeptExposure* before = nullptr) {
  const double gain = ElectronsOfRadiance(images, sensor, before);
  return {Digitise(images[0], gain, sensor, 0, SplitMix(sensor.noise_key, 0)),
          Digitise(images[1], gain, sensor, 1, SplitMix(sensor.noise_key, 1))};
}

// Of one camera that keeps its responses.
GrayImage DigitiseKept(const RadianceImage& image, const SensorOptions& sensor, KeptSensor& kept,
                       KeptExposure* before) {
  const auto sigma = static_cast<float>(sensor.response_sigma);
  const std::vector<float>& responses =
      kept.Responses(PatternOf(sensor, 0), sigma, image.values.size());
  return UpperBits(Digitise(image, ElectronsOfRadiance({&image, 1}, sensor, before), sensor, 0,
                            SplitMix(sensor.noise_key, 0), responses.data()));
}

}  // namespace

std::array<DeepImage, 2> ExposeDeep(std::array<RadianceImage, 2> radiance, const StereoRig& rig,
                                    const SensorOptions& sensor) {
  CheckSensor(sensor);
  return DigitisePair(ThroughLens(std::move(radiance), rig, sensor), sensor);
}

StereoImages ExposeFields(std::array<StereoRadiance, 2> fields, const StereoRig& rig,
                          const SensorOptions& sensor, KeptExposure* before) {
  CheckSensor(sensor);
  StereoRadiance even = ThroughLens(std::move(fields[0]), rig, sensor);
  const StereoRadiance odd = ThroughLens(std::move(fields[1]), rig, sensor);
  for (int view = 0; view < 2; ++view) even[view] = Interlaced(std::move(even[view]), odd[view]);
  const std::array<DeepImage, 2> deep = DigitisePair(even, sensor, before);
  return {.left = UpperBits(deep[0]), .right = UpperBits(deep[1])};
}

DeepImage ExposeOne(RadianceImage radiance, const Camera& camera, const SensorOptions& sensor) {
  CheckSensor(sensor);
  const RadianceImage image = ThroughLens(std::move(radiance), camera, sensor, 0);
  return Digitise(image, ElectronsOfRadiance({&image, 1}, sensor), sensor, 0,
                  SplitMix(sensor.noise_key, 0));
}

GrayImage ExposeGrey(RadianceImage radiance, const Camera& camera, const SensorOptions& sensor) {
  return UpperBits(ExposeOne(std::move(radiance), camera, sensor));
}

GrayImage ExposeGrey(RadianceImage radiance, const Camera& camera, const SensorOptions& sensor,
                     KeptSensor& kept, KeptExposure* before) {
  CheckSensor(sensor);
  const RadianceImage& falloff = kept.Falloff(camera, sensor.vignetting_exponent);
  return DigitiseKept(ThroughLens(std::move(radiance), camera, sensor, 0, &falloff), sensor, kept,
                      before);
}

GrayImage ExposeFields(std::array<RadianceImage, 2> fields, const Camera& camera,
                       const SensorOptions& sensor, KeptSensor& kept, KeptExposure* before) {
  CheckSensor(sensor);
  const RadianceImage& falloff = kept.Falloff(camera, sensor.vignetting_exponent);
  for (RadianceImage& field : fields) {
    field = ThroughLens(std::move(field), camera, sensor, 0, &falloff);
  }
  return DigitiseKept(Interlaced(std::move(fields[0]), fields[1]), sensor, kept, before);
}

StereoImages ExposeStereo(std::array<RadianceImage, 2> radiance, const StereoRig& rig,
                          const SensorOptions& sensor, KeptExposure* before) {
  CheckSensor(sensor);
  const std::array<DeepImage, 2> deep =
      DigitisePair(ThroughLens(std::move(radiance), rig, sensor), sensor, before);
  return {.left = UpperBits(deep[0]), .right = UpperBits(deep[1])};
}

std::array<std::array<DeepImage, 3>, 2> ExposeColour(
    const std::array<std::array<RadianceImage, 3>, 2>& radiance, const StereoRig& rig,
    const SensorOptions& sensor) {
  CheckSensor(sensor);
  std::array<std::array<RadianceImage, 2>, 3> seen;  // by channel, then camera
  for (int channel = 0; channel < 3; ++channel) {
    seen[channel] = ThroughLens({radiance[0][channel], radiance[1][channel]}, rig, sensor);
  }
  // Exposed as the grey image would be.
  const Eigen::Vector3d share = ChannelWeights(Channel::kGrey);
  std::array<RadianceImage, 2> grey = seen[0];
  for (int view = 0; view < 2; ++view) {
    for (std::size_t i = 0; i < grey[view].values.size(); ++i) {
      grey[view].values[i] = static_cast<float>(share[0] * seen[0][view].values[i] +
                                                share[1] * seen[1][view].values[i] +
                                                share[2] * seen[2][view].values[i]);
    }
  }
  const double gain = ElectronsOfRadiance(grey, sensor);
  std::array<std::array<DeepImage, 3>, 2> out;
  for (int view = 0; view < 2; ++view) {
    for (int channel = 0; channel < 3; ++channel) {
      const auto stream = static_cast<std::uint64_t>(2 + 3 * view + channel);
      out[view][channel] = Digitise(seen[channel][view], gain, sensor, 2 + 3 * view + channel,
                                    SplitMix(sensor.noise_key, stream));
    }
  }
  return out;
}

}  // namespace dockyard
