// Time of a call of a controller in another process, beside the controller's own.
#pragma once

namespace dockyard {

/// Wall time [s] of a call, the least of many: the program at the other end answers at once.
struct PipeSpeed {
  double without_images_s = 0.0, with_pair_s = 0.0;
};

/// `program` answers on its standard streams when called with the word "peer" (RunPeer).
/// @param width, height  pixels of each image of the pair
PipeSpeed TimePipe(const char* program, int width, int height);

/// The other end: reads each message whole and brakes all motors. Returns the exit code.
int RunPeer();

}  // namespace dockyard
