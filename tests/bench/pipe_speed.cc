#include "bench/pipe_speed.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>

#include "sim/bridge/pipe_controller.h"
#include "sim/log/frame_codec.h"

namespace dockyard {
namespace {

constexpr int kMotors = 4;

double LeastSeconds(PipeController& controller, const SensorFrame& frame, int calls) {
  using Clock = std::chrono::steady_clock;
  double least_s = 1e9;
  for (int i = 0; i < calls; ++i) {
    const Clock::time_point start = Clock::now();
    controller.Step(frame);
    least_s = std::min(least_s, std::chrono::duration<double>(Clock::now() - start).count());
  }
  return least_s;
}

void Send(char kind, const std::string& payload) {
  const auto size = static_cast<std::uint32_t>(payload.size());
  std::fwrite(&size, sizeof size, 1, stdout);
  std::fputc(kind, stdout);
  std::fwrite(payload.data(), 1, payload.size(), stdout);
  std::fflush(stdout);
}

std::string AllBraked() {
  Commands commands;
  commands.motors.assign(kMotors, {.mode = MotorMode::kBrake});
  std::string payload;
  PutCommands(payload, commands);
  return payload;
}

}  // namespace

PipeSpeed TimePipe(const char* program, int width, int height) {
  ControllerGreeting greeting;
  greeting.motor_count = kMotors;
  greeting.camera_count = 2;
  greeting.nominal = Json::object();
  PipeController controller({{program, "peer"}, ".", {}, {}}, greeting, {});
  SensorFrame frame;
  frame.motors.resize(kMotors);
  PipeSpeed speed;
  speed.without_images_s = LeastSeconds(controller, frame, 5000);
  for (int camera = 0; camera < 2; ++camera) {
    GrayImage image;
    image.width = width;
    image.height = height;
    image.pixels.assign(static_cast<std::size_t>(width) * height, 128);
    frame.images.push_back({camera, std::move(image)});
  }
  speed.with_pair_s = LeastSeconds(controller, frame, 500);
  controller.Finish();
  return speed;
}

int RunPeer() {
  std::string payload;
  std::uint32_t size = 0;
  while (std::fread(&size, sizeof size, 1, stdin) == 1) {
    const int kind = std::fgetc(stdin);
    payload.resize(size);
    if (std::fread(payload.data(), 1, size, stdin) != size) return 1;
    if (kind == 'X') return 0;
    if (kind == 'H') Send('H', R"({"protocol": 4})");
    if (kind == 'F') Send('C', AllBraked());
  }
  return 1;
}

}  // namespace dockyard
